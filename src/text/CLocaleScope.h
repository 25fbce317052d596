#ifndef OMPL_MFA_TEXT_CLOCALE_SCOPE_
#define OMPL_MFA_TEXT_CLOCALE_SCOPE_

#include <locale.h>

namespace ompl_mfa
{
    /** \brief For as long as it lives, the C library of this thread works in the locale "C".

        For calls into libraries that convert numbers with strtod() and the like. Other threads keep their locale. */
    class CLocaleScope
    {
    public:
        CLocaleScope()
          : before_(uselocale(plain()))
        {
        }

        ~CLocaleScope()
        {
            uselocale(before_);
        }

        CLocaleScope(const CLocaleScope &) = delete;
        CLocaleScope &operator=(const CLocaleScope &) = delete;

    private:
        static locale_t plain()
        {
            static const locale_t made = newlocale(LC_ALL_MASK, "C", locale_t());
            return made;
        }

        locale_t before_;
    };
}  // namespace ompl_mfa

#endif
