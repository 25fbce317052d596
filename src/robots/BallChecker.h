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

#ifndef OMPL_MFA_ROBOTS_BALL_CHECKER_
#define OMPL_MFA_ROBOTS_BALL_CHECKER_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ompl_mfa/robots/RobotKinematics.h"

namespace ompl_mfa::robots
{
    /** \brief A robot of balls among primitives, in the order in which a check needs it. */
    struct BallModel
    {
        struct Ball
        {
            fcl::Vector3d centre;
            double radius;
        };

        /** \brief A link: a body, a ball that contains all its balls, and these: padded ones for the world. */
        struct Link
        {
            std::size_t body;
            Ball hull;
            std::vector<Ball> world;
            std::vector<Ball> self;
        };

        enum class Shape
        {
            Box,
            Ball,
            Cylinder
        };

        struct Obstacle
        {
            Shape shape;

            /** \brief Rotation to the frame of the shape, and its position in the world. */
            fcl::Matrix3d toShape;
            fcl::Vector3d position;

            /** \brief Half the sides of a box; radius of a ball; radius and half the height of a cylinder. */
            fcl::Vector3d size;

            /** \brief Radius of a ball that contains it. */
            double reach;
        };

        /** \brief A link with the obstacles that it may not touch, or with another link. */
        struct Test
        {
            std::size_t first;
            std::size_t second;
            bool isWorld;
            std::vector<std::size_t> obstacles;
        };

        std::vector<Link> links;
        std::vector<Obstacle> obstacles;
        std::vector<Test> tests;
    };

    /** \brief Checks several states at once with the vector instructions of the processor.

        Each lane makes the same operations in the same order, so the answers do not depend on the instructions. Const
        functions are safe to call from several threads and allocate nothing after a thread's first call. */
    class BallChecker
    {
    public:
        /** \brief Number of states that are checked at once. */
        static constexpr std::size_t LANES = 4;

        enum class Instructions
        {
            /** \brief The best that the processor has. */
            Best,

            /** \brief One state at a time. */
            Scalar
        };

        BallChecker(const RobotKinematics &kinematics, BallModel model, Instructions instructions = Instructions::Best);

        /** \brief Check up to LANES states. \param states `count` pointers to the values of the joints.
            \param hitTest set to the test that found the last collision, if there is any.
            \param stopAtFirst stop as soon as one state collides; the others are not known then.
            \return a mask with a bit for each state that collides. */
        unsigned int collide(const double *const *states, std::size_t count, const std::vector<std::uint32_t> &order,
                             bool stopAtFirst, std::uint32_t &hitTest) const;

    private:
        const RobotKinematics &kinematics_;
        BallModel model_;
        Instructions instructions_;
        bool hasAvx2_{false};
    };
}  // namespace ompl_mfa::robots

#endif
