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

/* Accuracy of the distance between two primitives by FCL's solvers and by this library, over random pairs of each two
   kinds. The distance of any two points of the shapes is a proven upper bound; a distance is wrong at least by the
   amount by which it exceeds this bound. Prints the table of docs/collision.md.

   distance_accuracy [PAIRS] */

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>

#include <fcl/narrowphase/distance.h>

#include "collision/NarrowPhase.h"
#include "ompl_mfa/collision/Primitive.h"

namespace ompl_mfa::collision
{
    namespace
    {
        using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

        struct Pair
        {
            Geometry a;
            Geometry b;
            fcl::Transform3d poseA;
            fcl::Transform3d poseB;
        };

        // Primitives of size around 1, some overlapping and some disjoint.
        class RandomPairs
        {
        public:
            Pair draw(const PrimitiveKind &a, const PrimitiveKind &b)
            {
                return {primitive(a), primitive(b), pose(), pose()};
            }

        private:
            double uniform(double low, double high)
            {
                return std::uniform_real_distribution<double>(low, high)(random_);
            }

            Geometry primitive(const PrimitiveKind &kind)
            {
                std::vector<double> dimensions;
                for (std::size_t i = 0; i < kind.dimensions.size(); ++i)
                {
                    dimensions.push_back(uniform(0.1, 1.5));
                }
                return makePrimitive(kind, dimensions);
            }

            fcl::Transform3d pose()
            {
                std::normal_distribution<double> normal;
                const Eigen::Quaterniond turn(normal(random_), normal(random_), normal(random_), normal(random_));
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                pose.linear() = turn.normalized().toRotationMatrix();
                pose.translation() << uniform(-1.5, 1.5), uniform(-1.5, 1.5), uniform(-1.5, 1.5);
                return pose;
            }

            std::mt19937_64 random_{7};
        };

        // Error and time of one method.
        struct Tally
        {
            double error{0.};
            int failures{0};
            std::chrono::duration<double, std::nano> time{0.};

            template <typename Distance>
            void measure(const ConvexSeparation &proven, const Distance &distance)
            {
                const auto start = std::chrono::steady_clock::now();
                try
                {
                    error = std::max(error, distance() - proven.upper);
                }
                catch (const std::exception &)
                {
                    ++failures;
                }
                time += std::chrono::steady_clock::now() - start;
            }
        };

        double fclDistance(const Pair &pair, fcl::GJKSolverType solver, double tolerance)
        {
            const fcl::DistanceRequestd request(false, false, 0., 0., tolerance, solver);
            fcl::DistanceResultd result;
            fcl::distance(pair.a.get(), pair.poseA, pair.b.get(), pair.poseB, request, result);
            return result.min_distance;
        }

        void compare(const PrimitiveKind &kindA, const PrimitiveKind &kindB, int pairs)
        {
            RandomPairs random;
            std::array<Tally, 4> tallies;
            double gap = 0.;
            int apart = 0;
            for (int i = 0; i < pairs; ++i)
            {
                const Pair pair = random.draw(kindA, kindB);
                const auto separate = [&pair]
                { return pairFunctions(*pair.a, *pair.b).separate(*pair.a, pair.poseA, *pair.b, pair.poseB); };
                const ConvexSeparation proven = separate();
                if (proven.lower <= 0.)
                {
                    continue;
                }
                ++apart;
                gap = std::max(gap, proven.upper - proven.lower);
                tallies[0].measure(proven, [&pair] { return fclDistance(pair, fcl::GST_LIBCCD, 1e-6); });
                tallies[1].measure(proven, [&pair] { return fclDistance(pair, fcl::GST_LIBCCD, 1e-10); });
                tallies[2].measure(proven, [&pair] { return fclDistance(pair, fcl::GST_INDEP, 1e-6); });
                tallies[3].measure(proven, [&separate] { return separate().lower; });
            }
            std::printf("| %s, %s | ", kindA.name, kindB.name);
            for (std::size_t i = 0; i < 3; ++i)
            {
                std::printf("%.0e (%.0f ns) | ", tallies[i].error, tallies[i].time.count() / apart);
                if (tallies[i].failures > 0)
                {
                    std::printf("%d thrown | ", tallies[i].failures);
                }
            }
            std::printf("%.0e (%.0f ns) |\n", gap, tallies[3].time.count() / apart);
        }
    }  // namespace
}  // namespace ompl_mfa::collision

int main(int argc, char **argv)
{
    using namespace ompl_mfa::collision;
    const int pairs = argc > 1 ? std::atoi(argv[1]) : 20000;
    std::printf(
        "| pair | FCL, libccd, 1e-6 | FCL, libccd, 1e-10 | FCL, indep, 1e-6 | here: upper - lower bound |\n"
        "|---|---|---|---|---|\n");
    for (std::size_t a = 0; a < primitiveKinds().size(); ++a)
    {
        for (std::size_t b = a; b < primitiveKinds().size(); ++b)
        {
            compare(primitiveKinds()[a], primitiveKinds()[b], pairs);
        }
    }
    return 0;
}
