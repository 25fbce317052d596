#ifndef OMPL_MFA_PLANNER_RANGED_PARAM_
#define OMPL_MFA_PLANNER_RANGED_PARAM_

#include <functional>
#include <string>
#include <utility>

#include <ompl/base/GenericParam.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "planner/AcceptedValues.h"

namespace ompl_mfa
{
    /** \brief A planner parameter that says which values it accepts. */
    class SelectiveParam : public ompl::base::GenericParam
    {
    public:
        using GenericParam::GenericParam;

        /** \brief The accepted values as people name them: "0, 4 to 10000". */
        virtual std::string accepted() const = 0;
    };

    /** \brief A planner parameter that accepts only some values. For any other setValue warns on OMPL's console with
        the parameter, the value and what is accepted, returns false and changes nothing. Blanks around a value do not
        count. What getValue returns, setValue accepts. */
    template <typename T>
    class RangedParam : public SelectiveParam
    {
    public:
        using Setter = std::function<void(const T &)>;
        using Getter = std::function<T()>;

        /** \brief \e setter is called with accepted values only. */
        RangedParam(const std::string &name, AcceptedValues<T> accepted, Setter setter, Getter getter)
          : SelectiveParam(name)
          , accepted_(std::move(accepted))
          , setter_(std::move(setter))
          , getter_(std::move(getter))
        {
            setRangeSuggestion(accepted_.suggestion());
        }

        bool setValue(const std::string &value) override
        {
            T typed{};
            try
            {
                if (!accepted_.read(withoutBlanks(value), typed))
                    throw ompl::Exception(name_ + " = '" + value + "' is not of the right type; accepted is " +
                                          accepted_.description());
                require(accepted_, name_, typed);
            }
            catch (const ompl::Exception &error)
            {
                OMPL_WARN("Invalid value for a parameter: %s", error.what());
                return false;
            }
            setter_(typed);
            return true;
        }

        std::string getValue() const override
        {
            return accepted_.write(getter_());
        }

        std::string accepted() const override
        {
            return accepted_.description();
        }

    private:
        static std::string withoutBlanks(const std::string &text)
        {
            const char *const blanks = " \t\r\n";
            const auto first = text.find_first_not_of(blanks);
            if (first == std::string::npos)
                return {};
            return text.substr(first, text.find_last_not_of(blanks) - first + 1);
        }

        AcceptedValues<T> accepted_;
        Setter setter_;
        Getter getter_;
    };
}  // namespace ompl_mfa

#endif
