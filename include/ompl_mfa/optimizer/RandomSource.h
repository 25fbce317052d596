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

#ifndef OMPL_MFA_OPTIMIZER_RANDOM_SOURCE_
#define OMPL_MFA_OPTIMIZER_RANDOM_SOURCE_

#include <cstdint>
#include <random>

#include "ompl_mfa/Export.h"

namespace ompl_mfa
{
    /** \brief Mixes the bits of \e x: a bijection of the 64-bit numbers in which each bit of the result depends on
       every bit of \e x. G. L. Steele, D. Lea and C. H. Flood, Fast splittable pseudorandom number generators, OOPSLA
        2014 (SplitMix64). */
    inline std::uint64_t mixBits(std::uint64_t x)
    {
        x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
        return x ^ (x >> 31U);
    }

    /** \brief The seed of the \e index-th instance of stream \e stream in the run with seed \e seed. Streams of one
        run, and of runs with neighbouring seeds, are independent. */
    inline std::uint64_t deriveSeed(std::uint64_t seed, std::uint64_t stream, std::uint64_t index = 0)
    {
        constexpr std::uint64_t GOLDEN = 0x9e3779b97f4a7c15ULL;  // 2^64 divided by the golden ratio, as in SplitMix64
        return mixBits(mixBits(mixBits(seed + GOLDEN) + (stream + 1) * GOLDEN) + (index + 1) * GOLDEN);
    }

    /** \brief Seeded uniform random numbers that are the same with every standard library: the engine's output is
        fixed by the C++ standard, that of std::uniform_real_distribution is not. */
    class OMPL_MFA_EXPORT RandomSource
    {
    public:
        explicit RandomSource(std::uint_fast64_t seed)
          : engine_(seed)
        {
        }

        /** \brief Uniform in [0, 1), with the 53 bits of a double's mantissa. */
        double uniform()
        {
            return static_cast<double>(engine_() >> 11U) * 0x1.0p-53;
        }

        /** \brief Uniform in {0, ..., \e size - 1}; \e size must be positive and below 2^32, where the bias of scaling
            a double is below 2^-21. */
        unsigned int index(unsigned int size)
        {
            return static_cast<unsigned int>(uniform() * size);
        }

    private:
        std::mt19937_64 engine_;
    };
}  // namespace ompl_mfa

#endif
