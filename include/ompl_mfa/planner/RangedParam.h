#ifndef OMPL_MFA_PLANNER_RANGED_PARAM_
#define OMPL_MFA_PLANNER_RANGED_PARAM_

#include <functional>
#include <string>
#include <utility>

#include <boost/lexical_cast.hpp>

#include <ompl/base/GenericParam.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

namespace ompl_mfa
{
    /** \brief A planner parameter that refuses numbers outside its range, and whose setter may refuse a value as well:
        setValue then warns on OMPL's console with the parameter, the value and what is accepted, returns false and
        changes nothing. */
    template <typename T>
    class RangedParam : public ompl::base::GenericParam
    {
    public:
        using Setter = std::function<void(const T &)>;
        using Getter = std::function<T()>;

        /** \brief \e setter throws ompl::Exception for a value that is not accepted; \e range is OMPL's range
            suggestion, "lowest:step:highest" or the values separated by commas. */
        RangedParam(const std::string &name, Setter setter, Getter getter, const std::string &range)
          : GenericParam(name)
          , setter_(std::move(setter))
          , getter_(std::move(getter))
        {
            setRangeSuggestion(range);
        }

        bool setValue(const std::string &value) override
        {
            try
            {
                const T typed = boost::lexical_cast<T>(value);
                if (!isWithinRange(value))
                {
                    OMPL_WARN("Invalid value for parameter '%s': %s is out of range; accepted: %s", name_.c_str(),
                              value.c_str(), rangeSuggestion_.c_str());
                    return false;
                }
                setter_(typed);
            }
            catch (const boost::bad_lexical_cast &)
            {
                OMPL_WARN("Invalid value for parameter '%s': '%s' is not of the right type; accepted: %s",
                          name_.c_str(), value.c_str(), rangeSuggestion_.c_str());
                return false;
            }
            catch (const ompl::Exception &error)
            {
                OMPL_WARN("Invalid value for parameter '%s': %s", name_.c_str(), error.what());
                return false;
            }
            return true;
        }

        std::string getValue() const override
        {
            return boost::lexical_cast<std::string>(getter_());
        }

    private:
        /* Of the text and not of what it became: lexical_cast turns -1 into the largest unsigned number. */
        bool isWithinRange(const std::string &value) const
        {
            const auto lowestEnd = rangeSuggestion_.find(':');
            if (lowestEnd == std::string::npos)
                return true;
            const double number = boost::lexical_cast<double>(value);
            return number >= boost::lexical_cast<double>(rangeSuggestion_.substr(0, lowestEnd)) &&
                   number <= boost::lexical_cast<double>(rangeSuggestion_.substr(rangeSuggestion_.rfind(':') + 1));
        }

        Setter setter_;
        Getter getter_;
    };
}  // namespace ompl_mfa

#endif
