#include "benchmark/PathMetrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa
{
    og::PathGeometric resamplePath(const og::PathGeometric &path, double step)
    {
        constexpr double MOST_MOTIONS = 5000.0;
        const ob::SpaceInformationPtr &si = path.getSpaceInformation();
        const ob::StateSpacePtr &space = si->getStateSpace();
        const double length = path.length();
        if (path.getStateCount() < 2 || !(length > 0.0))
        {
            return path;
        }
        const auto motions = static_cast<std::size_t>(std::clamp(std::ceil(length / step), 1.0, MOST_MOTIONS));

        og::PathGeometric resampled(si, path.getState(0));
        ob::ScopedState<> state(space);
        std::size_t segment = 0;
        double passed = 0.0;
        double segmentLength = space->distance(path.getState(0), path.getState(1));
        for (std::size_t i = 1; i < motions; ++i)
        {
            const double target = length * static_cast<double>(i) / static_cast<double>(motions);
            while (passed + segmentLength < target && segment + 2 < path.getStateCount())
            {
                passed += segmentLength;
                ++segment;
                segmentLength = space->distance(path.getState(segment), path.getState(segment + 1));
            }
            const double part = segmentLength > 0.0 ? std::clamp((target - passed) / segmentLength, 0.0, 1.0) : 0.0;
            space->interpolate(path.getState(segment), path.getState(segment + 1), part, state.get());
            space->enforceBounds(state.get());
            resampled.append(state.get());
        }
        resampled.append(path.getState(path.getStateCount() - 1));
        return resampled;
    }

    PathMetrics measurePath(const og::PathGeometric &path)
    {
        const ob::SpaceInformationPtr &si = path.getSpaceInformation();
        og::PathGeometric resampled = resamplePath(path, si->getStateSpace()->getLongestValidSegmentLength());
        PathMetrics metrics;
        metrics.minimumClearance = std::numeric_limits<double>::infinity();
        for (const ob::State *state : resampled.getStates())
        {
            metrics.minimumClearance =
                std::min(metrics.minimumClearance, si->getStateValidityChecker()->clearance(state));
        }
        metrics.smoothness = resampled.smoothness();
        return metrics;
    }
}  // namespace ompl_mfa
