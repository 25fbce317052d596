#ifndef OMPL_MFA_PATH_EXACT_TYPE_
#define OMPL_MFA_PATH_EXACT_TYPE_

#include <typeinfo>

namespace ompl_mfa
{
    /** \brief Whether \e object, known as its \e Base, is of one of the \e Types itself and not of a type that a user
        derived from it, which may behave otherwise. */
    template <typename... Types, typename Base>
    bool isExactly(const Base &object)
    {
        return ((typeid(object) == typeid(Types)) || ...);
    }
}  // namespace ompl_mfa

#endif
