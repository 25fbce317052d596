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

#ifndef OMPL_MFA_CAMPAIGN_PROGRESS_
#define OMPL_MFA_CAMPAIGN_PROGRESS_

#include <iosfwd>
#include <string>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::campaign
{
    /** \brief Shows the progress of a campaign: a bar that is overwritten on a terminal, otherwise one line per run. */
    class OMPL_MFA_EXPORT Progress
    {
    public:
        /** \brief \e total runs, of which \e done are already finished. \e out may be null. */
        Progress(std::ostream *out, bool terminal, std::size_t total, std::size_t done);

        /** \brief Whether running() should be called again. */
        bool isDue() const;

        /** \brief Reports that \e run is in progress; \e secondsLeft is an estimate for all remaining runs. */
        void running(const std::string &run, double secondsLeft);

        /** \brief Reports how \e run ended; on a terminal only if it \e failed. */
        void finished(const std::string &run, const std::string &end, bool failed);

        /** \brief Ends the line of the bar. */
        void close();

    private:
        void clearLine();

        std::ostream *out_;
        bool terminal_;
        std::size_t total_;
        std::size_t done_;
        std::size_t lineLength_{0};
        double lastShown_{0.0};
    };

    /** \brief "3 s", "2:05" or "1:02:05". */
    OMPL_MFA_EXPORT std::string formatDuration(double seconds);
}  // namespace ompl_mfa::campaign

#endif
