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

#include "collision/YamlShapes.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/collision/Primitive.h"

namespace ompl_mfa::collision
{
    namespace
    {
        const PrimitiveKind &kindOf(const YamlFile &yaml, const YAML::Node &type)
        {
            const std::string name = lowerCase(type.IsScalar() ? type.Scalar() : "");
            const PrimitiveKind *kind = findPrimitiveKind(name);
            if (kind == nullptr)
            {
                yaml.fail(type, "unknown primitive type '" + name + "'; accepted are " + primitiveNames());
            }
            return *kind;
        }

        // Only a prism has one, which is not supported.
        void refusePolygon(const YamlFile &yaml, const YAML::Node &node)
        {
            if (YamlFile::has(node, "polygon"))
            {
                const YAML::Node polygon = node["polygon"];
                yaml.checkKeys(polygon, "polygon", {"points"});
                if (yaml.list(polygon, "points").size() > 0)
                {
                    yaml.fail(polygon, "polygon: prisms are not supported; accepted are " + primitiveNames());
                }
            }
        }

        TriangleMesh readMeshFile(const YamlFile &yaml, const YAML::Node &node, const Folders &folders)
        {
            const YAML::Node resource = node["resource"];
            if (!resource.IsScalar() || node["vertices"] || node["triangles"])
            {
                yaml.fail(resource, "a mesh is either a 'resource' (a file name) or 'vertices' and 'triangles'");
            }
            try
            {
                return loadMesh(findMeshResource(resource.Scalar(), folders), RootTransform::Reset);
            }
            catch (const InputError &error)
            {
                yaml.fail(resource, "resource = " + resource.Scalar() + ": " + error.what());
            }
        }

        fcl::Triangle readTriangle(const YamlFile &yaml, const YAML::Node &node, std::size_t vertexCount)
        {
            const YAML::Node indices = node.IsMap() ? yaml.required(node, "vertex_indices") : node;
            if (!indices.IsSequence() || indices.size() != 3)
            {
                yaml.fail(node, "triangles: a triangle has 3 vertex indices");
            }
            std::array<std::size_t, 3> index{};
            for (std::size_t i = 0; i < 3; ++i)
            {
                const double value = yaml.number(indices[i], "triangles");
                if (value < 0. || value >= static_cast<double>(vertexCount) || value != std::floor(value))
                {
                    yaml.fail(indices[i], "triangles: vertex index " + indices[i].Scalar() +
                                              " must be a whole number below " + std::to_string(vertexCount));
                }
                index[i] = static_cast<std::size_t>(value);
            }
            return {index[0], index[1], index[2]};
        }

        TriangleMesh readInlineMesh(const YamlFile &yaml, const YAML::Node &node)
        {
            yaml.required(node, "vertices");
            const YAML::Node triangles = yaml.required(node, "triangles");
            TriangleMesh mesh;
            for (const YAML::Node &vertex : yaml.list(node, "vertices"))
            {
                mesh.vertices.push_back(yaml.vector<3>(vertex, "vertices", {"x", "y", "z"}));
            }
            for (const YAML::Node &triangle : yaml.list(node, "triangles"))
            {
                mesh.triangles.push_back(readTriangle(yaml, triangle, mesh.vertices.size()));
            }
            if (mesh.triangles.empty())
            {
                yaml.fail(triangles, "triangles: the mesh has no triangles");
            }
            return mesh;
        }

        fcl::Vector3d readScale(const YamlFile &yaml, const YAML::Node &node, const std::string &key)
        {
            fcl::Vector3d scale = node.IsScalar() ? fcl::Vector3d::Constant(yaml.number(node, key))
                                                  : yaml.vector<3>(node, key, {"x", "y", "z"});
            if (scale.minCoeff() <= 0.)
            {
                yaml.fail(node, key + " must be greater than 0");
            }
            return scale;
        }
    }  // namespace

    std::shared_ptr<fcl::CollisionGeometryd> readPrimitive(const YamlFile &yaml, const YAML::Node &node)
    {
        yaml.checkKeys(node, "primitive", {"type", "dimensions", "polygon"});
        const PrimitiveKind &kind = kindOf(yaml, yaml.required(node, "type"));
        refusePolygon(yaml, node);
        const YAML::Node dimensions = yaml.required(node, "dimensions");
        std::vector<double> values;
        for (const YAML::Node &dimension : yaml.list(node, "dimensions"))
        {
            values.push_back(yaml.number(dimension, "dimensions"));
        }
        try
        {
            return makePrimitive(kind, values);
        }
        catch (const std::invalid_argument &error)
        {
            yaml.fail(dimensions, std::string("dimensions: ") + error.what());
        }
    }

    TriangleMesh readMesh(const YamlFile &yaml, const YAML::Node &node, const Folders &folders)
    {
        yaml.checkKeys(node, "mesh", {"resource", "scale", "dimensions", "vertices", "triangles"});
        TriangleMesh mesh =
            YamlFile::has(node, "resource") ? readMeshFile(yaml, node, folders) : readInlineMesh(yaml, node);
        const bool robowflex = YamlFile::has(node, "dimensions");
        if (robowflex && YamlFile::has(node, "scale"))
        {
            yaml.fail(node["dimensions"], "a mesh has either 'scale' or 'dimensions', which mean the same");
        }
        const std::string key = robowflex ? "dimensions" : "scale";
        if (YamlFile::has(node, key))
        {
            const fcl::Vector3d scale = readScale(yaml, node[key], key);
            for (fcl::Vector3d &vertex : mesh.vertices)
            {
                vertex = vertex.cwiseProduct(scale);
            }
        }
        return mesh;
    }
}  // namespace ompl_mfa::collision
