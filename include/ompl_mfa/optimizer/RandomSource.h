#ifndef OMPL_MFA_OPTIMIZER_RANDOM_SOURCE_
#define OMPL_MFA_OPTIMIZER_RANDOM_SOURCE_

#include <cstdint>
#include <random>

namespace ompl_mfa
{
    /** \brief Seeded uniform random numbers that are the same with every standard library: the engine's output is
        fixed by the C++ standard, that of std::uniform_real_distribution is not. */
    class RandomSource
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
