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

#ifndef OMPL_MFA_PLANNER_ACCEPTED_VALUES_
#define OMPL_MFA_PLANNER_ACCEPTED_VALUES_

#include <optional>
#include <string>
#include <vector>

#include <ompl/util/Exception.h>

namespace ompl_mfa::planner
{
    /** \brief The numbers that a parameter of type \e T (unsigned int or double) accepts, and their text: a closed
        interval, and optionally one number below it. The text is independent of the locale. */
    template <typename T>
    class AcceptedValues
    {
    public:
        /** \brief The numbers \e lowest to \e highest, both finite. \e step is a suggestion for user interfaces. \e
            apart, a number below \e lowest, is accepted too. */
        AcceptedValues(T lowest, T step, T highest, std::optional<T> apart = std::nullopt)
          : lowest_(lowest)
          , step_(step)
          , highest_(highest)
          , apart_(apart)
        {
        }

        bool contains(T value) const
        {
            return (value >= lowest_ && value <= highest_) || (apart_ && value == *apart_);
        }

        /** \brief Reads a decimal number, with or without a sign + and, for a double, an exponent. Returns false and
            leaves \e value unchanged for any other \e text. Does not check whether the number is accepted. */
        static bool read(const std::string &text, T &value);

        /** \brief A short text that read() converts back to \e value, without an exponent for numbers of usual size. */
        static std::string write(T value);

        /** \brief The range in OMPL's format for suggestions: "lowest:step:highest". */
        std::string suggestion() const;

        /** \brief A readable description: "0, 4 to 10000". */
        std::string description() const;

    private:
        T lowest_;
        T step_;
        T highest_;
        std::optional<T> apart_;
    };

    /** \brief The words that a parameter accepts. */
    template <>
    class AcceptedValues<std::string>
    {
    public:
        explicit AcceptedValues(std::vector<std::string> words);

        bool contains(const std::string &value) const;
        static bool read(const std::string &text, std::string &value);
        static std::string write(const std::string &value);
        std::string suggestion() const;
        std::string description() const;

    private:
        std::vector<std::string> words_;
    };

    /** \brief A boolean: read as 0, 1, f, t, false or true in upper or lower case, written as 0 or 1. All other texts
        are refused, while OMPL reads them, even "no", as true. */
    template <>
    class AcceptedValues<bool>
    {
    public:
        bool contains(bool value) const;
        static bool read(const std::string &text, bool &value);
        static std::string write(bool value);
        std::string suggestion() const;
        std::string description() const;
    };

    /** \brief Throws ompl::Exception naming the parameter \e name, the value and what is accepted, unless \e accepted
        contains \e value. */
    template <typename T>
    void require(const AcceptedValues<T> &accepted, const std::string &name, const T &value)
    {
        if (!accepted.contains(value))
        {
            throw ompl::Exception(name + " = " + accepted.write(value) + ": accepted is " + accepted.description());
        }
    }
}  // namespace ompl_mfa::planner

#endif
