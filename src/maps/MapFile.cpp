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

#include "ompl_mfa/maps/MapFile.h"

#include <fstream>
#include <string>

#include "maps/MapReaders.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"

namespace ompl_mfa::maps
{
    bool isMapFile(const std::filesystem::path &file)
    {
        const std::string extension = lowerCase(file.extension().string());
        if (extension == ".map")
        {
            return true;
        }
        if (extension != ".yaml" && extension != ".yml")
        {
            return false;
        }
        std::ifstream in(file);
        for (std::string line; std::getline(in, line);)
        {
            if (line.rfind("image", 0) == 0 && trimmed(line.substr(std::string("image").size())).rfind(':', 0) == 0)
            {
                return true;
            }
        }
        return false;
    }

    GridMap loadMap(const std::filesystem::path &file)
    {
        if (!std::filesystem::is_regular_file(file))
        {
            throw InputError(file.string() + ": map not found");
        }
        const std::string extension = lowerCase(file.extension().string());
        if (extension == ".map")
        {
            return loadMovingAiMap(file);
        }
        if (extension == ".yaml" || extension == ".yml")
        {
            return loadServerMap(file);
        }
        throw InputError(file.string() + ": is not a map; accepted are .yaml of map_server and .map of MovingAI");
    }
}  // namespace ompl_mfa::maps
