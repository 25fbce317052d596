#ifndef OMPL_MFA_TEST_PATH_SLOW_PROBLEM_
#define OMPL_MFA_TEST_PATH_SLOW_PROBLEM_

/* A problem whose states take so long to check that several threads are worth waking. It tells how many were in the
   checker at once. */

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <utility>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

namespace ompl_mfa::test
{
    /** \brief Checks a motion as a whole, from its beginning, as a validator of a user's own may. */
    class WholeMotionValidator : public ompl::base::MotionValidator
    {
    public:
        explicit WholeMotionValidator(const ompl::base::SpaceInformationPtr &si)
          : MotionValidator(si)
        {
        }

        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to) const override
        {
            ompl::base::ScopedState<> state(si_->getStateSpace());
            std::pair<ompl::base::State *, double> lastValid(state.get(), 0.0);
            return checkMotion(from, to, lastValid);
        }

        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to,
                         std::pair<ompl::base::State *, double> &lastValid) const override
        {
            const auto &space = si_->getStateSpace();
            const unsigned int count = std::max(1U, space->validSegmentCount(from, to));
            // freed when a checker throws, too
            ompl::base::ScopedState<> state(si_->getStateSpace());
            bool valid = true;
            for (unsigned int i = 1; i <= count && valid; ++i)
            {
                space->interpolate(from, to, static_cast<double>(i) / count, state.get());
                valid = si_->isValid(state.get());
                if (valid)
                    lastValid.second = static_cast<double>(i) / count;
            }
            if (!valid && lastValid.first != nullptr)
                space->interpolate(from, to, lastValid.second, lastValid.first);
            return valid;
        }
    };

    struct SlowProblem
    {
        std::atomic<unsigned int> inside{0};
        std::atomic<unsigned int> mostInside{0};
        std::atomic<std::uint64_t> states{0};
        ompl::base::SpaceInformationPtr si;

        /** \brief Each state takes \e duration. \e wholeMotions: with a WholeMotionValidator, else with OMPL's own. */
        SlowProblem(const ompl::base::StateSpacePtr &space, bool wholeMotions, std::chrono::microseconds duration,
                    const std::function<bool(const ompl::base::State *)> &isValid)
          : si(std::make_shared<ompl::base::SpaceInformation>(space))
        {
            si->setStateValidityChecker(
                [this, isValid, duration](const ompl::base::State *state)
                {
                    const unsigned int now = ++inside;
                    for (unsigned int most = mostInside; now > most && !mostInside.compare_exchange_weak(most, now);)
                    {
                    }
                    const auto end = std::chrono::steady_clock::now() + duration;
                    while (std::chrono::steady_clock::now() < end)
                    {
                    }
                    ++states;
                    --inside;
                    return isValid(state);
                });
            if (wholeMotions)
                si->setMotionValidator(std::make_shared<WholeMotionValidator>(si));
            si->setup();
        }
    };
}  // namespace ompl_mfa::test

#endif
