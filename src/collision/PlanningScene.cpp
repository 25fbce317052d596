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

#include "ompl_mfa/collision/PlanningScene.h"

#include <string>

#include "collision/SceneReader.h"
#include "text/NumberText.h"

namespace ompl_mfa::collision
{
    namespace
    {
        void refuseAttached(const YamlFile &yaml, const YAML::Node &attached)
        {
            for (const YAML::Node &body : attached)
            {
                const std::string id =
                    body["object"] && body["object"].IsMap() ? yaml.text(body["object"], "id") : std::string();
                yaml.fail(body, "attached_collision_objects: '" + id + "' is attached to the link '" +
                                    yaml.text(body, "link_name") +
                                    "', and links are not read; accepted is an empty list");
            }
        }

        // `neutral` is the value that changes nothing.
        void refuseLinks(const YamlFile &yaml, const YAML::Node &root, const std::string &key,
                         const std::string &property, double neutral)
        {
            for (const YAML::Node &link : yaml.list(root, key))
            {
                yaml.checkKeys(link, key, {"link_name", property});
                const YAML::Node value = yaml.required(link, property);
                if (yaml.number(value, property) != neutral)
                {
                    yaml.fail(value, key + ": " + property + " of the link '" + yaml.text(link, "link_name") +
                                         "' = " + value.Scalar() + ", and links are not read; accepted is " +
                                         text::numberText(neutral));
                }
            }
        }

        // A robot is one rigid body here, so anything attached to the links of an arm would be missing.
        void refuseRobot(const YamlFile &yaml, const YAML::Node &root)
        {
            refuseAttached(yaml, yaml.list(YamlFile::optional(root, "robot_state"), "attached_collision_objects"));
            refuseLinks(yaml, root, "link_padding", "padding", 0.);
            refuseLinks(yaml, root, "link_scale", "scale", 1.);
        }
    }  // namespace

    Scene loadPlanningScene(const std::filesystem::path &file, const std::vector<std::filesystem::path> &packageFolders)
    {
        SceneReader reader(file, packageFolders);
        const YAML::Node root = reader.message();
        refuseRobot(reader.yaml(), root);
        reader.readWorld(root);
        Scene scene = reader.world().scene();
        if (scene.objects().empty())
        {
            reader.yaml().fail(root["world"],
                               "the world has no obstacle; at least one in collision_objects or octomap is needed");
        }
        return scene;
    }
}  // namespace ompl_mfa::collision
