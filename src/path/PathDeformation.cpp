#include "path/PathDeformation.h"

#include <algorithm>

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* Walks along a path from its beginning to its end. */
        class Walk
        {
        public:
            explicit Walk(const Waypoints &path)
              : path_(path)
              , motion_(path.space()->distance(path[0], path[1]))
            {
            }

            /* The state at a distance from the beginning that is not less than that of the last call. */
            void stateAt(double distance, ob::State *state)
            {
                while (behind_ + motion_ < distance && next_ + 1 < path_.size())
                {
                    behind_ += motion_;
                    ++next_;
                    motion_ = path_.space()->distance(path_[next_ - 1], path_[next_]);
                }
                const double part = motion_ > 0.0 ? std::min(1.0, (distance - behind_) / motion_) : 0.0;
                path_.space()->interpolate(path_[next_ - 1], path_[next_], part, state);
                path_.space()->enforceBounds(state);
            }

        private:
            const Waypoints &path_;
            std::size_t next_{1};
            double behind_{0.0};  ///< length before the motion to next_
            double motion_;
        };
    }  // namespace

    bool seemDeformable(PathEvaluator &evaluator, const Waypoints &path, const Waypoints &other, unsigned int rungs)
    {
        Walk walk(path);
        Walk otherWalk(other);
        const double step = path.length() / (rungs + 1);
        const double otherStep = other.length() / (rungs + 1);
        Waypoints ends(path.space());
        ends.resize(2);
        for (unsigned int k = 1; k <= rungs; ++k)
        {
            walk.stateAt(k * step, ends[0]);
            otherWalk.stateAt(k * otherStep, ends[1]);
            if (!evaluator.checkMotion(ends[0], ends[1]))
                return false;
        }
        return true;
    }
}  // namespace ompl_mfa
