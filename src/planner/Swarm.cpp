#include "ompl_mfa/planner/Swarm.h"

#include <algorithm>
#include <utility>

namespace ompl_mfa
{
    namespace
    {
        /* Candidates on a slice: the brightest fireflies and as many fresh states. */
        constexpr std::size_t FIREFLY_CANDIDATES = 20;
        constexpr std::size_t FRESH_CANDIDATES = 16;
    }  // namespace

    Swarm::Swarm(SliceFrame frame, PathEvaluator &evaluator, const FireflyOptimizer::Settings &settings,
                 std::uint64_t seed, SliceObjective::ValidPathEvent validPath)
      : frame_(std::move(frame))
      , objective_(frame_, evaluator, std::move(validPath))
      , graph_(frame_, evaluator)
      , random_(seed + 1)
      , point_(frame_.chart()->space())
      , coordinates_(frame_.dimension())
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

    bool Swarm::recombine(const Waypoints &path, double bound, std::uint64_t work, Waypoints &found)
    {
        graph_.clear();
        point_.resize(1);
        const auto &order = fireflies_->order();
        const std::size_t count = std::min(FIREFLY_CANDIDATES, order.size());
        for (std::size_t k = 0; k < frame_.slices(); ++k)
        {
            for (std::size_t i = 0; i < count; ++i)
            {
                frame_.toState(k, fireflies_->population().col(order[i]), point_[0]);
                graph_.addCandidate(k, point_[0]);
            }
            const auto [first, coordinates] = frame_.sliceRange(k);
            for (std::size_t i = 0; i < FRESH_CANDIDATES; ++i)
            {
                for (Eigen::Index j = first; j < first + coordinates; ++j)
                    coordinates_[j] = frame_.lower()[j] + (frame_.upper()[j] - frame_.lower()[j]) * random_.uniform();
                frame_.toState(k, coordinates_, point_[0]);
                graph_.addCandidate(k, point_[0]);
            }
        }
        if (!path.empty())
            graph_.addCandidates(path);
        return graph_.search(bound, work, found);
    }

    bool Swarm::step(const FireflyOptimizer::StopCondition &stop)
    {
        if (fireflies_->generation() >= fireflies_->settings().generations)
            beginEpoch();
        return fireflies_->step(objective_, stop);
    }
}  // namespace ompl_mfa
