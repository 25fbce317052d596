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

#ifndef OMPL_MFA_COLLISION_YAML_FILE_
#define OMPL_MFA_COLLISION_YAML_FILE_

#include <array>
#include <filesystem>
#include <set>
#include <string>

#include <Eigen/Core>

#include <yaml-cpp/yaml.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::collision
{
    /** \brief A YAML file with one message, and checked access to its fields. Errors are InputErrors that name the
        file, the line and the key. */
    class OMPL_MFA_EXPORT YamlFile
    {
    public:
        using Names = std::set<std::string>;

        /** \param file file of the message; not read yet.
            \param what what the file should be, for errors. */
        explicit YamlFile(std::filesystem::path file, std::string what = "planning scene");

        /** \brief The message. Document separators (`---`) may precede and follow it. Throws if there is no message or
            more than one. */
        YAML::Node message() const;

        /** \brief The folder of the file. */
        std::filesystem::path folder() const;

        /** \brief File and line, for an error or a warning. */
        std::string place(const YAML::Node &node) const;

        [[noreturn]] void fail(const YAML::Node &node, const std::string &fault) const;

        /** \brief Throws if `map` is not a map, or has a repeated key or one that is not accepted. */
        void checkKeys(const YAML::Node &map, const std::string &what, const Names &accepted) const;

        /** \brief Whether the map has a value for this key. */
        static bool has(const YAML::Node &map, const std::string &key);

        /** \brief The value of a key; an empty map if there is none. */
        static YAML::Node optional(const YAML::Node &map, const std::string &key)
        {
            return has(map, key) ? map[key] : YAML::Node(YAML::NodeType::Map);
        }

        /** \brief The value of a required key. */
        YAML::Node required(const YAML::Node &map, const std::string &key) const;

        /** \brief The list under a key; empty if there is no value. Throws if the value is not a list; the error calls
            the key `name`. */
        YAML::Node list(const YAML::Node &map, const std::string &key, const std::string &name) const;

        YAML::Node list(const YAML::Node &map, const std::string &key) const
        {
            return list(map, key, key);
        }

        /** \brief The text under a key; empty if there is no value. */
        std::string text(const YAML::Node &map, const std::string &key) const;

        /** \brief A finite number of at most LARGEST_COORDINATE. */
        double number(const YAML::Node &node, const std::string &key) const;

        /** \brief Numbers given as a list or as a map of components. */
        template <int Size>
        Eigen::Matrix<double, Size, 1> vector(const YAML::Node &node, const std::string &key,
                                              const std::array<const char *, Size> &names) const
        {
            if (!node.IsMap() && !(node.IsSequence() && node.size() == Size))
            {
                fail(node, key + " must have " + std::to_string(Size) + " components");
            }
            if (node.IsMap())
            {
                checkKeys(node, key, Names(names.begin(), names.end()));
            }
            Eigen::Matrix<double, Size, 1> result;
            for (std::size_t i = 0; i < Size; ++i)
            {
                result[static_cast<int>(i)] =
                    number(node.IsMap() ? required(node, names[i]) : node[i], key + "." + names[i]);
            }
            return result;
        }

    private:
        std::string place(const YAML::Mark &mark) const;

        std::filesystem::path file_;
        std::string what_;
    };
}  // namespace ompl_mfa::collision

#endif
