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

#include "collision/MeshResource.h"

#include <cstdlib>
#include <sstream>

#include "collision/ResourceFolders.h"
#include "ompl_mfa/InputError.h"

namespace ompl_mfa::collision
{
    namespace
    {
        const std::string SCHEME_END = "://";

        int hexDigit(char digit)
        {
            const std::string digits = "0123456789abcdef0123456789ABCDEF";
            const std::size_t at = digits.find(digit);
            return at == std::string::npos ? -1 : static_cast<int>(at % 16);
        }

        // A URL writes a space as %20.
        std::string decoded(const std::string &address)
        {
            std::string text;
            for (std::size_t i = 0; i < address.size(); ++i)
            {
                const bool code = address[i] == '%' && i + 2 < address.size() && hexDigit(address[i + 1]) >= 0 &&
                                  hexDigit(address[i + 2]) >= 0;
                text += code ? static_cast<char>(16 * hexDigit(address[i + 1]) + hexDigit(address[i + 2])) : address[i];
                i += code ? 2 : 0;
            }
            return text;
        }

        Folders placesOfName(const std::filesystem::path &name, const Folders &folders)
        {
            if (name.is_absolute())
            {
                return {name};
            }
            Folders places;
            for (const std::filesystem::path &folder : folders)
            {
                places.push_back(folder / name);
            }
            return places;
        }

        Folders placesInPackage(const std::string &address, const Folders &folders)
        {
            const std::size_t slash = address.find('/');
            const std::string package = address.substr(0, slash);
            const std::string rest = slash == std::string::npos ? "" : address.substr(slash + 1);
            if (package.empty() || rest.empty())
            {
                throw InputError("must be package://PACKAGE/PATH");
            }
            Folders places;
            for (const std::filesystem::path &folder : folders)
            {
                places.push_back(folder / package / rest);
                // With or without a trailing slash.
                if ((folder / "").parent_path().filename() == package)
                {
                    places.push_back(folder / rest);
                }
            }
            return places;
        }

        Folders placesOf(const std::string &resource, const Folders &folders)
        {
            const std::size_t end = resource.find(SCHEME_END);
            if (end == std::string::npos)
            {
                return placesOfName(resource, folders);
            }
            const std::string scheme = resource.substr(0, end);
            const std::string address = decoded(resource.substr(end + SCHEME_END.size()));
            if (scheme == "package")
            {
                return placesInPackage(address, folders);
            }
            if (scheme == "file")
            {
                return placesOfName(address, folders);
            }
            throw InputError("addresses of kind '" + scheme +
                             "' are not read; accepted are a file name, file:// and "
                             "package://");
        }
    }  // namespace

    std::vector<std::filesystem::path> resourceFolders()
    {
        std::vector<std::filesystem::path> folders;
        const char *names = std::getenv("OMPL_MFA_RESOURCE_DIR");
        std::istringstream list(names == nullptr ? "" : names);
        for (std::string name; std::getline(list, name, ':');)
        {
            if (!name.empty())
            {
                folders.emplace_back(name);
            }
        }
        return folders;
    }

    std::filesystem::path findMeshResource(const std::string &resource, const Folders &folders)
    {
        std::string sought;
        for (const std::filesystem::path &place : placesOf(resource, folders))
        {
            if (std::filesystem::is_regular_file(place))
            {
                return place;
            }
            sought += (sought.empty() ? "" : ", ") + place.string();
        }
        throw InputError("mesh file not found; sought " + sought +
                         " (OMPL_MFA_RESOURCE_DIR may name further folders, separated by colons)");
    }
}  // namespace ompl_mfa::collision
