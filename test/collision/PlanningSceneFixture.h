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

#ifndef OMPL_MFA_TEST_COLLISION_PLANNING_SCENE_FIXTURE_
#define OMPL_MFA_TEST_COLLISION_PLANNING_SCENE_FIXTURE_

#include <string>

#include <gtest/gtest.h>

#include "collision/TestFiles.h"
#include "ompl_mfa/collision/PlanningScene.h"

namespace ompl_mfa::collision
{
    class PlanningSceneTest : public ::testing::Test
    {
    protected:
        Scene load(const std::string &text) const
        {
            return loadPlanningScene(folder_.write("scene.yaml", text));
        }

        // One obstacle with the given shapes, from line 4 on.
        Scene loadObject(const std::string &lines) const
        {
            return load("world:\n  collision_objects:\n    - id: thing\n" + lines);
        }

        template <typename... Parts>
        void expectFault(const std::string &text, const Parts &...parts) const
        {
            expectInputError([&] { load(text); }, "scene.yaml", parts...);
        }

        template <typename... Parts>
        void expectObjectFault(const std::string &lines, const Parts &...parts) const
        {
            expectInputError([&] { loadObject(lines); }, "scene.yaml", parts...);
        }

        TemporaryFolder folder_;
    };
}  // namespace ompl_mfa::collision

#endif
