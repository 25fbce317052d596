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

#ifndef OMPL_MFA_ROBOTS_ROBOT_COLLISION_
#define OMPL_MFA_ROBOTS_ROBOT_COLLISION_

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/RobotScene.h"
#include "ompl_mfa/robots/RobotKinematics.h"
#include "ompl_mfa/robots/RobotModel.h"
#include "ompl_mfa/robots/RobotSemantics.h"

namespace ompl_mfa::robots
{
    /** \brief A robot in a scene: which joints move, and where everything else is. */
    struct PlacedRobot
    {
        std::shared_ptr<const RobotModel> model;
        std::shared_ptr<const RobotSemantics> semantics;
        std::shared_ptr<const collision::RobotScene> scene;

        /** \brief Joints that vary, by their indices. */
        std::vector<std::size_t> group;

        /** \brief Values of all joints, radians or metres; those of the group are not used. */
        std::vector<double> values;

        /** \brief Pose of the robot's root in the planning frame. */
        fcl::Transform3d base{fcl::Transform3d::Identity()};

        /** \brief Added to the padding of every link, metres. */
        double padding{0.};
    };

    /** \brief Two links or objects that touch. */
    struct RobotContact
    {
        /** \brief Name of a link or an attached object. */
        std::string first;

        /** \brief Name of a link, an attached object or an obstacle. */
        std::string second;

        /** \brief How far the first has to be moved, at most, until the two are apart, metres. */
        double depth{0.};
    };

    /** \brief Collisions and distances of a robot's links with the world and with each other.

        Checked are the links that the group moves with every obstacle, and all pairs of links that move relative to
       each other, unless the scene's allowed collision matrix or, where that says nothing, the semantics allow them to
       touch. Attached objects are links of their own, which may touch their link and their `touch_links`. As in MoveIt,
       padding and scale apply to collisions with the world only.

        Const functions are safe to call from several threads and allocate nothing after a thread's first call. */
    class OMPL_MFA_EXPORT RobotCollision
    {
    public:
        /** \throw std::invalid_argument if something in `robot` is null, or as RobotKinematics does.
            \throw InputError if a padding or scale leaves nothing of a link, or an attached object is on a link or has
            touch links that the robot does not have. */
        explicit RobotCollision(const PlacedRobot &robot);
        ~RobotCollision();
        RobotCollision(const RobotCollision &) = delete;
        RobotCollision &operator=(const RobotCollision &) = delete;

        const RobotKinematics &kinematics() const
        {
            return kinematics_;
        }

        /** \brief Whether a pair touches. \param q one value for each joint of the group. */
        bool collides(const double *q) const;

        /** \brief Whether one of several states collides. Faster than one call for each if isOfBalls().
            \param states `count` pointers to the values of the joints. */
        bool anyCollides(const double *const *states, std::size_t count) const;

        /** \brief Index of the first of several states that collides; `count` if none does. */
        std::size_t firstColliding(const double *const *states, std::size_t count) const;

        /** \brief Whether all links are balls and all obstacles boxes, balls and cylinders, so that several states are
            checked at once by the vector instructions of the processor. */
        bool isOfBalls() const;

        /** \brief Smallest distance of the pairs that are checked, metres, or `limit` > 0 if it is at least that. If
            shapes overlap, it is minus the depth where that is known in closed form, as of balls in primitives, else 0.
         */
        double distance(const double *q, double limit = std::numeric_limits<double>::infinity()) const;

        /** \brief Fraction of the motion q(t) = from + t * difference, t in [0, 1], up to which no pair comes within
            `tolerance` > 0 (metres), by conservative advancement; 1 if the whole motion is free. A motion that needs
           more than 1000 steps counts as touching where the last one ends. \param from is assumed to be free. \param
           untilFirst return any fraction below 1 as soon as one pair touches. */
        double advance(const double *from, const double *difference, double tolerance, bool untilFirst) const;

        /** \brief All pairs that touch, for messages. */
        std::vector<RobotContact> contacts(const double *q) const;

        /** \brief All pairs of links and attached objects that are checked, by their names. */
        std::vector<std::pair<std::string, std::string>> checkedPairs() const;

        /** \brief All pairs of a link or attached object with an obstacle that are checked, by their names. */
        std::vector<std::pair<std::string, std::string>> checkedObstacles() const;

        /** \brief Diagonal of the box around all obstacles and the robot's balls at rest, metres: the scale of the
         * scene. */
        double extent() const;

    private:
        struct Data;
        struct Scratch;
        struct Part;
        struct LinkItem;
        struct Cover;

        void addLinks(const PlacedRobot &robot);
        void addAttached(const PlacedRobot &robot);
        void addObstacles(const PlacedRobot &robot);
        void addPairs(const PlacedRobot &robot);
        void addBalls();
        Scratch &place(const double *q) const;
        bool test(std::uint32_t item, Scratch &scratch) const;
        double itemDistance(std::uint32_t item, Scratch &scratch, double limit) const;
        bool hitsWorld(const LinkItem &link, Scratch &scratch) const;
        bool hitsLink(const LinkItem &first, const LinkItem &second, Scratch &scratch) const;
        double worldDistance(const LinkItem &link, Scratch &scratch, double limit) const;
        double linkDistance(const LinkItem &first, const LinkItem &second, Scratch &scratch, double limit) const;

        bool touchesObstacle(const LinkItem &link, std::size_t obstacle, const fcl::Vector3d &offset,
                             Scratch &scratch) const;
        bool touchesLink(const LinkItem &link, const LinkItem &other, const fcl::Vector3d &offset,
                         Scratch &scratch) const;

        RobotKinematics kinematics_;
        std::unique_ptr<Data> data_;
    };
}  // namespace ompl_mfa::robots

#endif
