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

#include "ompl_mfa/pagmo/PagmoFirefly.h"

#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>
#include <pagmo/archipelago.hpp>
#include <pagmo/problems/ackley.hpp>
#include <pagmo/problems/hock_schittkowsky_71.hpp>
#include <pagmo/problems/inventory.hpp>
#include <pagmo/problems/rosenbrock.hpp>
#include <pagmo/problems/zdt.hpp>
#include <pagmo/s11n.hpp>

using ompl_mfa::PagmoFirefly;

namespace
{
    PagmoFirefly withSeed(unsigned int seed, const std::string &variant = "mfa", unsigned int generations = 20)
    {
        return PagmoFirefly(generations, 0.5, 0.2, 1.0, variant, seed);
    }

    pagmo::population ackley(unsigned int size = 30, unsigned int seed = 5)
    {
        return pagmo::population(pagmo::problem(pagmo::ackley(6)), size, seed);
    }
}  // namespace

TEST(PagmoFirefly, ImprovesAPopulation)
{
    for (const char *variant : {"fa", "mfa"})
    {
        const auto before = ackley();
        const auto after = pagmo::algorithm(withSeed(1, variant)).evolve(before);
        EXPECT_EQ(after.size(), before.size());
        EXPECT_LT(after.champion_f()[0], before.champion_f()[0]);
        const auto &problem = after.get_problem();
        for (std::size_t i = 0; i < after.size(); ++i)
        {
            EXPECT_EQ(problem.fitness(after.get_x()[i]), after.get_f()[i]) << "each point has its own fitness";
        }
    }
}

TEST(PagmoFirefly, EvaluatesNoMemberTwice)
{
    const auto after = pagmo::algorithm(withSeed(1, "fa", 10)).evolve(ackley());
    EXPECT_EQ(after.get_problem().get_fevals(), 30U + 10U * 29U);
}

TEST(PagmoFirefly, KeepsTheBest)
{
    auto population = ackley();
    const pagmo::algorithm algorithm(withSeed(3, "fa", 3));
    for (int round = 0; round < 10; ++round)
    {
        const auto best = population.get_f()[population.best_idx()][0];
        population = algorithm.evolve(population);
        EXPECT_LE(population.get_f()[population.best_idx()][0], best);
        EXPECT_EQ(population.get_f()[population.best_idx()], population.champion_f());
    }
}

TEST(PagmoFirefly, IsDeterministicInItsSeed)
{
    pagmo::algorithm a(withSeed(7));
    pagmo::algorithm b(withSeed(7));
    const auto first = a.evolve(ackley());
    EXPECT_EQ(first.get_x(), b.evolve(ackley()).get_x());
    EXPECT_NE(first.get_x(), a.evolve(ackley()).get_x()) << "the next call continues the random sequence";
    a.set_seed(7);
    EXPECT_EQ(first.get_x(), a.evolve(ackley()).get_x());
    a.set_seed(8);
    EXPECT_NE(first.get_x(), a.evolve(ackley()).get_x());
}

TEST(PagmoFirefly, ZeroGenerationsChangeNothing)
{
    const auto before = ackley();
    const auto after = pagmo::algorithm(withSeed(1, "mfa", 0)).evolve(before);
    EXPECT_EQ(before.get_x(), after.get_x());
    EXPECT_EQ(before.get_problem().get_fevals(), after.get_problem().get_fevals());
}

TEST(PagmoFirefly, RefusesUnsuitableProblems)
{
    const pagmo::algorithm algorithm(withSeed(1));
    const auto evolve = [&](const pagmo::problem &problem, unsigned int size)
    { algorithm.evolve(pagmo::population(problem, size, 1U)); };
    EXPECT_THROW(evolve(pagmo::problem(pagmo::zdt(1, 5)), 20), std::invalid_argument);
    EXPECT_THROW(evolve(pagmo::problem(pagmo::hock_schittkowsky_71()), 20), std::invalid_argument);
    EXPECT_THROW(evolve(pagmo::problem(pagmo::inventory(4, 10, 1)), 20), std::invalid_argument);
    EXPECT_THROW(evolve(pagmo::problem(pagmo::ackley(2)), 3), std::invalid_argument) << "MFA needs four fireflies";
    EXPECT_NO_THROW(evolve(pagmo::problem(pagmo::ackley(2)), 4));
}

TEST(PagmoFirefly, RefusesBadParameters)
{
    EXPECT_THROW(PagmoFirefly(10, -1.0), std::invalid_argument);
    EXPECT_THROW(PagmoFirefly(10, 0.5, 2.0), std::invalid_argument);
    EXPECT_THROW(PagmoFirefly(10, 0.5, 0.2, 9.0), std::invalid_argument);
    EXPECT_THROW(withSeed(1, "pso"), std::invalid_argument);
}

TEST(PagmoFirefly, SurviveSerialisationAndCopying)
{
    const pagmo::algorithm original(withSeed(11));
    std::stringstream stream;
    {
        boost::archive::binary_oarchive out(stream);
        out << original;
    }
    pagmo::algorithm restored;
    {
        boost::archive::binary_iarchive in(stream);
        in >> restored;
    }
    ASSERT_TRUE(restored.is<PagmoFirefly>());
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): the copy is what is tested
    const pagmo::algorithm copy(original);
    const auto expected = original.evolve(ackley()).get_x();
    EXPECT_EQ(restored.evolve(ackley()).get_x(), expected);
    EXPECT_EQ(copy.evolve(ackley()).get_x(), expected);
    EXPECT_EQ(restored.get_extra_info(), original.get_extra_info());
}

TEST(PagmoFirefly, WorksInAnArchipelago)
{
    pagmo::archipelago islands(4, pagmo::algorithm(withSeed(2)), pagmo::problem(pagmo::rosenbrock(4)), 20, 3U);
    islands.evolve(5);
    islands.wait_check();
    for (const auto &champion : islands.get_champions_f())
    {
        EXPECT_LT(champion[0], 10.0);
    }
}

TEST(PagmoFirefly, TellsWhatItIs)
{
    const pagmo::algorithm algorithm(withSeed(2));
    EXPECT_NE(algorithm.get_name().find("Firefly"), std::string::npos);
    EXPECT_NE(algorithm.get_extra_info().find("gamma: 0.5"), std::string::npos);
    EXPECT_TRUE(algorithm.has_set_seed());
    EXPECT_TRUE(algorithm.has_set_verbosity());
    EXPECT_EQ(algorithm.get_thread_safety(), pagmo::thread_safety::basic);
}
