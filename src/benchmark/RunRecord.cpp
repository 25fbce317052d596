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

#include "benchmark/RunRecord.h"

#include <stdexcept>

#include "ompl_mfa/benchmark/Campaign.h"
#include "ompl_mfa/optimizer/RandomSource.h"

using ompl_mfa::campaign::Json;

namespace ompl_mfa::benchmark
{
    namespace
    {
        Json progressToJson(const std::vector<ProgressSample> &progress)
        {
            Json samples = Json::array();
            for (const ProgressSample &sample : progress)
            {
                samples.push_back({sample.time, sample.values});
            }
            return samples;
        }

        std::vector<ProgressSample> progressFromJson(const Json &samples)
        {
            std::vector<ProgressSample> progress;
            progress.reserve(samples.size());
            for (const Json &sample : samples)
            {
                progress.push_back({sample.at(0).get<double>(), sample.at(1).get<std::vector<std::string>>()});
            }
            return progress;
        }
    }  // namespace

    Json toJson(const RunRecord &record)
    {
        return {{"planner", record.planner},
                {"run", record.run},
                {"seed", record.seed},
                {"termination", static_cast<int>(record.termination)},
                {"signal", record.signal},
                {"message", record.message},
                {"properties", record.properties},
                {"common", record.common},
                {"setup", record.setup},
                {"progress_names", record.progressNames},
                {"progress", progressToJson(record.progress)},
                {"path", record.path},
                {"path_cost", record.pathCost}};
    }

    RunRecord runRecordFrom(const Json &json)
    {
        try
        {
            RunRecord record;
            json.at("planner").get_to(record.planner);
            json.at("run").get_to(record.run);
            json.at("seed").get_to(record.seed);
            record.termination = static_cast<RunTermination>(json.at("termination").get<int>());
            json.at("signal").get_to(record.signal);
            json.at("message").get_to(record.message);
            json.at("properties").get_to(record.properties);
            json.at("common").get_to(record.common);
            json.at("setup").get_to(record.setup);
            json.at("progress_names").get_to(record.progressNames);
            record.progress = progressFromJson(json.at("progress"));
            json.at("path").get_to(record.path);
            json.at("path_cost").get_to(record.pathCost);
            record.duration = json.value("duration", 0.0);
            return record;
        }
        catch (const Json::exception &error)
        {
            throw std::invalid_argument(std::string("not the record of a run: ") + error.what());
        }
    }

    std::string writeRunRecord(const RunRecord &record)
    {
        return campaign::jsonLine(toJson(record));
    }

    RunRecord readRunRecord(const std::string &line)
    {
        try
        {
            return runRecordFrom(campaign::parseJson(line));
        }
        catch (const Json::exception &error)
        {
            throw std::invalid_argument(std::string("not the record of a run: ") + error.what());
        }
    }

    std::string logPropertyName(const std::string &name)
    {
        const std::string type = " DOUBLE";
        const bool isDouble =
            name.size() > type.size() && name.compare(name.size() - type.size(), type.size(), type) == 0;
        return isDouble ? name.substr(0, name.size() - type.size()) + " REAL" : name;
    }

    std::uint32_t runSeed(std::uint64_t base, unsigned int run)
    {
        const std::uint64_t z = mixBits(base + (static_cast<std::uint64_t>(run) + 1) * 0x9e3779b97f4a7c15ULL);
        return static_cast<std::uint32_t>(z % 0x7fffffffULL) + (z % 0x7fffffffULL == 0 ? 1U : 0U);
    }
}  // namespace ompl_mfa::benchmark
