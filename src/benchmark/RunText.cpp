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

#include "benchmark/RunText.h"

#include <ompl/base/PlannerStatus.h>

#include "ompl_mfa/PlainText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        std::string propertyOf(const RunRecord &record, const std::string &name)
        {
            const auto found = record.properties.find(name);
            return found == record.properties.end() ? std::string() : found->second;
        }

        std::string describeReturned(const RunRecord &record)
        {
            const std::string status = propertyOf(record, "status ENUM");
            std::string text = "no status";
            if (!status.empty())
            {
                text = ompl::base::PlannerStatus(static_cast<ompl::base::PlannerStatus::StatusType>(std::stoi(status)))
                           .asString();
            }
            const std::string cost = propertyOf(record, "path cost REAL");
            const std::string simplified = propertyOf(record, "simplified path cost REAL");
            text += cost.empty() ? "" : ", cost " + cost;
            return text + (simplified.empty() ? "" : ", simplified " + simplified);
        }
    }  // namespace

    std::string describeRun(const RunRecord &record)
    {
        const std::string end = record.termination == RunTermination::Returned
                                    ? describeReturned(record)
                                    : campaign::describeTermination(record.termination, record.signal);
        return record.message.empty()
                   ? end
                   : end + ": " + oneLine(record.message.substr(record.message.find_last_of('\n') + 1));
    }
}  // namespace ompl_mfa::benchmark
