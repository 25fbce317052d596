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

#ifndef OMPL_MFA_ROBOTS_XML_FILE_
#define OMPL_MFA_ROBOTS_XML_FILE_

#include <filesystem>
#include <functional>
#include <string>

#include <tinyxml2.h>

namespace ompl_mfa::robots
{
    /** \brief An XML file that describes a robot. Errors are InputErrors that name the file and the line. */
    class XmlFile
    {
    public:
        /** \param what what the file is to be, for messages.
            \throw InputError if the file is missing, malformed, a xacro file, or its root element is not `robot`. */
        XmlFile(std::filesystem::path file, const std::string &what);

        const tinyxml2::XMLElement &root() const
        {
            return *document_.RootElement();
        }

        const std::string &text() const
        {
            return text_;
        }

        /** \brief File and line of an element. */
        std::string place(const tinyxml2::XMLElement &element) const;

        [[noreturn]] void fail(const tinyxml2::XMLElement &element, const std::string &fault) const;

        /** \brief An attribute that must not be missing or empty. */
        std::string required(const tinyxml2::XMLElement &element, const char *attribute) const;

        /** \brief An attribute; empty if it is missing. */
        static std::string attribute(const tinyxml2::XMLElement &element, const char *name);

        /** \brief Call `visit` for each child element with this name. */
        static void forEach(const tinyxml2::XMLElement &parent, const char *name,
                            const std::function<void(const tinyxml2::XMLElement &)> &visit);

        /** \brief The child with the attribute `name` of this value; null if there is none. */
        static const tinyxml2::XMLElement *findNamed(const tinyxml2::XMLElement &parent, const char *element,
                                                     const std::string &name);

    private:
        void refuseXacro(const tinyxml2::XMLElement &element) const;

        std::filesystem::path file_;
        std::string text_;
        tinyxml2::XMLDocument document_;
    };
}  // namespace ompl_mfa::robots

#endif
