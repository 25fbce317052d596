/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#include "ompl_mfa/collision/OccupancyMap.h"

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include <octomap/octomap.h>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/collision/Scene.h"
#include "text/NumberText.h"

namespace ompl_mfa::collision
{
    namespace
    {
        const std::string BINARY_HEADER = "# Octomap OcTree binary file";
        const std::string FULL_HEADER = "# Octomap OcTree file";
        constexpr unsigned int TREE_DEPTH = 16;

        // OctoMap itself reads past the end of a truncated file and recurses to any depth in a corrupt one. So the
        // nodes are traversed first by their lists of children alone.
        class NodeWalk
        {
        public:
            NodeWalk(const std::string &content, std::size_t position, bool binary)
              : content_(content)
              , position_(position)
              , binary_(binary)
            {
            }

            // Counts nodes; false if the file ends early or a branch is deeper than OctoMap allows.
            bool walk(unsigned int depth = 0)
            {
                ++nodes_;
                return binary_ ? walkBinary(depth) : walkFull(depth);
            }

            std::size_t nodes() const
            {
                return nodes_;
            }

            // Position of the traversal in the content.
            std::size_t position() const
            {
                return position_;
            }

        private:
            bool walkBinary(unsigned int depth)
            {
                if (position_ + 2 > content_.size() || depth >= TREE_DEPTH)
                {
                    return false;
                }
                const unsigned int bits = byte(position_) | (byte(position_ + 1) << 8U);
                position_ += 2;
                for (unsigned int child = 0; child < 8; ++child)
                {
                    const unsigned int state = (bits >> (2 * child)) & 3U;
                    nodes_ += state == 1 || state == 2 ? 1 : 0;
                    if (state == 3 && !walk(depth + 1))
                    {
                        return false;
                    }
                }
                return true;
            }

            bool walkFull(unsigned int depth)
            {
                if (position_ + sizeof(float) + 1 > content_.size() || depth > TREE_DEPTH)
                {
                    return false;
                }
                const unsigned int children = byte(position_ + sizeof(float));
                position_ += sizeof(float) + 1;
                for (unsigned int child = 0; child < 8; ++child)
                {
                    if (((children >> child) & 1U) != 0 && !walk(depth + 1))
                    {
                        return false;
                    }
                }
                return true;
            }

            unsigned int byte(std::size_t position) const
            {
                return static_cast<unsigned char>(content_[position]);
            }

            const std::string &content_;
            std::size_t position_;
            bool binary_;
            std::size_t nodes_{0};
        };

        struct Header
        {
            bool binary{false};
            std::string id;
            double resolution{0.};
            std::size_t nodes{0};
            std::size_t bodyStart{0};
        };

        [[noreturn]] void fail(const std::filesystem::path &file, std::size_t line, const std::string &fault)
        {
            throw InputError(file.string() + ":" + std::to_string(line) + ": " + fault);
        }

        Header readHeader(const std::string &content, const std::filesystem::path &file)
        {
            std::istringstream stream(content);
            std::string line;
            std::getline(stream, line);
            Header header;
            header.binary = line.compare(0, BINARY_HEADER.size(), BINARY_HEADER) == 0;
            if (!header.binary && line.compare(0, FULL_HEADER.size(), FULL_HEADER) != 0)
            {
                fail(file, 1,
                     "not an OctoMap of version 1.0 or newer: the first line must begin with '" + BINARY_HEADER +
                         "' (.bt) or '" + FULL_HEADER + "' (.ot)");
            }
            for (std::size_t number = 2; std::getline(stream, line); ++number)
            {
                std::istringstream words(line);
                std::string key;
                words >> key;
                if (key == "data")
                {
                    header.bodyStart = static_cast<std::size_t>(stream.tellg());
                    return header;
                }
                std::string value;
                words >> value;
                const bool read = key == "id"     ? !(header.id = value).empty()
                                  : key == "size" ? text::readNumber(value, header.nodes)
                                  : key == "res"  ? text::readNumber(value, header.resolution)
                                                  : key.empty() || key[0] == '#';
                if (!read)
                {
                    fail(file, number,
                         "unusable OctoMap header '" + line.substr(0, 60) +
                             "'; accepted are id and a name, size and a whole number, res and a number, data");
                }
            }
            fail(file, 1, "OctoMap header has no 'data' line");
        }

        // Coordinates reach 2^15 cells from the origin.
        bool isResolution(double value)
        {
            return value > 0. && value <= LARGEST_COORDINATE / 32768.;
        }

        void checkHeader(const Header &header, const std::filesystem::path &file)
        {
            // Old files call the same tree "1".
            if (header.id != "OcTree" && header.id != "1")
            {
                fail(file, 1, "OctoMap holds a tree of type '" + header.id + "'; accepted is OcTree");
            }
            if (!isResolution(header.resolution))
            {
                fail(file, 1, "OctoMap resolution 'res' must be greater than 0 and finite");
            }
        }

        std::shared_ptr<octomap::OcTree> readTree(const std::string &nodes, bool binary, double resolution)
        {
            auto tree = std::make_shared<octomap::OcTree>(resolution);
            std::istringstream body(nodes);
            if (binary)
            {
                tree->readBinaryData(body);
            }
            else
            {
                tree->readData(body);
            }
            return tree;
        }

        bool hasOccupiedCell(const octomap::OcTree &tree)
        {
            for (auto cell = tree.begin_leafs(); cell != tree.end_leafs(); ++cell)
            {
                if (tree.isNodeOccupied(*cell))
                {
                    return true;
                }
            }
            return false;
        }

        // Null if no cell is occupied.
        std::shared_ptr<fcl::OcTree<double>> makeGeometry(const std::shared_ptr<octomap::OcTree> &tree)
        {
            if (!hasOccupiedCell(*tree))
            {
                return nullptr;
            }
            auto map = std::make_shared<fcl::OcTree<double>>(std::shared_ptr<const octomap::OcTree>(tree));
            map->computeLocalAABB();
            return map;
        }
    }  // namespace

    std::shared_ptr<fcl::OcTree<double>> loadOccupancyMap(const std::filesystem::path &file)
    {
        std::ifstream stream(file, std::ios::binary);
        if (!stream || !std::filesystem::is_regular_file(file))
        {
            throw InputError(file.string() + ": OctoMap file not found");
        }
        const std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
        const Header header = readHeader(content, file);
        checkHeader(header, file);
        NodeWalk nodes(content, header.bodyStart, header.binary);
        if (header.nodes > 0 && !nodes.walk())
        {
            throw InputError(file.string() + ": OctoMap is truncated or broken after " + std::to_string(nodes.nodes()) +
                             " of " + std::to_string(header.nodes) + " nodes");
        }
        if (nodes.nodes() != header.nodes)
        {
            throw InputError(file.string() + ": OctoMap has " + std::to_string(nodes.nodes()) +
                             " nodes, its header says size " + std::to_string(header.nodes));
        }
        const std::shared_ptr<octomap::OcTree> tree =
            header.nodes > 0 ? readTree(content.substr(header.bodyStart), header.binary, header.resolution)
                             : std::make_shared<octomap::OcTree>(header.resolution);
        auto map = makeGeometry(tree);
        if (!map)
        {
            throw InputError(file.string() + ": OctoMap has no occupied cell");
        }
        return map;
    }

    std::shared_ptr<fcl::OcTree<double>> makeOccupancyMap(const std::string &nodes, bool binary, double resolution)
    {
        if (!isResolution(resolution))
        {
            throw std::invalid_argument("resolution must be greater than 0 and finite");
        }
        NodeWalk walk(nodes, 0, binary);
        if (!nodes.empty() && !walk.walk())
        {
            throw std::invalid_argument("truncated or broken after " + std::to_string(walk.nodes()) + " nodes");
        }
        if (walk.position() != nodes.size())
        {
            throw std::invalid_argument("has " + std::to_string(nodes.size() - walk.position()) +
                                        " bytes behind its last node");
        }
        return nodes.empty() ? nullptr : makeGeometry(readTree(nodes, binary, resolution));
    }
}  // namespace ompl_mfa::collision
