#ifndef OMPL_MFA_BENCHMARKS_PAPER_RECORDER_
#define OMPL_MFA_BENCHMARKS_PAPER_RECORDER_

#include <chrono>

#include "paper/Contender.h"

namespace ompl_mfa::paper
{
    /** \brief Passes evaluations on and writes down how the best so far develops. */
    class Recorder : public ObjectiveFunction
    {
    public:
        Recorder(ObjectiveFunction &objective, double target);

        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) override;
        bool isBrighter(const Brightness &a, const Brightness &b) const override;

        bool isSpent() const
        {
            return run_.evaluations >= BUDGET;
        }

        /** \brief The run so far, its trace filled up to the whole budget. */
        Run finish();

    private:
        double secondsSinceStart() const;

        ObjectiveFunction &objective_;
        double target_;
        std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now()};
        Run run_;
    };
}  // namespace ompl_mfa::paper

#endif
