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

    Swarm::Swarm(SliceFrame frame, Coordinates coordinates, PathEvaluator &evaluator,
                 const FireflyOptimizer::Settings &settings, std::uint64_t seed,
                 SliceObjective::ValidPathEvent validPath)
      : frame_(std::move(frame))
      , modes_(coordinates == Coordinates::Modes && SliceModes::exist(frame_) ? std::make_unique<SliceModes>(frame_)
                                                                              : nullptr)
      , objective_(frame_, modes_.get(), evaluator, std::move(validPath))
      , graph_(frame_, evaluator)
      , random_(seed + 1)
      , point_(frame_.chart()->space())
      , coordinates_(frame_.dimension())
      , seed_(seed)
      , fireflies_(makeFireflies(settings, seed))
    {
    }

    std::unique_ptr<FireflyOptimizer> Swarm::makeFireflies(const FireflyOptimizer::Settings &settings,
                                                           std::uint64_t seed) const
    {
        return modes_ ? std::make_unique<FireflyOptimizer>(settings, modes_->lower(), modes_->upper(), seed)
                      : std::make_unique<FireflyOptimizer>(settings, frame_.lower(), frame_.upper(), seed);
    }

    /* Leaves the coordinates of a firefly's path in coordinates_. */
    void Swarm::offsetsOf(Eigen::Index i) const
    {
        if (modes_)
            modes_->toCoordinates(fireflies_->population().col(i), coordinates_);
        else
            coordinates_ = fireflies_->population().col(i);
    }

    void Swarm::pathOf(Eigen::Index i, Waypoints &path) const
    {
        offsetsOf(i);
        frame_.toWaypoints(coordinates_, path);
    }

    void Swarm::inject(const Waypoints &path)
    {
        Eigen::VectorXd x(frame_.dimension());
        frame_.toCoordinates(path, x);
        if (modes_)
        {
            coordinates_ = x;
            modes_->toAmplitudes(coordinates_, x);
        }
        fireflies_->inject(x);
    }

    void Swarm::beginEpoch()
    {
        const FireflyOptimizer &old = *fireflies_;
        ++epoch_;
        auto fresh = makeFireflies(old.settings(), seed_ + epoch_);
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
        for (std::size_t i = 0; i < count; ++i)
        {
            offsetsOf(order[i]);
            for (std::size_t k = 0; k < frame_.slices(); ++k)
            {
                frame_.toState(k, coordinates_, point_[0]);
                graph_.addCandidate(k, point_[0]);
            }
        }
        for (std::size_t k = 0; k < frame_.slices(); ++k)
        {
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
