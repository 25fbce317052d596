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

#include "collision/YamlOctomap.h"

#include <stdexcept>
#include <string>

#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/collision/OccupancyMap.h"
#include "text/NumberText.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // Bytes as numbers, signed or not.
        std::string readBytes(const YamlFile &yaml, const YAML::Node &list)
        {
            std::string bytes;
            bytes.reserve(list.size());
            for (const YAML::Node &node : list)
            {
                int value = 0;
                if (!node.IsScalar() || !text::readNumber(node.Scalar(), value) || value < -128 || value > 255)
                {
                    const std::string text = node.IsScalar() ? node.Scalar() : "";
                    yaml.fail(node, "octomap.data = " + text + ": must be whole numbers from -128 to 127" +
                                        (text == "..." ? "; the printer cut the list (ros2 topic echo does not "
                                                         "with --full-length)"
                                                       : ""));
                }
                bytes += static_cast<char>(static_cast<unsigned char>(value));
            }
            return bytes;
        }
    }  // namespace

    std::shared_ptr<fcl::CollisionGeometryd> readOctree(const YamlFile &yaml, const YAML::Node &map)
    {
        const std::string nodes = readBytes(yaml, yaml.list(map, "data", "octomap.data"));
        if (nodes.empty())
        {
            return nullptr;
        }
        const std::string type = yaml.text(map, "id");
        if (type != "OcTree")
        {
            yaml.fail(map["id"] ? map["id"] : map,
                      "octomap.id = '" + type + "' is another kind of tree; accepted is OcTree");
        }
        const std::string binary = lowerCase(yaml.text(map, "binary"));
        if (binary != "true" && binary != "false")
        {
            yaml.fail(map["binary"] ? map["binary"] : map, "octomap.binary must be true or false");
        }
        const YAML::Node resolution = yaml.required(map, "resolution");
        const double edge = yaml.number(resolution, "octomap.resolution");
        if (edge <= 0.)
        {
            yaml.fail(resolution, "octomap.resolution = " + resolution.Scalar() + ": must be greater than 0");
        }
        try
        {
            return makeOccupancyMap(nodes, binary == "true", edge);
        }
        catch (const std::invalid_argument &error)
        {
            yaml.fail(map["data"], std::string("octomap.data: ") + error.what());
        }
    }
}  // namespace ompl_mfa::collision
