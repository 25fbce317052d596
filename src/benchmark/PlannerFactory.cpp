/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#include "ompl_mfa/benchmark/PlannerFactory.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>

#include <boost/algorithm/string.hpp>

#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "benchmark/NoWarnings.h"
#include "benchmark/PlannerTable.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "planner/RangedParam.h"
#include "text/NearestName.h"
#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;

        enum class ValueType
        {
            Switch,
            Integer,
            Unsigned,
            Real,
            Text
        };

        template <typename... Types>
        bool isOneOf(const ob::GenericParam &parameter)
        {
            return ((dynamic_cast<const ob::SpecificParam<Types> *>(&parameter) ||
                     dynamic_cast<const planner::RangedParam<Types> *>(&parameter)) ||
                    ...);
        }

        ValueType valueType(const ob::GenericParam &parameter)
        {
            if (isOneOf<bool>(parameter))
            {
                return ValueType::Switch;
            }
            if (isOneOf<int, long, long long>(parameter))
            {
                return ValueType::Integer;
            }
            if (isOneOf<unsigned int, unsigned long, unsigned long long>(parameter))
            {
                return ValueType::Unsigned;
            }
            if (isOneOf<float, double, long double>(parameter))
            {
                return ValueType::Real;
            }
            return ValueType::Text;
        }

        std::string typeName(ValueType type)
        {
            static const char *const NAMES[] = {"bool", "integer", "unsigned", "real", "text"};
            return NAMES[static_cast<std::size_t>(type)];
        }

        /* The limits of "first:last" and "first:step:last"; false for lists and for parameters without a range. */
        bool rangeEnds(const std::string &range, double &first, double &last)
        {
            std::vector<std::string> parts;
            boost::split(parts, range, boost::is_any_of(":"));
            if (parts.size() < 2)
            {
                return false;
            }
            return text::readNumber(trimmed(parts.front()), first) && text::readNumber(trimmed(parts.back()), last);
        }

        /* OMPL's ranges are suggestions, and its own sample configs exceed some of them. Only negative values outside
           the range and fractions above 1 are invalid for all planners of OMPL. */
        void checkRange(const ConfigEntry &entry, const std::string &range, double value)
        {
            double first = 0.0;
            double last = 0.0;
            if (!rangeEnds(range, first, last))
            {
                return;
            }
            const bool isFraction = first == 0.0 && last == 1.0;
            const bool isOutside = isFraction ? value < first || value > last : first >= 0.0 && value < 0.0;
            if (isOutside)
            {
                failAt(entry, "out of the range " + range);
            }
        }

        void checkChoice(const ConfigEntry &entry, const std::string &range)
        {
            std::vector<std::string> choices;
            boost::split(choices, range, boost::is_any_of(","));
            if (choices.size() > 1 && std::find(choices.begin(), choices.end(), entry.value) == choices.end())
            {
                failAt(entry, "expected one of " + range);
            }
        }

        /* The checked text for OMPL, whose own conversion accepts "12abc" as 12 and "-1" as an unsigned number. */
        std::string checkedValue(const ob::GenericParam &parameter, const ConfigEntry &entry)
        {
            const std::string &range = parameter.getRangeSuggestion();
            switch (valueType(parameter))
            {
                case ValueType::Switch:
                    return switchValue(entry) ? "1" : "0";
                case ValueType::Integer:
                case ValueType::Unsigned:
                {
                    const double number = realValue(entry);
                    const bool isUnsigned = valueType(parameter) == ValueType::Unsigned;
                    const double most = isUnsigned ? std::numeric_limits<std::uint32_t>::max()
                                                   : std::numeric_limits<std::int32_t>::max();
                    if (number != std::floor(number) || number > most || number < (isUnsigned ? 0.0 : -most) ||
                        entry.value.find_first_of(".eE") != std::string::npos)
                    {
                        failAt(entry, isUnsigned ? "expected a whole number of at least 0" : "expected a whole number");
                    }
                    checkRange(entry, range, number);
                    return entry.value;
                }
                case ValueType::Real:
                    checkRange(entry, range, realValue(entry));
                    return entry.value;
                case ValueType::Text:
                    checkChoice(entry, range);
                    return entry.value;
            }
            return entry.value;
        }

        ob::GenericParamPtr findParameter(const ob::Planner &planner, const PlannerSpec &spec, const ConfigEntry &entry)
        {
            std::vector<std::string> names;
            for (const auto &[name, parameter] : planner.params().getParams())
            {
                if (lowerCase(name) == lowerCase(entry.key))
                {
                    return parameter;
                }
                names.push_back(name);
            }
            if (names.empty())
            {
                failAt(entry, "planner '" + spec.type + "' has no parameters");
            }
            failAt(entry, "unknown parameter of planner '" + spec.type + "'" + text::suggestion(entry.key, names));
        }

        void setParameter(planner::SelectiveParam &parameter, const ConfigEntry &entry)
        {
            const NoWarnings noWarnings;  // they would say again what the error says
            const bool isSwitch = valueType(parameter) == ValueType::Switch;
            if (!parameter.setValue(isSwitch ? (switchValue(entry) ? "1" : "0") : entry.value))
            {
                failAt(entry, "accepted is " + parameter.accepted());
            }
        }

        void setParameter(ob::Planner &planner, const PlannerSpec &spec, const ConfigEntry &entry)
        {
            const ob::GenericParamPtr parameter = findParameter(planner, spec, entry);
            if (auto *selective = dynamic_cast<planner::SelectiveParam *>(parameter.get()))
            {
                setParameter(*selective, entry);
                return;
            }
            const std::string value = checkedValue(*parameter, entry);
            const std::string &range = parameter->getRangeSuggestion();
            const std::string accepted = range.empty() ? "" : "; its range is " + range;
            bool isSet = false;
            try
            {
                isSet = parameter->setValue(value);
            }
            catch (const std::exception &error)
            {
                failAt(entry, error.what() + accepted);
            }
            if (!isSet)
            {
                failAt(entry, "not accepted by planner '" + spec.type + "'" + accepted);
            }
        }

        void requireFitting(const ob::StateSpace &space, const PlannerEntry &entry, const PlannerSpec &spec)
        {
            const auto refuse = [&spec, &space](const std::string &reason) {
                failAt(spec.origin,
                       "planner '" + spec.type + "' does not work in the space '" + space.getName() + "': " + reason);
            };
            if (entry.needsProjection && !space.hasDefaultProjection())
            {
                refuse("it needs a projection, and the space has no default one");
            }
            if (entry.needsSymmetry && !(space.hasSymmetricDistance() && space.hasSymmetricInterpolate()))
            {
                refuse("it takes motions backwards, and the space's are not the same both ways");
            }
            if (entry.needsMetric && !space.isMetricSpace())
            {
                refuse("it needs the triangle inequality");
            }
        }
    }  // namespace

    std::vector<std::string> plannerNames()
    {
        std::vector<std::string> names;
        for (const auto &[name, planner] : plannerTable())
        {
            names.push_back(name);
        }
        return names;
    }

    void requireKnownPlanner(const std::string &type, const std::string &origin)
    {
        const auto reason = unavailablePlanners().find(type);
        if (reason != unavailablePlanners().end())
        {
            failAt(origin, "planner '" + type + "' is not available: " + reason->second);
        }
        if (plannerTable().count(type) == 0)
        {
            failAt(origin, "unknown planner '" + type + "'" + text::suggestion(type, plannerNames()));
        }
    }

    std::string plannerTitle(const std::string &type)
    {
        return plannerTable().at(type).title;
    }

    std::vector<PlannerParameter> plannerParameters(const std::string &type)
    {
        auto space = std::make_shared<ob::RealVectorStateSpace>(2);
        space->setBounds(0.0, 1.0);
        requireKnownPlanner(type, "planners");
        const auto planner = plannerTable().at(type).allocate(std::make_shared<ob::SpaceInformation>(space));
        std::vector<PlannerParameter> parameters;
        for (const auto &[name, parameter] : planner->params().getParams())
        {
            parameters.push_back(
                {name, typeName(valueType(*parameter)), parameter->getRangeSuggestion(), parameter->getValue()});
        }
        return parameters;
    }

    ob::PlannerPtr createPlanner(const ob::SpaceInformationPtr &si, const PlannerSpec &spec)
    {
        requireKnownPlanner(spec.type, spec.origin);
        const PlannerEntry &entry = plannerTable().at(spec.type);
        requireFitting(*si->getStateSpace(), entry, spec);
        ob::PlannerPtr planner;
        try
        {
            planner = entry.allocate(si);
        }
        catch (const std::exception &error)
        {
            failAt(spec.origin, "planner '" + spec.type + "' cannot be made: " + error.what());
        }
        planner->setName(spec.name.empty() ? entry.title : spec.name);
        for (const auto &parameter : spec.parameters)
        {
            setParameter(*planner, spec, parameter);
        }
        return planner;
    }

    void seedPlanner(ob::Planner &planner, std::uint_fast32_t seed)
    {
        if (planner.params().hasParam("seed"))
        {
            planner.params().setParam("seed", std::to_string(seed));
        }
    }
}  // namespace ompl_mfa::benchmark
