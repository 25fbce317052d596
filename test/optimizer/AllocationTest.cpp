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

// The optimiser is compiled into this test with Eigen's allocation check, which a library cannot offer.
#include <cstdlib>
#include <new>
#include <stdexcept>

#define EIGEN_RUNTIME_NO_MALLOC
#undef eigen_assert
#define eigen_assert(condition)                   \
    do                                            \
    {                                             \
        if (!(condition))                         \
            throw std::runtime_error(#condition); \
    } while (false)
#include "../../src/optimizer/FireflyOptimizer.cpp"  // NOLINT(bugprone-suspicious-include): see above

#include <gtest/gtest.h>

namespace
{
    int allocations = 0;
}

[[gnu::noinline]] void *operator new(std::size_t size)
{
    ++allocations;
    if (void *memory = std::malloc(size))
    {
        return memory;
    }
    throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void *memory) noexcept
{
    std::free(memory);
}

[[gnu::noinline]] void operator delete(void *memory, std::size_t /*size*/) noexcept
{
    std::free(memory);
}

namespace
{
    class Sphere : public ompl_mfa::ObjectiveFunction
    {
    public:
        ompl_mfa::Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x,
                                      const ompl_mfa::Brightness * /*rival*/) override
        {
            return {0.0, x.squaredNorm()};
        }
    };
}  // namespace

TEST(FireflyOptimizerAllocation, AGenerationAllocatesNothing)
{
    for (const auto variant : {ompl_mfa::FireflyOptimizer::Variant::FA, ompl_mfa::FireflyOptimizer::Variant::MFA})
    {
        ompl_mfa::FireflyOptimizer::Settings settings;
        settings.variant = variant;
        settings.populationSize = 40;
        settings.generations = 7;
        ompl_mfa::FireflyOptimizer optimizer(settings, Eigen::VectorXd::Constant(19, -3.0),
                                             Eigen::VectorXd::Constant(19, 8.0), 1);
        Sphere sphere;
        const ompl_mfa::FireflyOptimizer::StopCondition never = [] { return false; };
        const Eigen::VectorXd origin = Eigen::VectorXd::Zero(19);
        allocations = 0;
        Eigen::internal::set_is_malloc_allowed(false);
        for (int generation = 0; generation < 20; ++generation)
        {
            optimizer.step(sphere, never);
        }
        optimizer.inject(origin, {0.0, 0.0}, sphere);
        optimizer.restartEpoch();
        optimizer.step(sphere, never);
        Eigen::internal::set_is_malloc_allowed(true);
        EXPECT_EQ(allocations, 0);
    }
}

TEST(FireflyOptimizerAllocation, TheCheckSeesAllocations)
{
    Eigen::internal::set_is_malloc_allowed(false);
    Eigen::VectorXd vector;
    EXPECT_THROW(vector.resize(100), std::runtime_error);
    Eigen::internal::set_is_malloc_allowed(true);
    allocations = 0;
    const std::vector<double> values(100);
    EXPECT_EQ(allocations, values.empty() ? 0 : 1);
}
