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

#ifndef OMPL_MFA_PLANNER_RANGED_PARAM_
#define OMPL_MFA_PLANNER_RANGED_PARAM_

#include <functional>
#include <string>
#include <utility>

#include <ompl/base/GenericParam.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/PlainText.h"
#include "planner/AcceptedValues.h"

namespace ompl_mfa::planner
{
    /** \brief A planner parameter that can describe its accepted values. */
    class OMPL_MFA_EXPORT SelectiveParam : public ompl::base::GenericParam
    {
    public:
        using GenericParam::GenericParam;

        /** \brief A readable description of the accepted values: "0, 4 to 10000". */
        virtual std::string accepted() const = 0;
    };

    /** \brief A planner parameter that accepts only some values. For any other value, setValue logs a warning with the
        parameter, the value and the accepted values, returns false and changes nothing. Blanks around a value are
        ignored. setValue accepts what getValue returns. */
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
                if (!accepted_.read(trimmed(value), typed))
                {
                    throw ompl::Exception(name_ + " = '" + value + "' is not of the right type; accepted is " +
                                          accepted_.description());
                }
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
        AcceptedValues<T> accepted_;
        Setter setter_;
        Getter getter_;
    };
}  // namespace ompl_mfa::planner

#endif
