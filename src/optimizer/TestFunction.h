#ifndef OMPL_MFA_OPTIMIZER_TEST_FUNCTION_
#define OMPL_MFA_OPTIMIZER_TEST_FUNCTION_

#include <string>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/optimizer/ObjectiveFunction.h"

namespace ompl_mfa
{
    /** \brief A function with known global optimum, over a cube in R^d. */
    class TestFunction : public ObjectiveFunction
    {
    public:
        /** \brief \e name is one of names(): throws InputError for another. \e dimension is d >= 1, for rosenbrock
            d >= 2: throws InputError. With a \e shift (d x 1, or empty for none) the optimum lies that much farther
            from where the literature puts it, which shows an optimiser that favours the centre; the cube stays. */
        TestFunction(const std::string &name, unsigned int dimension, const Eigen::VectorXd &shift = {});

        /** \brief sinc is eq. (19), the others are those of the literature (Surjanovic and Bingham, Virtual Library of
            Simulation Experiments). */
        static const std::vector<std::string> &names();

        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) override;

        /** \brief The value of the function itself; sinc is to be maximised, the others to be minimised. */
        double value(const Eigen::Ref<const Eigen::VectorXd> &x) const;

        /** \brief The value of the function for a cost of Brightness. */
        double valueOf(const Brightness &brightness) const;

        const std::string &name() const
        {
            return name_;
        }

        /** \brief d x 1. */
        Eigen::VectorXd lower() const;
        Eigen::VectorXd upper() const;

        /** \brief The global optimum, d x 1. */
        Eigen::VectorXd optimum() const;

        /** \brief Whether \e x lies within 5 % of the cube's edge from the global optimum: 0.5 for eq. (19). */
        bool isNearOptimum(const Eigen::Ref<const Eigen::VectorXd> &x) const;

    private:
        std::string name_;
        Eigen::Index dimension_;
        double lower_;
        double upper_;

        /** \brief Every coordinate of the unshifted optimum. */
        double optimum_;
        Eigen::VectorXd shift_;
        double (*function_)(const Eigen::VectorXd &x);
        bool maximised_;
    };
}  // namespace ompl_mfa

#endif
