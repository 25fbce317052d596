#ifndef OMPL_MFA_OPTIMIZER_OBJECTIVE_FUNCTION_
#define OMPL_MFA_OPTIMIZER_OBJECTIVE_FUNCTION_

#include <limits>

#include <Eigen/Core>

namespace ompl_mfa
{
    /** \brief How bright a point is, eq. (1): only the order of two brightnesses matters.

        A point without violation is brighter than any with one. */
    struct Brightness
    {
        /** \brief By how much the constraints are violated; 0 for a feasible point, never negative or NaN. For a path:
            the length of its invalid part, in the unit of the state space's distance. */
        double violation{std::numeric_limits<double>::infinity()};

        /** \brief The objective value. Meaningful only for comparison through ObjectiveFunction::isBrighter. */
        double cost{std::numeric_limits<double>::infinity()};

        bool isFeasible() const
        {
            return violation == 0.0;
        }
    };

    /** \brief What a FireflyOptimizer optimises: a map from R^d to a brightness order. */
    class ObjectiveFunction
    {
    public:
        virtual ~ObjectiveFunction() = default;

        /** \brief The brightness of \e x (d x 1, within the box of the optimiser).

            With a \e rival, the caller only keeps \e x if it is brighter than the rival: the evaluation may stop as
            soon as it is known not to be, and then returns a default-constructed Brightness (infinitely dim). */
        virtual Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) = 0;

        /** \brief Whether \e a is strictly brighter than \e b: less violation first, then lower cost. Override to
            order costs otherwise; the order must be a strict weak order. */
        virtual bool isBrighter(const Brightness &a, const Brightness &b) const
        {
            if (a.violation != b.violation)
                return a.violation < b.violation;
            return a.cost < b.cost;
        }
    };
}  // namespace ompl_mfa

#endif
