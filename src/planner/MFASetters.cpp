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

/* Setters and getters of MFA's parameters, in the order of mfaParameters(). */

#include "planner/MFAImplementation.h"
#include "planner/MFAParameters.h"

namespace ompl_mfa
{
    template <typename T>
    void MFA::Implementation::set(const MFA &planner, T engine::SearchSettings::*member, const T &value)
    {
        for (const auto &any : planner::mfaParameters())
        {
            const auto *parameter = std::get_if<planner::MFAParameter<T>>(&any);
            if (parameter != nullptr && parameter->member == member)
            {
                planner::require(parameter->accepted, planner.getName() + ": " + parameter->name, value);
            }
        }
        settings.*member = value;
    }

    void MFA::setVariant(const std::string &variant)
    {
        implementation_->set(*this, &engine::SearchSettings::variant, variant);
    }

    std::string MFA::getVariant() const
    {
        return implementation_->settings.variant;
    }

    void MFA::setFireflies(bool fireflies)
    {
        implementation_->set(*this, &engine::SearchSettings::fireflies, fireflies);
    }

    bool MFA::getFireflies() const
    {
        return implementation_->settings.fireflies;
    }

    void MFA::setFireflyMoves(const std::string &moves)
    {
        implementation_->set(*this, &engine::SearchSettings::fireflyMoves, moves);
    }

    std::string MFA::getFireflyMoves() const
    {
        return implementation_->settings.fireflyMoves;
    }

    void MFA::setPopulationSize(unsigned int size)
    {
        implementation_->set(*this, &engine::SearchSettings::populationSize, size);
    }

    unsigned int MFA::getPopulationSize() const
    {
        return implementation_->settings.populationSize;
    }

    void MFA::setSlices(unsigned int slices)
    {
        implementation_->set(*this, &engine::SearchSettings::slices, slices);
    }

    unsigned int MFA::getSlices() const
    {
        return implementation_->settings.slices;
    }

    void MFA::setGenerations(unsigned int generations)
    {
        implementation_->set(*this, &engine::SearchSettings::generations, generations);
    }

    unsigned int MFA::getGenerations() const
    {
        return implementation_->settings.generations;
    }

    void MFA::setGamma(double gamma)
    {
        implementation_->set(*this, &engine::SearchSettings::gamma, gamma);
    }

    double MFA::getGamma() const
    {
        return implementation_->settings.gamma;
    }

    void MFA::setAlpha(double alpha)
    {
        implementation_->set(*this, &engine::SearchSettings::alpha, alpha);
    }

    double MFA::getAlpha() const
    {
        return implementation_->settings.alpha;
    }

    void MFA::setEta(double eta)
    {
        implementation_->set(*this, &engine::SearchSettings::eta, eta);
    }

    double MFA::getEta() const
    {
        return implementation_->settings.eta;
    }

    void MFA::setGuide(const std::string &guide)
    {
        implementation_->set(*this, &engine::SearchSettings::guide, guide);
    }

    std::string MFA::getGuide() const
    {
        return implementation_->settings.guide;
    }

    void MFA::setRecombination(bool recombination)
    {
        implementation_->set(*this, &engine::SearchSettings::recombination, recombination);
    }

    bool MFA::getRecombination() const
    {
        return implementation_->settings.recombination;
    }

    void MFA::setTightening(bool tightening)
    {
        implementation_->set(*this, &engine::SearchSettings::tightening, tightening);
    }

    bool MFA::getTightening() const
    {
        return implementation_->settings.tightening;
    }

    void MFA::setSeed(std::uint32_t seed)
    {
        implementation_->set(*this, &engine::SearchSettings::seed, seed);
    }

    std::uint32_t MFA::getSeed() const
    {
        return implementation_->settings.seed;
    }

    void MFA::setStateCheckTime(double microseconds)
    {
        implementation_->set(*this, &engine::SearchSettings::stateCheckTime, microseconds);
    }

    double MFA::getStateCheckTime() const
    {
        return implementation_->settings.stateCheckTime;
    }

    void MFA::setThreads(unsigned int threads)
    {
        implementation_->set(*this, &engine::SearchSettings::threads, threads);
    }

    unsigned int MFA::getThreads() const
    {
        return implementation_->settings.threads;
    }

    void MFA::setStrictness(unsigned int strictness)
    {
        implementation_->set(*this, &engine::SearchSettings::strictness, strictness);
    }

    unsigned int MFA::getStrictness() const
    {
        return implementation_->settings.strictness;
    }

    void MFA::setGuidePlanner(const ompl::base::PlannerAllocator &allocator)
    {
        implementation_->guidePlanner = allocator;
    }
}  // namespace ompl_mfa
