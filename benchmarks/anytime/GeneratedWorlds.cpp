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

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>

#include "anytime/WorldList.h"
#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        const char *const CIRCLES = "circles_narrow_2d";

        [[noreturn]] void refuse(const std::string &name, const std::string &reason)
        {
            throw InputError("--generated '" + name + "': " + reason);
        }

        /* A family of worlds, one for each size (dimensions or links) and seed. */
        struct Family
        {
            std::string kind;
            /* Behind the size in names. */
            std::string unit;
            std::vector<int> sizes;
            std::function<World(int size, std::uint64_t seed)> make;
        };

        std::vector<int> upTo16()
        {
            return {2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
        }

        Family boxFamily(const std::string &kind, const std::vector<int> &dimensions)
        {
            return {kind, "d", dimensions,
                    [kind](int dimension, std::uint64_t seed) { return boxWorld(kind, dimension, seed); }};
        }

        const std::vector<Family> &families()
        {
            static const std::vector<Family> FAMILIES = {
                {"circles_narrow", "d", {2}, [](int, std::uint64_t seed) { return circleWorld(seed); }},
                boxFamily("wall_gap", upTo16()),
                boxFamily("double_enclosure", upTo16()),
                boxFamily("dividing_walls", upTo16()),
                boxFamily("random_boxes", {2, 4, 8, 16}),
                {"arm", "", upTo16(), armWorld}};
            return FAMILIES;
        }

        std::string sizesOf(const Family &family)
        {
            if (family.sizes == upTo16())
            {
                return "2 to 16";
            }
            std::string text;
            for (const int size : family.sizes)
            {
                text += (text.empty() ? "" : ", ") + std::to_string(size);
            }
            return text;
        }

        /* Why nothing can be measured in a world, as far as geometry knows; empty if it knows of no reason. Straight
           motions from start to goal are blocked in all families by how they are drawn. */
        std::string objectionTo(const World &world, std::uint64_t seed)
        {
            if (world.optimum && !std::isfinite(world.optimum()))
            {
                return "there is no path from start to goal";
            }
            if (world.family == CIRCLES && !hasNarrowCircles(seed))
            {
                return "the shortest path squeezes through no narrow gap";
            }
            return "";
        }

        void requireUseful(const World &world, const Family &family, int size, std::uint64_t seed)
        {
            const std::string objection = objectionTo(world, seed);
            if (objection.empty())
            {
                return;
            }
            std::uint64_t next = seed + 1;
            while (!objectionTo(family.make(size, next), next).empty())
            {
                ++next;
            }
            refuse(world.name, objection + "; the next seed that will do is " + std::to_string(next));
        }

        World makeWorld(const std::string &name)
        {
            // leading zeros would give one world two names
            static const std::regex FORM("([a-z_]+)_([1-9][0-9]*)(d?)_([1-9][0-9]*)");
            std::smatch parts;
            if (!std::regex_match(name, parts, FORM))
            {
                refuse(name, "expected FAMILY_SEED, such as random_boxes_8d_101; `ompl_mfa_anytime list` has families");
            }
            const auto family = std::find_if(families().begin(), families().end(),
                                             [&parts](const Family &candidate)
                                             { return candidate.kind == parts[1] && candidate.unit == parts[3]; });
            if (family == families().end())
            {
                refuse(name, "no such family; `ompl_mfa_anytime list` has them");
            }
            const std::vector<int> &sizes = family->sizes;
            int size = 0;
            if (!text::readNumber(parts[2].str(), size) || std::find(sizes.begin(), sizes.end(), size) == sizes.end())
            {
                refuse(name,
                       family->kind + " has " + (family->unit.empty() ? "links: " : "dimensions: ") + sizesOf(*family));
            }
            std::uint32_t seed = 0;
            if (!text::readNumber(parts[4].str(), seed))
            {
                refuse(name, "expected a seed from 1 to 4294967295");
            }
            World world = family->make(size, seed);
            requireUseful(world, *family, size, seed);
            return world;
        }
    }  // namespace

    std::vector<std::string> generatedFamilies()
    {
        std::vector<std::string> texts;
        for (const Family &family : families())
        {
            texts.push_back(family.kind + "_N" + family.unit + "_SEED, N: " + sizesOf(family));
        }
        return texts;
    }

    std::vector<World> generatedWorlds(const std::vector<std::string> &names)
    {
        std::vector<World> worlds;
        for (const std::string &name : names)
        {
            const auto isNamed = [&name](const World &world) { return world.name == name; };
            if (std::none_of(worlds.begin(), worlds.end(), isNamed))
            {
                worlds.push_back(makeWorld(name));
            }
        }
        return worlds;
    }
}  // namespace ompl_mfa::anytime
