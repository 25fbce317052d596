#ifndef OMPL_MFA_COLLISION_SCENE_WARNINGS_
#define OMPL_MFA_COLLISION_SCENE_WARNINGS_

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace ompl_mfa::collision
{
    /** \brief Write a warning about a file to OMPL's console, in one line whatever the file held. */
    void warnOfScene(const std::string &text);

    /** \brief The fields of an object that its message leaves unset, which MoveIt takes as identity. */
    class UnsetFields
    {
    public:
        /** \brief Note a field; one that is noted already is not noted again. */
        void add(const std::string &field);

        /** \brief One warning for all of them, if there are any. Forgets them.
            \param owner the object at the head of the warning, with its place. */
        void warn(const std::string &owner);

    private:
        std::vector<std::string> fields_;
    };

    /** \brief The rotation of a quaternion x y z w of any length. All 0 is a quaternion that nobody set: identity,
        noted as unset.
        \return empty where the length is next to 0 but not 0. */
    std::optional<Eigen::Matrix3d> rotationOf(const Eigen::Vector4d &xyzw, const std::string &field,
                                              UnsetFields &unset);
}  // namespace ompl_mfa::collision

#endif
