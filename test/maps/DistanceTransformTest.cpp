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

#include "maps/DistanceTransform.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace ompl_mfa::maps
{
    namespace
    {
        using Kinds = std::vector<std::uint8_t>;

        float bruteForce(const Kinds &kinds, std::size_t width, std::size_t height, std::size_t x, std::size_t y)
        {
            const std::uint8_t own = kinds[y * width + x];
            double least = INFINITY;
            for (std::size_t j = 0; j < height; ++j)
            {
                for (std::size_t i = 0; i < width; ++i)
                {
                    const double dx = static_cast<double>(i) - static_cast<double>(x);
                    const double dy = static_cast<double>(j) - static_cast<double>(y);
                    least = kinds[j * width + i] != own ? std::min(least, dx * dx + dy * dy) : least;
                }
            }
            const double distance = std::isfinite(least) ? std::sqrt(least) : static_cast<double>(width + height);
            return static_cast<float>(own != 0 ? -distance : distance);
        }
    }  // namespace

    TEST(DistanceTransform, AgreesWithAllPairsOfCells)
    {
        std::mt19937 random(7);
        for (int round = 0; round < 60; ++round)
        {
            const std::size_t width = 1 + random() % 40;
            const std::size_t height = 1 + random() % 40;
            const unsigned int spacing = std::vector<unsigned int>{1, 2, 5, 50, 1000}[random() % 5];
            const bool isInverse = random() % 2 == 0;
            Kinds kinds(width * height);
            for (std::uint8_t &kind : kinds)
            {
                kind = (random() % spacing == 0) != isInverse ? 1 : 0;
            }
            const std::vector<float> distances = signedDistances(kinds, width, height);
            for (std::size_t y = 0; y < height; ++y)
            {
                for (std::size_t x = 0; x < width; ++x)
                {
                    ASSERT_FLOAT_EQ(distances[y * width + x], bruteForce(kinds, width, height, x, y))
                        << width << " x " << height << " at " << x << ", " << y;
                }
            }
        }
    }

    TEST(DistanceTransform, SeveralThreadsAgreeWithOne)
    {
        // above a million cells threads share the rows; far away cells are beyond the reach of small numbers
        constexpr std::size_t WIDTH = 1400;
        constexpr std::size_t HEIGHT = 800;
        Kinds kinds(WIDTH * HEIGHT, 0);
        const std::vector<std::pair<double, double>> places = {{3, 5}, {700, 20}, {1399, 799}, {650, 640}};
        for (const auto &[x, y] : places)
        {
            kinds[static_cast<std::size_t>(y) * WIDTH + static_cast<std::size_t>(x)] = 1;
        }
        const std::vector<float> distances = signedDistances(kinds, WIDTH, HEIGHT);
        for (std::size_t i = 0; i < distances.size(); ++i)
        {
            double least = INFINITY;
            for (const auto &[x, y] : places)
            {
                least =
                    std::min(least, std::hypot(x - static_cast<double>(i % WIDTH), y - static_cast<double>(i / WIDTH)));
            }
            ASSERT_FLOAT_EQ(distances[i], static_cast<float>(least == 0.0 ? -1.0 : least)) << i;
        }
    }
}  // namespace ompl_mfa::maps
