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

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

namespace ompl_mfa::maps
{
    namespace
    {
        using Steps = std::uint16_t;
        constexpr int MOST_STEPS = std::numeric_limits<Steps>::max();

        /* Vertical distances to the nearest cell of the other kind, row by row so that the memory is read in its
           order. */
        std::vector<Steps> verticalDistances(const std::vector<std::uint8_t> &occupied, std::size_t width,
                                             std::size_t height)
        {
            std::vector<Steps> steps(width * height, MOST_STEPS);
            const auto sweep = [&](std::size_t to, std::size_t from)
            {
                const std::uint8_t *kind = &occupied[to * width];
                const std::uint8_t *otherKind = &occupied[from * width];
                Steps *row = &steps[to * width];
                const Steps *otherRow = &steps[from * width];
                for (std::size_t x = 0; x < width; ++x)
                {
                    const int further = std::min(otherRow[x] + 1, MOST_STEPS);
                    const int candidate = kind[x] == otherKind[x] ? further : 1;
                    row[x] = static_cast<Steps>(std::min<int>(row[x], candidate));
                }
            };
            for (std::size_t y = 1; y < height; ++y)
            {
                sweep(y, y - 1);
            }
            for (std::size_t y = height - 1; y-- > 0;)
            {
                sweep(y, y + 1);
            }
            return steps;
        }

        /* The second pass over rows. For each of them the lower envelope of the parabolas (x - i)^2 + steps(i)^2 is
           made for each run of cells of one kind: the cells that end the run have the distance 0, so that no parabola
           beyond them is lower within it. */
        class RowPass
        {
        public:
            RowPass(const std::vector<std::uint8_t> &occupied, const std::vector<Steps> &steps, std::size_t width,
                    std::size_t height, std::vector<float> &distances)
              : occupied_(occupied)
              , steps_(steps)
              , width_(width)
              , farthest_(static_cast<float>(width + height))
              , distances_(distances)
              , places_(width + 2)
              , heights_(width + 2)
              , begins_(width + 3)
            {
            }

            void process(std::size_t row)
            {
                const std::uint8_t *kinds = &occupied_[row * width_];
                for (std::size_t begin = 0; begin < width_;)
                {
                    std::size_t end = begin + 1;
                    while (end < width_ && kinds[end] == kinds[begin])
                    {
                        ++end;
                    }
                    processRun(row, static_cast<int>(begin), static_cast<int>(end), kinds[begin] != 0);
                    begin = end;
                }
            }

        private:
            void push(int place, double height)
            {
                const double shifted = height + static_cast<double>(place) * place;
                double begin = -std::numeric_limits<double>::infinity();
                while (count_ > 0)
                {
                    const std::size_t top = count_ - 1;
                    begin = (shifted - heights_[top]) / (2.0 * (place - places_[top]));
                    if (begin > begins_[top])
                    {
                        break;
                    }
                    --count_;
                    begin = -std::numeric_limits<double>::infinity();
                }
                places_[count_] = place;
                heights_[count_] = shifted;
                begins_[count_] = begin;
                ++count_;
            }

            void processRun(std::size_t row, int begin, int end, bool isOccupied)
            {
                const Steps *steps = &steps_[row * width_];
                count_ = 0;
                if (begin > 0)
                {
                    push(begin - 1, 0.0);
                }
                for (int x = begin; x < end; ++x)
                {
                    if (steps[x] != MOST_STEPS)
                    {
                        push(x, static_cast<double>(steps[x]) * steps[x]);
                    }
                }
                if (end < static_cast<int>(width_))
                {
                    push(end, 0.0);
                }
                begins_[count_] = std::numeric_limits<double>::infinity();
                float *distances = &distances_[row * width_];
                std::size_t current = 0;
                for (int x = begin; x < end; ++x)
                {
                    while (current + 1 < count_ && begins_[current + 1] <= x)
                    {
                        ++current;
                    }
                    const double offset = x - places_[current];
                    const double squared =
                        heights_[current] - static_cast<double>(places_[current]) * places_[current] + offset * offset;
                    const float distance =
                        count_ == 0 ? farthest_ : std::min(farthest_, std::sqrt(static_cast<float>(squared)));
                    distances[x] = isOccupied ? -distance : distance;
                }
            }

            const std::vector<std::uint8_t> &occupied_;
            const std::vector<Steps> &steps_;
            std::size_t width_;
            float farthest_;
            std::vector<float> &distances_;
            /* The envelope from left to right: places of the parabolas, their heights plus the squares of the places,
               and where they begin to be the lowest. */
            std::vector<int> places_;
            std::vector<double> heights_;
            std::vector<double> begins_;
            std::size_t count_{0};
        };
    }  // namespace

    std::vector<float> signedDistances(const std::vector<std::uint8_t> &occupied, std::size_t width, std::size_t height)
    {
        constexpr std::size_t SMALL = 1000000;
        constexpr unsigned int MOST_THREADS = 8;
        const std::vector<Steps> steps = verticalDistances(occupied, width, height);
        std::vector<float> distances(width * height);
        const auto work = [&](std::size_t begin, std::size_t end)
        {
            RowPass pass(occupied, steps, width, height, distances);
            for (std::size_t row = begin; row < end; ++row)
            {
                pass.process(row);
            }
        };
        const unsigned int threads =
            width * height < SMALL ? 1 : std::clamp(std::thread::hardware_concurrency(), 1U, MOST_THREADS);
        std::vector<std::thread> others;
        for (unsigned int i = 1; i < threads; ++i)
        {
            others.emplace_back(work, height * i / threads, height * (i + 1) / threads);
        }
        work(0, height / threads);
        for (std::thread &thread : others)
        {
            thread.join();
        }
        return distances;
    }
}  // namespace ompl_mfa::maps
