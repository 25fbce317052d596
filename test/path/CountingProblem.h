#ifndef OMPL_MFA_TEST_PATH_COUNTING_PROBLEM_
#define OMPL_MFA_TEST_PATH_COUNTING_PROBLEM_

/* A space information that counts what is asked of it. */

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/SpaceInformation.h>

namespace ompl_mfa::test
{
    class CountingMotionValidator : public ompl::base::DiscreteMotionValidator
    {
    public:
        CountingMotionValidator(const ompl::base::SpaceInformationPtr &si, std::atomic<std::uint64_t> &count)
          : DiscreteMotionValidator(si)
          , count_(count)
        {
        }

        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to) const override
        {
            ++count_;
            return DiscreteMotionValidator::checkMotion(from, to);
        }

        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to,
                         std::pair<ompl::base::State *, double> &lastValid) const override
        {
            ++count_;
            return DiscreteMotionValidator::checkMotion(from, to, lastValid);
        }

    private:
        std::atomic<std::uint64_t> &count_;
    };

    struct CountingProblem
    {
        std::atomic<std::uint64_t> states{0};
        std::atomic<std::uint64_t> motions{0};
        ompl::base::SpaceInformationPtr si;

        CountingProblem(const ompl::base::StateSpacePtr &space,
                        const std::function<bool(const ompl::base::State *)> &isValid)
          : si(std::make_shared<ompl::base::SpaceInformation>(space))
        {
            si->setStateValidityChecker(
                [this, isValid](const ompl::base::State *state)
                {
                    ++states;
                    return isValid(state);
                });
            si->setMotionValidator(std::make_shared<CountingMotionValidator>(si, motions));
            si->setup();
        }

        void forget()
        {
            states = 0;
            motions = 0;
        }
    };
}  // namespace ompl_mfa::test

#endif
