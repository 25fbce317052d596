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

#include "collision/YamlFile.h"

#include <cmath>
#include <vector>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/collision/Scene.h"
#include "text/NumberText.h"

namespace ompl_mfa::collision
{
    namespace
    {
        std::string listed(const YamlFile::Names &names)
        {
            std::string text;
            for (const std::string &name : names)
            {
                text += (text.empty() ? "" : ", ") + name;
            }
            return text;
        }
    }  // namespace

    YamlFile::YamlFile(std::filesystem::path file, std::string what)
      : file_(std::move(file))
      , what_(std::move(what))
    {
    }

    YAML::Node YamlFile::message() const
    {
        std::vector<YAML::Node> messages;
        try
        {
            for (const YAML::Node &document : YAML::LoadAllFromFile(file_.string()))
            {
                if (document && !document.IsNull())
                {
                    messages.push_back(document);
                }
            }
        }
        catch (const YAML::BadFile &)
        {
            throw InputError(file_.string() + ": " + what_ + " not found or not readable");
        }
        catch (const YAML::ParserException &error)
        {
            throw InputError(place(error.mark) + ": malformed YAML: " + error.msg);
        }
        if (messages.empty())
        {
            throw InputError(file_.string() + ": " + what_ + " is empty");
        }
        if (messages.size() > 1)
        {
            fail(messages[1], "the file holds " + std::to_string(messages.size()) + " messages; accepted is one");
        }
        return messages.front();
    }

    std::filesystem::path YamlFile::folder() const
    {
        return file_.parent_path();
    }

    std::string YamlFile::place(const YAML::Mark &mark) const
    {
        return file_.string() + (mark.is_null() ? "" : ":" + std::to_string(mark.line + 1));
    }

    std::string YamlFile::place(const YAML::Node &node) const
    {
        return place(node.Mark());
    }

    void YamlFile::fail(const YAML::Node &node, const std::string &fault) const
    {
        throw InputError(place(node) + ": " + fault);
    }

    void YamlFile::checkKeys(const YAML::Node &map, const std::string &what, const Names &accepted) const
    {
        if (!map.IsMap())
        {
            fail(map, what + " must be a map of keys and values");
        }
        Names seen;
        for (const auto &entry : map)
        {
            const std::string key = entry.first.as<std::string>("");
            if (accepted.count(key) == 0)
            {
                fail(entry.first, what + " has an unknown key '" + key + "'; accepted are " + listed(accepted));
            }
            if (!seen.insert(key).second)
            {
                fail(entry.first, what + " has the key '" + key + "' twice");
            }
        }
    }

    bool YamlFile::has(const YAML::Node &map, const std::string &key)
    {
        const YAML::Node value = map[key];
        return value && !value.IsNull();
    }

    YAML::Node YamlFile::required(const YAML::Node &map, const std::string &key) const
    {
        if (!has(map, key))
        {
            fail(map, "key '" + key + "' is missing or empty");
        }
        return map[key];
    }

    YAML::Node YamlFile::list(const YAML::Node &map, const std::string &key, const std::string &name) const
    {
        if (!has(map, key))
        {
            return YAML::Node(YAML::NodeType::Sequence);
        }
        const YAML::Node value = map[key];
        if (!value.IsSequence())
        {
            fail(value, name + " must be a list");
        }
        return value;
    }

    std::string YamlFile::text(const YAML::Node &map, const std::string &key) const
    {
        if (!has(map, key))
        {
            return "";
        }
        const YAML::Node value = map[key];
        if (!value.IsScalar())
        {
            fail(value, key + " must be a name");
        }
        return value.Scalar();
    }

    double YamlFile::number(const YAML::Node &node, const std::string &key) const
    {
        double value = 0.;
        if (!node.IsScalar() || !text::readNumber(node.Scalar(), value) || !std::isfinite(value))
        {
            fail(node, key + (node.IsScalar() ? " = " + node.Scalar() : "") + ": must be a finite number");
        }
        if (std::abs(value) > LARGEST_COORDINATE)
        {
            fail(node, key + " = " + node.Scalar() + ": must not exceed 1e30, of which distances overflow");
        }
        return value;
    }
}  // namespace ompl_mfa::collision
