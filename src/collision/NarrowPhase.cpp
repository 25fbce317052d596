#include "NarrowPhase.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <type_traits>

#include <fcl/geometry/octree/octree.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        using Geometry = fcl::CollisionGeometryd;
        using Pose = fcl::Transform3d;
        using BoundingVolume = fcl::OBBRSS<double>;
        using Map = fcl::OcTree<double>;

        using Kinds = std::tuple<fcl::Sphered, fcl::Boxd, fcl::Cylinderd, fcl::Coned, MeshGeometry, Map>;

        template <typename Shape>
        constexpr bool isPrimitive = !std::is_same_v<Shape, MeshGeometry> && !std::is_same_v<Shape, Map>;

        // A sphere meets a box or a cylinder at the point of it that is nearest to the centre: FCL knows it.
        bool nearestPoint(const fcl::Boxd &box, const fcl::Vector3d &point, fcl::Vector3d &nearest)
        {
            return fcl::detail::nearestPointInBox<double>(box.side, point, &nearest);
        }

        bool nearestPoint(const fcl::Cylinderd &cylinder, const fcl::Vector3d &point, fcl::Vector3d &nearest)
        {
            return fcl::detail::nearestPointInCylinder<double>(cylinder.lz, cylinder.radius, point, &nearest);
        }

        bool nearestPoint(const fcl::Sphered & /*sphere*/, const fcl::Vector3d & /*point*/, fcl::Vector3d &nearest)
        {
            nearest.setZero();
            return true;
        }

        // How far a point inside is from the surface.
        double depthInside(const fcl::Boxd &box, const fcl::Vector3d &point)
        {
            return (0.5 * box.side - point.cwiseAbs()).minCoeff();
        }

        double depthInside(const fcl::Cylinderd &cylinder, const fcl::Vector3d &point)
        {
            return std::min(cylinder.radius - point.head<2>().norm(), 0.5 * cylinder.lz - std::abs(point.z()));
        }

        double depthInside(const fcl::Sphered & /*sphere*/, const fcl::Vector3d & /*point*/)
        {
            return 0.;
        }

        template <typename Shape>
        constexpr bool hasNearestPoint = !std::is_same_v<Shape, fcl::Coned> && isPrimitive<Shape>;

        // A ball in one of these has a depth in closed form.
        template <typename A, typename B>
        constexpr bool depthIsKnown = (std::is_same_v<A, fcl::Sphered> && hasNearestPoint<B>) ||
                                      (std::is_same_v<B, fcl::Sphered> && hasNearestPoint<A>);

        template <typename Shape>
        ConvexSeparation separateSphere(const fcl::Sphered &sphere, const Pose &spherePose, const Shape &shape,
                                        const Pose &shapePose)
        {
            const fcl::Vector3d offset = spherePose.translation() - shapePose.translation();
            const fcl::Vector3d centre = shapePose.linear().transpose() * offset;
            fcl::Vector3d nearest;
            ConvexSeparation result;
            if (!nearestPoint(shape, centre, nearest))
            {
                result.lower = result.upper = -sphere.radius - depthInside(shape, centre);
                return result;
            }
            const fcl::Vector3d outward = centre - nearest;
            const double distance = outward.norm();
            result.lower = result.upper = distance - sphere.radius - marginOf(shape);
            if (distance > 0.)
            {
                result.normal = shapePose.linear() * (outward / distance);
            }
            return result;
        }

        template <typename A, typename B>
        ConvexSeparation separateShapes(const A &a, const Pose &poseA, const B &b, const Pose &poseB, bool decideOnly)
        {
            if constexpr (std::is_same_v<A, fcl::Sphered> && hasNearestPoint<B>)
            {
                return separateSphere(a, poseA, b, poseB);
            }
            else if constexpr (std::is_same_v<B, fcl::Sphered> && hasNearestPoint<A>)
            {
                ConvexSeparation result = separateSphere(b, poseB, a, poseA);
                result.normal = -result.normal;
                return result;
            }
            else
            {
                return separate(a, poseA, b, poseB, decideOnly);
            }
        }

        // FCL copies the points that it asks for even where no request of ours reads them.
        void clearPoints(fcl::Vector3d *first, fcl::Vector3d *second)
        {
            for (fcl::Vector3d *point : {first, second})
            {
                if (point != nullptr)
                {
                    point->setZero();
                }
            }
        }

        // What FCL's traversals of meshes and occupancy maps ask about single triangles and cells.
        struct CertifiedSolver : fcl::detail::GJKSolver_libccd<double>
        {
            template <typename A, typename B>
            bool shapeIntersect(const A &a, const Pose &poseA, const B &b, const Pose &poseB,
                                std::vector<fcl::ContactPointd> * /*contacts*/) const
            {
                return separateShapes(a, poseA, b, poseB, true).lower <= 0.;
            }

            template <typename A, typename B>
            bool shapeDistance(const A &a, const Pose &poseA, const B &b, const Pose &poseB, double *distance,
                               fcl::Vector3d *nearestA, fcl::Vector3d *nearestB) const
            {
                clearPoints(nearestA, nearestB);
                *distance = separateShapes(a, poseA, b, poseB, false).lower;
                return *distance > 0.;
            }

            template <typename Shape>
            bool shapeTriangleIntersect(const Shape &shape, const Pose &pose, const fcl::Vector3d &p1,
                                        const fcl::Vector3d &p2, const fcl::Vector3d &p3, fcl::Vector3d *contact,
                                        double *depth, fcl::Vector3d *normal) const
            {
                return shapeTriangleIntersect(shape, pose, p1, p2, p3, Pose::Identity(), contact, depth, normal);
            }

            template <typename Shape>
            bool shapeTriangleIntersect(const Shape &shape, const Pose &pose, const fcl::Vector3d &p1,
                                        const fcl::Vector3d &p2, const fcl::Vector3d &p3, const Pose &trianglePose,
                                        fcl::Vector3d *contact, double *depth, fcl::Vector3d *normal) const
            {
                clearPoints(contact, normal);
                if (depth != nullptr)
                {
                    *depth = 0.;
                }
                return separate(shape, pose, fcl::TrianglePd(p1, p2, p3), trianglePose, true).lower <= 0.;
            }

            template <typename Shape>
            bool shapeTriangleDistance(const Shape &shape, const Pose &pose, const fcl::Vector3d &p1,
                                       const fcl::Vector3d &p2, const fcl::Vector3d &p3, double *distance,
                                       fcl::Vector3d *nearestShape, fcl::Vector3d *nearestTriangle) const
            {
                return shapeTriangleDistance(shape, pose, p1, p2, p3, Pose::Identity(), distance, nearestShape,
                                             nearestTriangle);
            }

            template <typename Shape>
            bool shapeTriangleDistance(const Shape &shape, const Pose &pose, const fcl::Vector3d &p1,
                                       const fcl::Vector3d &p2, const fcl::Vector3d &p3, const Pose &trianglePose,
                                       double *distance, fcl::Vector3d *nearestShape,
                                       fcl::Vector3d *nearestTriangle) const
            {
                clearPoints(nearestShape, nearestTriangle);
                *distance = separate(shape, pose, fcl::TrianglePd(p1, p2, p3), trianglePose, false).lower;
                return *distance > 0.;
            }
        };

        // FCL keeps the contact that it finds in a vector: its memory is kept for the next query of the thread.
        fcl::CollisionResultd &clearedResult()
        {
            thread_local fcl::CollisionResultd result;
            result.clear();
            return result;
        }

        // FCL fits the volume around a primitive anew for each query, on the heap. The box of the primitive does as
        // well; its thinnest side is the roundness of the rectangle that distances are taken to.
        template <typename Shape>
        BoundingVolume volumeAround(const Shape &shape, const Pose &pose)
        {
            fcl::AABBd box;
            fcl::computeBV(shape, Pose::Identity(), box);
            const fcl::Vector3d half = 0.5 * (box.max_ - box.min_);
            int thin = 0;
            half.minCoeff(&thin);
            const int second = (thin + 1) % 3;
            const int third = (thin + 2) % 3;
            BoundingVolume volume;
            volume.obb.axis.col(0) = pose.linear().col(second);
            volume.obb.axis.col(1) = pose.linear().col(third);
            volume.obb.axis.col(2) = pose.linear().col(thin);
            volume.obb.To = pose * box.center();
            volume.obb.extent << half[second], half[third], half[thin];
            volume.rss.axis = volume.obb.axis;
            const bool isBall = std::is_same_v<Shape, fcl::Sphered>;
            volume.rss.l[0] = isBall ? 0. : 2. * half[second];
            volume.rss.l[1] = isBall ? 0. : 2. * half[third];
            volume.rss.r = half[thin];
            volume.rss.To = volume.obb.To - 0.5 * volume.rss.l[0] * volume.rss.axis.col(0) -
                            0.5 * volume.rss.l[1] * volume.rss.axis.col(1);
            return volume;
        }

        // As FCL's initialize() does for both kinds of node, but for the volume.
        template <typename Node, typename Shape, typename Request, typename Result>
        void setUpTraversal(Node &node, const MeshGeometry &mesh, const Pose &meshPose, const Shape &shape,
                            const Pose &shapePose, const CertifiedSolver &solver, const Request &request,
                            Result &result)
        {
            node.request = request;
            node.result = &result;
            node.model1 = &mesh;
            node.tf1 = meshPose;
            node.model2 = &shape;
            node.tf2 = shapePose;
            node.nsolver = &solver;
            node.model2_bv = volumeAround(shape, shapePose);
            node.vertices = mesh.vertices;
            node.tri_indices = mesh.tri_indices;
        }

        // FCL's traversal for a pair with a mesh or a map on at least one side.
        template <typename A, typename B>
        struct Traversal
        {
            static void collide(const Geometry *a, const Pose &poseA, const Geometry *b, const Pose &poseB,
                                const fcl::CollisionRequestd &request, fcl::CollisionResultd &result)
            {
                static const CertifiedSolver solver;
                if constexpr (std::is_same_v<A, MeshGeometry> && std::is_same_v<B, MeshGeometry>)
                {
                    fcl::detail::BVHCollide<BoundingVolume>(a, poseA, b, poseB, request, result);
                }
                else if constexpr (std::is_same_v<A, MeshGeometry>)
                {
                    fcl::detail::MeshShapeCollisionTraversalNodeOBBRSS<B, CertifiedSolver> node;
                    setUpTraversal(node, *static_cast<const A *>(a), poseA, *static_cast<const B *>(b), poseB, solver,
                                   request, result);
                    fcl::detail::collide(&node);
                }
                else if constexpr (std::is_same_v<B, MeshGeometry>)
                {
                    fcl::detail::OcTreeBVHCollide<BoundingVolume, CertifiedSolver>(a, poseA, b, poseB, &solver, request,
                                                                                   result);
                }
                else if constexpr (std::is_same_v<B, Map>)
                {
                    fcl::detail::OcTreeCollide<CertifiedSolver>(a, poseA, b, poseB, &solver, request, result);
                }
                else
                {
                    fcl::detail::OcTreeShapeCollide<B, CertifiedSolver>(a, poseA, b, poseB, &solver, request, result);
                }
            }

            static void distance(const Geometry *a, const Pose &poseA, const Geometry *b, const Pose &poseB,
                                 fcl::DistanceResultd &result)
            {
                static const CertifiedSolver solver;
                static const fcl::DistanceRequestd request;
                if constexpr (std::is_same_v<A, MeshGeometry> && std::is_same_v<B, MeshGeometry>)
                {
                    fcl::detail::BVHDistance<BoundingVolume>(a, poseA, b, poseB, request, result);
                }
                else if constexpr (std::is_same_v<A, MeshGeometry>)
                {
                    fcl::detail::MeshShapeDistanceTraversalNodeOBBRSS<B, CertifiedSolver> node;
                    setUpTraversal(node, *static_cast<const A *>(a), poseA, *static_cast<const B *>(b), poseB, solver,
                                   request, result);
                    fcl::detail::distance(&node);
                }
                else if constexpr (std::is_same_v<B, MeshGeometry>)
                {
                    fcl::detail::OcTreeBVHDistance<BoundingVolume, CertifiedSolver>(a, poseA, b, poseB, &solver,
                                                                                    request, result);
                }
                else if constexpr (std::is_same_v<B, Map>)
                {
                    fcl::detail::OcTreeDistance<CertifiedSolver>(a, poseA, b, poseB, &solver, request, result);
                }
                else
                {
                    fcl::detail::OcTreeShapeDistance<B, CertifiedSolver>(a, poseA, b, poseB, &solver, request, result);
                }
            }
        };

        fcl::TrianglePd triangleOf(const MeshGeometry &mesh, intptr_t index)
        {
            const fcl::Triangle &triangle = mesh.tri_indices[index];
            return {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]};
        }

        // Upper bound on a distance from the triangles that were closest before; infinite where there are none.
        template <typename A, typename B>
        double rememberedDistance(const A &a, const Pose &poseA, const B &b, const Pose &poseB,
                                  const DistanceSearch &search)
        {
            if constexpr (std::is_same_v<A, MeshGeometry>)
            {
                if (search.nearestA >= 0)
                {
                    const fcl::TrianglePd triangle = triangleOf(a, search.nearestA);
                    if constexpr (isPrimitive<B>)
                    {
                        return separate(b, poseB, triangle, poseA, false).upper;
                    }
                    else if constexpr (std::is_same_v<B, MeshGeometry>)
                    {
                        return separate(triangle, poseA, triangleOf(b, search.nearestB), poseB, false).upper;
                    }
                }
            }
            return std::numeric_limits<double>::infinity();
        }

        // FCL has a mesh before a primitive, and a map before both.
        template <typename A, typename B>
        constexpr bool inOrder = std::is_same_v<A, Map> || (std::is_same_v<A, MeshGeometry> && !std::is_same_v<B, Map>);

        template <typename A, typename B>
        bool collidePair(const Geometry &a, const Pose &poseA, const Geometry &b, const Pose &poseB)
        {
            if constexpr (isPrimitive<A> && isPrimitive<B>)
            {
                return separateShapes(static_cast<const A &>(a), poseA, static_cast<const B &>(b), poseB, true).lower <=
                       0.;
            }
            else if constexpr (inOrder<A, B>)
            {
                static const fcl::CollisionRequestd request;
                fcl::CollisionResultd &result = clearedResult();
                Traversal<A, B>::collide(&a, poseA, &b, poseB, request, result);
                return result.isCollision();
            }
            else
            {
                return collidePair<B, A>(b, poseB, a, poseA);
            }
        }

        template <typename A, typename B>
        double distancePair(const Geometry &a, const Pose &poseA, const Geometry &b, const Pose &poseB,
                            DistanceSearch &search)
        {
            if constexpr (isPrimitive<A> && isPrimitive<B>)
            {
                const double distance =
                    separateShapes(static_cast<const A &>(a), poseA, static_cast<const B &>(b), poseB, false).lower;
                // A plane that does not separate two shapes tells little of how deep they are in each other.
                return std::min(search.limit, depthIsKnown<A, B> ? distance : std::max(0., distance));
            }
            else if constexpr (inOrder<A, B>)
            {
                const double remembered =
                    rememberedDistance(static_cast<const A &>(a), poseA, static_cast<const B &>(b), poseB, search);
                const double known = std::min(search.limit, remembered);
                fcl::DistanceResultd result(known);
                Traversal<A, B>::distance(&a, poseA, &b, poseB, result);
                if (result.min_distance < known)
                {
                    search.nearestA = result.b1;
                    search.nearestB = result.b2;
                }
                return std::max(0., result.min_distance);
            }
            else
            {
                return distancePair<B, A>(b, poseB, a, poseA, search);
            }
        }

        template <typename A, typename B>
        ConvexSeparation separatePair(const Geometry &a, const Pose &poseA, const Geometry &b, const Pose &poseB)
        {
            return separateShapes(static_cast<const A &>(a), poseA, static_cast<const B &>(b), poseB, false);
        }

        template <typename A, typename B>
        constexpr PairFunctions makePair()
        {
            if constexpr (isPrimitive<A> && isPrimitive<B>)
            {
                return {collidePair<A, B>, distancePair<A, B>, separatePair<A, B>};
            }
            else
            {
                return {collidePair<A, B>, distancePair<A, B>, nullptr};
            }
        }

        constexpr std::size_t kindCount = std::tuple_size_v<Kinds>;
        using Row = std::array<PairFunctions, kindCount>;

        template <typename A, std::size_t... B>
        constexpr Row makeRow(std::index_sequence<B...> /*columns*/)
        {
            return {makePair<A, std::tuple_element_t<B, Kinds>>()...};
        }

        template <std::size_t... A>
        constexpr std::array<Row, kindCount> makeTable(std::index_sequence<A...> rows)
        {
            return {makeRow<std::tuple_element_t<A, Kinds>>(rows)...};
        }

        std::size_t kindOf(const Geometry &geometry)
        {
            switch (geometry.getNodeType())
            {
                case fcl::GEOM_SPHERE:
                    return 0;
                case fcl::GEOM_BOX:
                    return 1;
                case fcl::GEOM_CYLINDER:
                    return 2;
                case fcl::GEOM_CONE:
                    return 3;
                case fcl::BV_OBBRSS:
                    return 4;
                case fcl::GEOM_OCTREE:
                    return 5;
                default:
                    throw std::invalid_argument("pairFunctions: this kind of FCL geometry is not supported");
            }
        }
    }  // namespace

    const PairFunctions &pairFunctions(const Geometry &a, const Geometry &b)
    {
        static constexpr std::array<Row, kindCount> table = makeTable(std::make_index_sequence<kindCount>());
        return table[kindOf(a)][kindOf(b)];
    }
}  // namespace ompl_mfa::collision
