#include "ompl_mfa/planner/Swarm.h"

#include <algorithm>
#include <utility>

namespace ompl_mfa
{
    Swarm::Swarm(SliceFrame frame, PathEvaluator &evaluator, const FireflyOptimizer::Settings &settings,
                 std::uint64_t seed, SliceObjective::ValidPathEvent validPath)
      : frame_(std::move(frame))
      , objective_(frame_, evaluator, std::move(validPath))
      , seed_(seed)
      , fireflies_(std::make_unique<FireflyOptimizer>(settings, frame_.lower(), frame_.upper(), seed))
    {
    }

    void Swarm::inject(const Waypoints &path)
    {
        Eigen::VectorXd x(frame_.dimension());
        frame_.toCoordinates(path, x);
        fireflies_->inject(x);
    }

    void Swarm::beginEpoch()
    {
        const FireflyOptimizer &old = *fireflies_;
        ++epoch_;
        auto fresh = std::make_unique<FireflyOptimizer>(old.settings(), frame_.lower(), frame_.upper(), seed_ + epoch_);
        fresh->inject(old.best());
        const std::size_t elites = old.order().size() / 5;
        for (std::size_t i = 1; i < elites; ++i)
            fresh->inject(old.population().col(old.order()[i]));
        earlierEvaluations_ += old.evaluations();
        fireflies_ = std::move(fresh);
    }

    bool Swarm::step(const FireflyOptimizer::StopCondition &stop)
    {
        if (fireflies_->generation() >= fireflies_->settings().generations)
            beginEpoch();
        return fireflies_->step(objective_, stop);
    }
}  // namespace ompl_mfa
