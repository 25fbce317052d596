#include "ompl_mfa/path/SliceModes.h"

#include <cmath>

#include <boost/math/constants/constants.hpp>

namespace ompl_mfa
{
    bool SliceModes::exist(const SliceFrame &frame)
    {
        for (std::size_t k = 0; k < frame.slices(); ++k)
        {
            if (frame.sliceRange(k).second != frame.sliceRange(0).second)
                return false;
        }
        return frame.dimension() > 0;
    }

    SliceModes::SliceModes(const SliceFrame &frame)
      : frame_(frame)
      , perSlice_(frame.sliceRange(0).second)
      , waves_(frame.slices(), frame.slices())
      , lower_(frame.dimension())
      , upper_(frame.dimension())
    {
        const Eigen::Index m = waves_.rows();
        const double pieces = static_cast<double>(m) + 1.0;
        const double norm = std::sqrt(2.0 / pieces);
        for (Eigen::Index j = 0; j < m; ++j)
        {
            for (Eigen::Index k = 0; k < m; ++k)
                waves_(j, k) = norm * std::sin(boost::math::constants::pi<double>() *
                                               static_cast<double>((j + 1) * (k + 1)) / pieces);
        }
        const Eigen::Map<const Eigen::MatrixXd> lowest(frame.lower().data(), perSlice_, m);
        const Eigen::Map<const Eigen::MatrixXd> highest(frame.upper().data(), perSlice_, m);
        const Eigen::VectorXd height = highest.rowwise().maxCoeff().cwiseMax(-lowest.rowwise().minCoeff());
        for (Eigen::Index k = 0; k < m; ++k)
            upper_.segment(k * perSlice_, perSlice_) = height / (norm * static_cast<double>(k + 1));
        lower_ = -upper_;
    }

    void SliceModes::toCoordinates(const Eigen::Ref<const Eigen::VectorXd> &amplitudes,
                                   Eigen::Ref<Eigen::VectorXd> x) const
    {
        const Eigen::Index m = waves_.rows();
        Eigen::Map<Eigen::MatrixXd>(x.data(), perSlice_, m).noalias() =
            Eigen::Map<const Eigen::MatrixXd>(amplitudes.data(), perSlice_, m) * waves_;
        x = x.cwiseMax(frame_.lower()).cwiseMin(frame_.upper());
    }

    void SliceModes::toAmplitudes(const Eigen::Ref<const Eigen::VectorXd> &x,
                                  Eigen::Ref<Eigen::VectorXd> amplitudes) const
    {
        const Eigen::Index m = waves_.rows();
        Eigen::Map<Eigen::MatrixXd>(amplitudes.data(), perSlice_, m).noalias() =
            Eigen::Map<const Eigen::MatrixXd>(x.data(), perSlice_, m) * waves_;
    }
}  // namespace ompl_mfa
