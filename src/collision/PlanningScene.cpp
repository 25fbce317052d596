#include "ompl_mfa/collision/PlanningScene.h"

#include <cmath>
#include <set>
#include <string>

#include <yaml-cpp/yaml.h>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/NumberText.h"
#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/collision/Primitive.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        using Names = std::set<std::string>;

        class SceneReader
        {
        public:
            explicit SceneReader(std::filesystem::path file)
              : file_(std::move(file))
            {
            }

            Scene read()
            {
                const YAML::Node root = parse();
                if (!root || root.IsNull())
                {
                    throw InputError(file_.string() + ": planning scene is empty; it needs world.collision_objects");
                }
                // The fields of moveit_msgs/PlanningScene that say nothing about obstacles are passed over.
                checkKeys(root, "planning scene",
                          {"world", "name", "robot_state", "robot_model_name", "fixed_frame_transforms",
                           "allowed_collision_matrix", "link_padding", "link_scale", "object_colors", "is_diff"});
                const YAML::Node world = required(root, "world");
                checkKeys(world, "world", {"collision_objects", "octomap"});
                const YAML::Node objects = required(world, "collision_objects");
                requireSequence(objects, "collision_objects");
                for (const YAML::Node &object : objects)
                {
                    readObject(object);
                }
                if (scene_.objects().empty())
                {
                    fail(objects, "collision_objects: the world has no obstacle; at least one is needed");
                }
                return std::move(scene_);
            }

        private:
            YAML::Node parse() const
            {
                try
                {
                    return YAML::LoadFile(file_.string());
                }
                catch (const YAML::BadFile &)
                {
                    throw InputError(file_.string() + ": planning scene not found or not readable");
                }
                catch (const YAML::ParserException &error)
                {
                    throw InputError(place(error.mark) + ": malformed YAML: " + error.msg);
                }
            }

            std::string place(const YAML::Mark &mark) const
            {
                return file_.string() + (mark.is_null() ? "" : ":" + std::to_string(mark.line + 1));
            }

            [[noreturn]] void fail(const YAML::Node &node, const std::string &fault) const
            {
                throw InputError(place(node.Mark()) + ": " + fault);
            }

            void requireMap(const YAML::Node &node, const std::string &key) const
            {
                if (!node.IsMap())
                {
                    fail(node, key + " must be a map of keys and values");
                }
            }

            void requireSequence(const YAML::Node &node, const std::string &key) const
            {
                if (!node.IsSequence())
                {
                    fail(node, key + " must be a list");
                }
            }

            void checkKeys(const YAML::Node &map, const std::string &what, const Names &accepted) const
            {
                requireMap(map, what);
                Names seen;
                for (const auto &entry : map)
                {
                    const std::string key = entry.first.as<std::string>("");
                    if (accepted.count(key) == 0)
                    {
                        fail(entry.first, what + " has an unknown key '" + key + "'; accepted are " + list(accepted));
                    }
                    if (!seen.insert(key).second)
                    {
                        fail(entry.first, what + " has the key '" + key + "' twice");
                    }
                }
            }

            static std::string list(const Names &names)
            {
                std::string text;
                for (const std::string &name : names)
                {
                    text += (text.empty() ? "" : ", ") + name;
                }
                return text;
            }

            YAML::Node required(const YAML::Node &map, const std::string &key) const
            {
                const YAML::Node value = map[key];
                if (!value || value.IsNull())
                {
                    fail(map, "key '" + key + "' is missing or empty");
                }
                return value;
            }

            void readObject(const YAML::Node &object)
            {
                checkKeys(object, "collision object",
                          {"id", "header", "type", "pose", "operation", "primitives", "primitive_poses", "meshes",
                           "mesh_poses", "planes", "plane_poses", "subframe_names", "subframe_poses"});
                const YAML::Node id = required(object, "id");
                if (!id.IsScalar())
                {
                    fail(id, "id must be a name");
                }
                refuseUnsupported(object);
                const fcl::Transform3d pose = object["pose"] ? readPose(object["pose"]) : fcl::Transform3d::Identity();
                const std::size_t before = scene_.objects().size();
                readShapes(object, "primitives", "primitive_poses", pose,
                           [this](const YAML::Node &node) { return readPrimitive(node); });
                readShapes(object, "meshes", "mesh_poses", pose,
                           [this](const YAML::Node &node) { return readMesh(node); });
                if (scene_.objects().size() == before)
                {
                    fail(object, "object '" + id.Scalar() + "' has no primitives and no meshes");
                }
            }

            void refuseUnsupported(const YAML::Node &object) const
            {
                const YAML::Node planes = object["planes"];
                if (planes && planes.size() > 0)
                {
                    fail(planes, "planes are not supported; accepted are primitives and meshes");
                }
                const YAML::Node operation = object["operation"];
                if (operation && operation.as<std::string>("") != "0" && operation.as<std::string>("") != "add")
                {
                    fail(operation, "operation = " + operation.as<std::string>("?") + ": must be 0 or 'add'");
                }
            }

            template <typename ReadShape>
            void readShapes(const YAML::Node &object, const std::string &shapesKey, const std::string &posesKey,
                            const fcl::Transform3d &objectPose, const ReadShape &readShape)
            {
                const YAML::Node shapes = object[shapesKey];
                const YAML::Node poses = object[posesKey];
                const std::size_t count = shapes && !shapes.IsNull() ? shapes.size() : 0;
                if (count > 0)
                {
                    requireSequence(shapes, shapesKey);
                }
                if (poses && !poses.IsNull())
                {
                    requireSequence(poses, posesKey);
                    if (poses.size() != count)
                    {
                        fail(poses, posesKey + " has " + std::to_string(poses.size()) + " entries for " +
                                        std::to_string(count) + " " + shapesKey);
                    }
                }
                for (std::size_t i = 0; i < count; ++i)
                {
                    const fcl::Transform3d pose =
                        poses && !poses.IsNull() ? fcl::Transform3d(objectPose * readPose(poses[i])) : objectPose;
                    scene_.add({object["id"].Scalar(), readShape(shapes[i]), pose});
                }
            }

            std::shared_ptr<fcl::CollisionGeometryd> readPrimitive(const YAML::Node &node) const
            {
                checkKeys(node, "primitive", {"type", "dimensions", "polygon"});
                const YAML::Node type = required(node, "type");
                const std::string name = lowerCase(type.IsScalar() ? type.Scalar() : "");
                const PrimitiveKind *kind = findPrimitiveKind(name);
                if (kind == nullptr)
                {
                    std::string accepted;
                    for (const PrimitiveKind &known : primitiveKinds())
                    {
                        accepted += (accepted.empty() ? "" : ", ") + std::string(known.name);
                    }
                    fail(type, "unknown primitive type '" + name + "'; accepted are " + accepted);
                }
                const YAML::Node dimensions = required(node, "dimensions");
                requireSequence(dimensions, "dimensions");
                std::vector<double> values;
                for (const YAML::Node &dimension : dimensions)
                {
                    values.push_back(readNumber(dimension, "dimensions"));
                }
                try
                {
                    return makePrimitive(*kind, values);
                }
                catch (const std::invalid_argument &error)
                {
                    fail(dimensions, std::string("dimensions: ") + error.what());
                }
            }

            std::shared_ptr<fcl::CollisionGeometryd> readMesh(const YAML::Node &node) const
            {
                checkKeys(node, "mesh", {"resource", "scale", "vertices", "triangles"});
                TriangleMesh mesh = node["resource"] ? readMeshFile(node) : readInlineMesh(node);
                if (node["scale"])
                {
                    const fcl::Vector3d scale = readScale(node["scale"]);
                    for (fcl::Vector3d &vertex : mesh.vertices)
                    {
                        vertex = vertex.cwiseProduct(scale);
                    }
                }
                return makeMeshGeometry(mesh);
            }

            TriangleMesh readMeshFile(const YAML::Node &node) const
            {
                const YAML::Node resource = node["resource"];
                if (!resource.IsScalar() || node["vertices"] || node["triangles"])
                {
                    fail(resource, "a mesh is either a 'resource' (a file name) or 'vertices' and 'triangles'");
                }
                std::string name = resource.Scalar();
                const std::string scheme = "file://";
                if (name.compare(0, scheme.size(), scheme) == 0)
                {
                    name = name.substr(scheme.size());
                }
                try
                {
                    return loadMesh(file_.parent_path() / name);
                }
                catch (const InputError &error)
                {
                    fail(resource, std::string("resource: ") + error.what());
                }
            }

            TriangleMesh readInlineMesh(const YAML::Node &node) const
            {
                const YAML::Node vertices = required(node, "vertices");
                const YAML::Node triangles = required(node, "triangles");
                requireSequence(vertices, "vertices");
                requireSequence(triangles, "triangles");
                TriangleMesh mesh;
                for (const YAML::Node &vertex : vertices)
                {
                    mesh.vertices.push_back(readVector<3>(vertex, "vertices", {"x", "y", "z"}));
                }
                for (const YAML::Node &triangle : triangles)
                {
                    mesh.triangles.push_back(readTriangle(triangle, mesh.vertices.size()));
                }
                if (mesh.triangles.empty())
                {
                    fail(triangles, "triangles: the mesh has no triangles");
                }
                return mesh;
            }

            fcl::Triangle readTriangle(const YAML::Node &node, std::size_t vertexCount) const
            {
                const YAML::Node indices = node.IsMap() ? required(node, "vertex_indices") : node;
                if (!indices.IsSequence() || indices.size() != 3)
                {
                    fail(node, "triangles: a triangle has 3 vertex indices");
                }
                std::array<std::size_t, 3> index{};
                for (std::size_t i = 0; i < 3; ++i)
                {
                    const double value = readNumber(indices[i], "triangles");
                    if (value < 0. || value >= static_cast<double>(vertexCount) || value != std::floor(value))
                    {
                        fail(indices[i], "triangles: vertex index " + indices[i].Scalar() +
                                             " must be a whole number below " + std::to_string(vertexCount));
                    }
                    index[i] = static_cast<std::size_t>(value);
                }
                return {index[0], index[1], index[2]};
            }

            fcl::Vector3d readScale(const YAML::Node &node) const
            {
                fcl::Vector3d scale = node.IsScalar() ? fcl::Vector3d::Constant(readNumber(node, "scale"))
                                                      : readVector<3>(node, "scale", {"x", "y", "z"});
                if (scale.minCoeff() <= 0.)
                {
                    fail(node, "scale must be greater than 0");
                }
                return scale;
            }

            double readNumber(const YAML::Node &node, const std::string &key) const
            {
                double value = 0.;
                if (!node.IsScalar() || !ompl_mfa::readNumber(node.Scalar(), value) || !std::isfinite(value))
                {
                    fail(node, key + (node.IsScalar() ? " = " + node.Scalar() : "") + ": must be a finite number");
                }
                if (std::abs(value) > largestCoordinate)
                {
                    fail(node, key + " = " + node.Scalar() + ": must not exceed 1e30, of which distances overflow");
                }
                return value;
            }

            // As a list, or as a map of the components.
            template <int Size>
            Eigen::Matrix<double, Size, 1> readVector(const YAML::Node &node, const std::string &key,
                                                      const std::array<const char *, Size> &names) const
            {
                if (!node.IsMap() && !(node.IsSequence() && node.size() == Size))
                {
                    fail(node, key + " must have " + std::to_string(Size) + " components");
                }
                if (node.IsMap())
                {
                    checkKeys(node, key, Names(names.begin(), names.end()));
                }
                Eigen::Matrix<double, Size, 1> vector;
                for (std::size_t i = 0; i < Size; ++i)
                {
                    vector[static_cast<int>(i)] =
                        readNumber(node.IsMap() ? required(node, names[i]) : node[i], key + "." + names[i]);
                }
                return vector;
            }

            fcl::Transform3d readPose(const YAML::Node &node) const
            {
                checkKeys(node, "pose", {"position", "orientation"});
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                if (node["position"])
                {
                    pose.translation() = readVector<3>(node["position"], "position", {"x", "y", "z"});
                }
                if (node["orientation"])
                {
                    const Eigen::Vector4d xyzw =
                        readVector<4>(node["orientation"], "orientation", {"x", "y", "z", "w"});
                    // Not of unit length to the digits that a file has is normal; zero has no direction at all.
                    const double length = xyzw.stableNorm();
                    if (length < 1e-6)
                    {
                        fail(node["orientation"], "orientation: a quaternion of length 0 is no rotation");
                    }
                    pose.linear() = Eigen::Quaterniond(xyzw / length).toRotationMatrix();
                }
                return pose;
            }

            std::filesystem::path file_;
            Scene scene_;
        };
    }  // namespace

    Scene loadPlanningScene(const std::filesystem::path &file)
    {
        return SceneReader(file).read();
    }
}  // namespace ompl_mfa::collision
