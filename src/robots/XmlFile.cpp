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

#include "robots/XmlFile.h"

#include <cstring>
#include <fstream>
#include <sstream>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::robots
{
    XmlFile::XmlFile(std::filesystem::path file, const std::string &what)
      : file_(std::move(file))
    {
        std::ifstream in(file_);
        if (!in || std::filesystem::is_directory(file_))
        {
            throw InputError(file_.string() + ": " + what + " not found or not readable");
        }
        std::ostringstream content;
        content << in.rdbuf();
        text_ = content.str();
        if (document_.Parse(text_.data(), text_.size()) != tinyxml2::XML_SUCCESS)
        {
            throw InputError(file_.string() + ":" + std::to_string(document_.ErrorLineNum()) + ": malformed XML (" +
                             tinyxml2::XMLDocument::ErrorIDToName(document_.ErrorID()) + "); expected a " + what);
        }
        const tinyxml2::XMLElement *root = document_.RootElement();
        if (root == nullptr || std::strcmp(root->Name(), "robot") != 0)
        {
            throw InputError(file_.string() + ": the root element is '" + (root == nullptr ? "" : root->Name()) +
                             "'; expected 'robot', a " + what);
        }
        refuseXacro(*root);
    }

    void XmlFile::refuseXacro(const tinyxml2::XMLElement &element) const
    {
        if (std::strncmp(element.Name(), "xacro:", 6) == 0)
        {
            fail(element, std::string("'") + element.Name() + "': a xacro file is not read; expand it with 'xacro " +
                              file_.filename().string() + " > expanded" + file_.stem().extension().string() + "'");
        }
        for (const auto *child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
        {
            refuseXacro(*child);
        }
    }

    std::string XmlFile::place(const tinyxml2::XMLElement &element) const
    {
        return file_.string() + ":" + std::to_string(element.GetLineNum());
    }

    void XmlFile::fail(const tinyxml2::XMLElement &element, const std::string &fault) const
    {
        throw InputError(place(element) + ": " + fault);
    }

    std::string XmlFile::required(const tinyxml2::XMLElement &element, const char *attribute) const
    {
        std::string value = XmlFile::attribute(element, attribute);
        if (value.empty())
        {
            fail(element, std::string("<") + element.Name() + "> needs the attribute '" + attribute + "'");
        }
        return value;
    }

    std::string XmlFile::attribute(const tinyxml2::XMLElement &element, const char *name)
    {
        const char *value = element.Attribute(name);
        return value == nullptr ? "" : value;
    }

    void XmlFile::forEach(const tinyxml2::XMLElement &parent, const char *name,
                          const std::function<void(const tinyxml2::XMLElement &)> &visit)
    {
        for (const auto *child = parent.FirstChildElement(name); child != nullptr;
             child = child->NextSiblingElement(name))
        {
            visit(*child);
        }
    }

    const tinyxml2::XMLElement *XmlFile::findNamed(const tinyxml2::XMLElement &parent, const char *element,
                                                   const std::string &name)
    {
        const auto *child = parent.FirstChildElement(element);
        while (child != nullptr && attribute(*child, "name") != name)
        {
            child = child->NextSiblingElement(element);
        }
        return child;
    }
}  // namespace ompl_mfa::robots
