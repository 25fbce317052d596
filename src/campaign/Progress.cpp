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

#include "campaign/Progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "campaign/RunProcess.h"

namespace ompl_mfa::campaign
{
    namespace
    {
        std::string bar(std::size_t done, std::size_t total)
        {
            constexpr std::size_t WIDTH = 24;
            const std::size_t filled = total > 0 ? WIDTH * done / total : WIDTH;
            return "[" + std::string(filled, '#') + std::string(WIDTH - filled, '-') + "] " + std::to_string(done) +
                   "/" + std::to_string(total);
        }
    }  // namespace

    Progress::Progress(std::ostream *out, bool terminal, std::size_t total, std::size_t done)
      : out_(out)
      , terminal_(terminal)
      , total_(total)
      , done_(done)
    {
    }

    bool Progress::isDue() const
    {
        constexpr double SHOWN_EVERY = 0.2;
        return out_ != nullptr && terminal_ && monotonicSeconds() - lastShown_ >= SHOWN_EVERY;
    }

    void Progress::running(const std::string &run, double secondsLeft)
    {
        if (!isDue())
        {
            return;
        }
        lastShown_ = monotonicSeconds();
        const std::string line = bar(done_, total_) + "  " + run + "  time left " + formatDuration(secondsLeft);
        clearLine();
        *out_ << line << std::flush;
        lineLength_ = line.size();
    }

    void Progress::finished(const std::string &run, const std::string &end, bool failed)
    {
        ++done_;
        if (out_ == nullptr || (terminal_ && !failed))
        {
            return;
        }
        clearLine();
        *out_ << std::to_string(done_) << "/" << std::to_string(total_) << "  " << run << ": " << end << std::endl;
    }

    void Progress::close()
    {
        if (out_ != nullptr && terminal_)
        {
            clearLine();
            *out_ << std::flush;
        }
    }

    void Progress::clearLine()
    {
        if (terminal_ && lineLength_ > 0)
        {
            *out_ << '\r' << std::string(lineLength_, ' ') << '\r';
        }
        lineLength_ = 0;
    }

    std::string formatDuration(double seconds)
    {
        const auto whole = static_cast<long>(std::lround(std::max(0.0, seconds)));
        char text[32];
        if (whole < 60)
        {
            std::snprintf(text, sizeof(text), "%ld s", whole);
        }
        else if (whole < 3600)
        {
            std::snprintf(text, sizeof(text), "%ld:%02ld", whole / 60, whole % 60);
        }
        else
        {
            std::snprintf(text, sizeof(text), "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
        }
        return text;
    }
}  // namespace ompl_mfa::campaign
