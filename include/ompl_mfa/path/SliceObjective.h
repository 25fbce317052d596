#ifndef OMPL_MFA_PATH_SLICE_OBJECTIVE_
#define OMPL_MFA_PATH_SLICE_OBJECTIVE_

#include <functional>

#include "ompl_mfa/optimizer/ObjectiveFunction.h"
#include "ompl_mfa/path/PathEvaluator.h"
#include "ompl_mfa/path/SliceFrame.h"
#include "ompl_mfa/path/SliceModes.h"

namespace ompl_mfa
{
    /** \brief What the fireflies optimise: the brightness of the path at the coordinates of a SliceFrame, or at the
        amplitudes of its modes. Frame, modes and evaluator must outlive it. */
    class SliceObjective : public ObjectiveFunction
    {
    public:
        /** \brief Called with every valid path that an evaluation comes upon. */
        using ValidPathEvent = std::function<void(const Waypoints &path, const Brightness &brightness)>;

        /** \brief \e modes may be null. */
        SliceObjective(const SliceFrame &frame, const SliceModes *modes, PathEvaluator &evaluator,
                       ValidPathEvent validPath);

        /** \brief From now on a path must be better than \e bound to be of any use: one that is not is not checked for
            collision, and is dimmer than any that is, by its distance from the bound. Infinite: no bound. */
        void setBound(double bound);

        /** \brief As in PathEvaluator::evaluate; 1 at first. */
        void setStride(unsigned int stride);

        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) override;
        bool isBrighter(const Brightness &a, const Brightness &b) const override;

    private:
        const SliceFrame &frame_;
        const SliceModes *modes_;
        PathEvaluator &evaluator_;
        ValidPathEvent validPath_;
        Waypoints path_;
        Eigen::VectorXd coordinates_;
        double bound_;
        unsigned int stride_{1};
        double beyondBound_;  ///< larger than the violation of any path that keeps to the bound
    };
}  // namespace ompl_mfa

#endif
