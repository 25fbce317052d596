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

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision/MoveItWorld.h"
#include "collision/SceneWarnings.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/collision/PlanningScene.h"
#include "ompl_mfa/collision/Primitive.h"
#include "ompl_mfa/collision/TriangleMesh.h"
#include "text/NumberText.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // Reads the words of a text and keeps track of the line.
        class WordReader
        {
        public:
            explicit WordReader(const std::filesystem::path &file)
              : file_(file.string())
            {
                std::ifstream stream(file, std::ios::binary);
                if (!stream || !std::filesystem::is_regular_file(file))
                {
                    throw InputError(file_ + ": planning scene not found or not readable");
                }
                for (std::string line; std::getline(stream, line);)
                {
                    lines_.push_back(line);
                }
                next();
            }

            [[noreturn]] void fail(const std::string &fault) const
            {
                throw InputError(place() + ": " + fault);
            }

            // File and line of the last word read.
            std::string place() const
            {
                return file_ + ":" + std::to_string(line_);
            }

            bool atEnd()
            {
                skipBlanks();
                return line_ > lines_.size();
            }

            // Skips the rest of the line.
            void skipLine()
            {
                next();
            }

            std::string word()
            {
                if (atEnd())
                {
                    throw InputError(file_ + ": planning scene is empty or ends before the '.' of its last line");
                }
                std::string word;
                words_ >> word;
                return word;
            }

            // The rest of the line without surrounding blanks.
            std::string restOfLine()
            {
                std::string rest;
                std::getline(words_, rest);
                const std::size_t first = rest.find_first_not_of(BLANKS);
                return first == std::string::npos ? "" : rest.substr(first, rest.find_last_not_of(BLANKS) + 1 - first);
            }

            // Number of words in the next line that is not blank.
            std::size_t wordsAhead()
            {
                std::size_t words = 0;
                if (!atEnd())
                {
                    std::istringstream copy(lines_[line_ - 1]);
                    for (std::string word; copy >> word;)
                    {
                        ++words;
                    }
                }
                return words;
            }

            double number(const std::string &what)
            {
                const std::string text = word();
                double value = 0.;
                // Also rejects NaN.
                if (!text::readNumber(text, value) || !(std::abs(value) <= LARGEST_COORDINATE))
                {
                    fail(what + " = " + text + ": must be a finite number of at most 1e30");
                }
                return value;
            }

            std::size_t count(const std::string &what)
            {
                const std::string text = word();
                std::size_t value = 0;
                if (!text::readNumber(text, value))
                {
                    fail(what + " = " + text + ": must be a whole number");
                }
                return value;
            }

            template <int Size>
            Eigen::Matrix<double, Size, 1> vector(const std::string &what)
            {
                Eigen::Matrix<double, Size, 1> vector;
                for (int i = 0; i < Size; ++i)
                {
                    vector[i] = number(what);
                }
                return vector;
            }

        private:
            void next()
            {
                ++line_;
                words_ = std::istringstream(line_ <= lines_.size() ? lines_[line_ - 1] : "");
            }

            void skipBlanks()
            {
                while (line_ <= lines_.size() && (words_ >> std::ws).eof())
                {
                    next();
                }
            }

            static constexpr const char *BLANKS = " \t\r\v\f";

            std::string file_;
            std::vector<std::string> lines_;
            std::size_t line_{0};
            std::istringstream words_;
        };

        // A primitive in this format: the number of values in its line, and the index of each dimension.
        struct TextPrimitive
        {
            const char *name;
            std::vector<std::size_t> order;
        };

        // The radius comes before the height here, unlike in messages.
        const std::array<TextPrimitive, 4> PRIMITIVES{
            {{"box", {0, 1, 2}}, {"sphere", {0}}, {"cylinder", {1, 0}}, {"cone", {1, 0}}}};

        class TextSceneReader
        {
        public:
            explicit TextSceneReader(const std::filesystem::path &file)
              : text_(file)
            {
            }

            Scene read()
            {
                // The name of the scene, which may be empty.
                text_.skipLine();
                for (std::string marker = text_.word(); marker != "."; marker = text_.word())
                {
                    if (marker != "*")
                    {
                        text_.fail("'" + marker + "' stands where an object begins; accepted are '*' and '.'");
                    }
                    readObject();
                }
                const std::string end = text_.place();
                if (!text_.atEnd())
                {
                    text_.fail("there is text behind the '.' that ends a scene");
                }
                Scene scene = world_.scene();
                if (scene.objects().empty())
                {
                    throw InputError(end + ": the world has no obstacle; at least one is needed");
                }
                return scene;
            }

        private:
            void readObject()
            {
                const std::string place = text_.place();
                MoveItWorld::Object object;
                object.id = text_.restOfLine();
                if (!formatIsKnown_)
                {
                    // As in MoveIt, the format is recognised by what follows the first name: a pose or the number of
                    // shapes.
                    objectsHavePoses_ = text_.wordsAhead() > 1;
                    formatIsKnown_ = true;
                }
                object.pose = objectsHavePoses_ ? readPose() : fcl::Transform3d::Identity();
                for (std::size_t shapes = text_.count("number of shapes"); shapes > 0; --shapes)
                {
                    object.shapes.push_back(readShape());
                }
                for (std::size_t frames = objectsHavePoses_ ? text_.count("number of subframes") : 0; frames > 0;
                     --frames)
                {
                    const std::string name = text_.word();
                    object.subframes[name] = readPose();
                }
                unset_.warn(place + ": object '" + object.id + "'");
                if (object.shapes.empty())
                {
                    throw InputError(place + ": object '" + object.id + "' has no shapes");
                }
                const std::string id = object.id;
                if (world_.add(std::move(object)))
                {
                    warnOfScene(place + ": object '" + id +
                                "' takes the place of the one of this name before it, as in MoveIt");
                }
            }

            MoveItWorld::Shape readShape()
            {
                const std::string type = text_.word();
                MoveItWorld::Shape shape;
                shape.geometry = type == "mesh" ? readMesh() : readPrimitive(type);
                shape.pose = readPose();
                text_.vector<4>("colour");
                return shape;
            }

            std::shared_ptr<fcl::CollisionGeometryd> readPrimitive(const std::string &type)
            {
                for (const TextPrimitive &primitive : PRIMITIVES)
                {
                    if (type != primitive.name)
                    {
                        continue;
                    }
                    std::vector<double> numbers(primitive.order.size());
                    for (double &number : numbers)
                    {
                        number = text_.number(type);
                    }
                    std::vector<double> dimensions;
                    for (const std::size_t index : primitive.order)
                    {
                        dimensions.push_back(numbers[index]);
                    }
                    try
                    {
                        return makePrimitive(*findPrimitiveKind(type), dimensions);
                    }
                    catch (const std::invalid_argument &error)
                    {
                        text_.fail(error.what());
                    }
                }
                text_.fail("unknown shape '" + type + "'; accepted are box, sphere, cylinder, cone and mesh");
            }

            std::shared_ptr<fcl::CollisionGeometryd> readMesh()
            {
                const std::size_t vertices = text_.count("number of vertices");
                const std::size_t triangles = text_.count("number of triangles");
                if (triangles == 0)
                {
                    text_.fail("the mesh has no triangles");
                }
                TriangleMesh mesh;
                while (mesh.vertices.size() < vertices)
                {
                    mesh.vertices.emplace_back(text_.vector<3>("vertex"));
                }
                while (mesh.triangles.size() < triangles)
                {
                    std::array<std::size_t, 3> corners{};
                    for (std::size_t &corner : corners)
                    {
                        corner = text_.count("vertex index");
                        if (corner >= vertices)
                        {
                            text_.fail("vertex index " + std::to_string(corner) + " must be below " +
                                       std::to_string(vertices));
                        }
                    }
                    mesh.triangles.emplace_back(corners[0], corners[1], corners[2]);
                }
                return makeMeshGeometry(mesh);
            }

            fcl::Transform3d readPose()
            {
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                pose.translation() = text_.vector<3>("position");
                const auto rotation = rotationOf(text_.vector<4>("orientation"), "orientation", unset_);
                if (!rotation)
                {
                    text_.fail("orientation: a quaternion of a length near 0 is no rotation");
                }
                pose.linear() = *rotation;
                return pose;
            }

            WordReader text_;
            MoveItWorld world_;
            UnsetFields unset_;
            bool formatIsKnown_{false};
            bool objectsHavePoses_{false};
        };
    }  // namespace

    Scene loadTextScene(const std::filesystem::path &file)
    {
        return TextSceneReader(file).read();
    }
}  // namespace ompl_mfa::collision
