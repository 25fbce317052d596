#include "collision/SceneWarnings.h"

#include <algorithm>

#include <ompl/util/Console.h>

namespace ompl_mfa::collision
{
    void warnOfScene(const std::string &text)
    {
        std::string line = text;
        // Names come from the file and may hold what a terminal obeys.
        std::replace_if(
            line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
        OMPL_WARN("%s", line.c_str());
    }

    void UnsetFields::add(const std::string &field)
    {
        if (std::find(fields_.begin(), fields_.end(), field) == fields_.end())
        {
            fields_.push_back(field);
        }
    }

    void UnsetFields::warn(const std::string &owner)
    {
        if (fields_.empty())
        {
            return;
        }
        std::string list;
        for (const std::string &field : fields_)
        {
            list += (list.empty() ? "" : ", ") + field;
        }
        fields_.clear();
        warnOfScene(owner + ": not set and taken as identity, as MoveIt does: " + list);
    }

    std::optional<Eigen::Matrix3d> rotationOf(const Eigen::Vector4d &xyzw, const std::string &field, UnsetFields &unset)
    {
        if (xyzw.isZero(0.))
        {
            unset.add(field + " (0 0 0 0)");
            return Eigen::Matrix3d::Identity();
        }
        // Not of unit length to the digits that a file has is normal; next to zero has no direction at all.
        const double length = xyzw.stableNorm();
        if (length < 1e-6)
        {
            return std::nullopt;
        }
        return Eigen::Quaterniond(xyzw / length).toRotationMatrix();
    }
}  // namespace ompl_mfa::collision
