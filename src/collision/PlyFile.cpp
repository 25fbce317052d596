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

#include "collision/PlyFile.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // A number or, if a size for its length is given, a list. Sizes are in bytes.
        struct Property
        {
            std::size_t lengthSize{0};
            std::size_t size{0};
        };

        struct Element
        {
            std::string name;
            std::size_t count{0};
            std::vector<Property> properties;
        };

        // 0 for an unknown type.
        std::size_t sizeOf(const std::string &type)
        {
            struct Type
            {
                const char *name;
                const char *otherName;
                std::size_t size;
            };
            constexpr std::array<Type, 8> TYPES{{{"char", "int8", 1},
                                                 {"uchar", "uint8", 1},
                                                 {"short", "int16", 2},
                                                 {"ushort", "uint16", 2},
                                                 {"int", "int32", 4},
                                                 {"uint", "uint32", 4},
                                                 {"float", "float32", 4},
                                                 {"double", "float64", 8}}};
            for (const Type &known : TYPES)
            {
                if (type == known.name || type == known.otherName)
                {
                    return known.size;
                }
            }
            return 0;
        }

        // The next line that is not blank, with Unix, Windows or classic Mac line ends. Lines of a header are short.
        bool nextLine(std::istream &stream, std::string &line)
        {
            constexpr std::size_t LONGEST = 4096;
            line.clear();
            for (int byte = stream.get(); stream && line.size() < LONGEST; byte = stream.get())
            {
                if (byte != '\n' && byte != '\r')
                {
                    line += static_cast<char>(byte);
                    continue;
                }
                if (byte == '\r' && stream.peek() == '\n')
                {
                    stream.get();
                }
                if (line.find_first_not_of(" \t") != std::string::npos)
                {
                    return true;
                }
                line.clear();
            }
            stream.clear();
            return line.size() < LONGEST && line.find_first_not_of(" \t") != std::string::npos;
        }

        class PlyReader
        {
        public:
            explicit PlyReader(const std::filesystem::path &file)
              : stream_(file, std::ios::binary)
              , bytesLeft_(std::filesystem::file_size(file))
            {
            }

            // False for a file of another kind or without the end of a header, which assimp reports.
            bool readHeader()
            {
                std::string line;
                if (!nextLine(stream_, line) || line.compare(0, 3, "ply") != 0)
                {
                    return false;
                }
                while (nextLine(stream_, line))
                {
                    std::istringstream words(line);
                    std::string keyword;
                    words >> keyword;
                    if (keyword == "end_header")
                    {
                        bytesLeft_ -= static_cast<std::size_t>(std::max<std::streamoff>(stream_.tellg(), 0));
                        return true;
                    }
                    if (keyword == "format")
                    {
                        words >> format_;
                    }
                    else if (keyword == "element")
                    {
                        readElement(words);
                    }
                    else if (keyword == "property" && !elements_.empty())
                    {
                        readProperty(words);
                    }
                }
                return false;
            }

            const std::vector<Element> &elements() const
            {
                return elements_;
            }

            // The first element that is incomplete; null if the file is complete.
            const Element *firstCutElement()
            {
                for (const Element &element : elements_)
                {
                    if (!(format_ == "ascii" ? skipLines(element) : skipBytes(element)))
                    {
                        return &element;
                    }
                }
                return nullptr;
            }

        private:
            void readElement(std::istringstream &words)
            {
                Element element;
                std::string count;
                words >> element.name >> count;
                text::readNumber(count, element.count);
                elements_.push_back(element);
            }

            void readProperty(std::istringstream &words)
            {
                Property property;
                std::string type;
                words >> type;
                if (type == "list")
                {
                    words >> type;
                    property.lengthSize = sizeOf(type);
                    words >> type;
                }
                property.size = sizeOf(type);
                elements_.back().properties.push_back(property);
            }

            bool skipLines(const Element &element)
            {
                for (std::size_t i = 0; i < element.count; ++i)
                {
                    // A line may be longer than nextLine() accepts.
                    stream_ >> std::ws;
                    if (stream_.peek() == std::istream::traits_type::eof())
                    {
                        return false;
                    }
                    for (int byte = stream_.get(); stream_ && byte != '\n' && byte != '\r';)
                    {
                        byte = stream_.get();
                    }
                }
                return true;
            }

            bool skipBytes(const Element &element)
            {
                const bool takesSpace =
                    std::any_of(element.properties.begin(), element.properties.end(),
                                [](const Property &property) { return property.size > 0 || property.lengthSize > 0; });
                for (std::size_t i = 0; takesSpace && i < element.count; ++i)
                {
                    for (const Property &property : element.properties)
                    {
                        const std::size_t length = property.lengthSize > 0 ? readLength(property.lengthSize) : 1;
                        if (!stream_ || length > bytesLeft_ || length * property.size > bytesLeft_)
                        {
                            return false;
                        }
                        stream_.ignore(static_cast<std::streamsize>(length * property.size));
                        bytesLeft_ -= length * property.size;
                    }
                }
                return true;
            }

            std::size_t readLength(std::size_t size)
            {
                std::array<unsigned char, 8> bytes{};
                stream_.read(reinterpret_cast<char *>(bytes.data()), static_cast<std::streamsize>(size));
                bytesLeft_ -= std::min(size, bytesLeft_);
                std::size_t length = 0;
                for (std::size_t i = 0; i < size; ++i)
                {
                    length = 256 * length + bytes[format_ == "binary_big_endian" ? i : size - 1 - i];
                }
                return length;
            }

            std::ifstream stream_;
            std::size_t bytesLeft_;
            std::string format_;
            std::vector<Element> elements_;
        };
    }  // namespace

    void requireWholePly(const std::filesystem::path &file)
    {
        PlyReader ply(file);
        if (!ply.readHeader())
        {
            return;
        }
        for (const Element &element : ply.elements())
        {
            if (element.name == "tristrips" && element.count > 0)
            {
                throw InputError(file.string() + ": PLY holds " + std::to_string(element.count) +
                                 " triangle strips ('element tristrips'), which cannot be read; accepted are faces "
                                 "('element face')");
            }
        }
        if (const Element *cut = ply.firstCutElement())
        {
            throw InputError(file.string() + ": PLY ends before the " + std::to_string(cut->count) + " of '" +
                             cut->name + "' that its header announces");
        }
    }
}  // namespace ompl_mfa::collision
