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

#ifndef OMPL_MFA_OPTIMIZER_FIREFLY_OPTIMIZER_
#define OMPL_MFA_OPTIMIZER_FIREFLY_OPTIMIZER_

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/optimizer/ObjectiveFunction.h"
#include "ompl_mfa/optimizer/RandomSource.h"

namespace ompl_mfa
{
    /** \brief The firefly algorithm (FA) and the Modified Firefly Algorithm (MFA) over a box in R^d.

        A population of N fireflies, each a point of the box, is improved generation by generation. In a generation
        every firefly but the brightest makes one move toward each brighter firefly in turn, from dim to bright, and
        is then evaluated once; fireflies attract from their positions at the beginning of the generation. MFA then
        offers every firefly five trial vectors, each of which replaces it if brighter, and shrinks the random step
        and the attraction over an epoch of \e generations generations. A coordinate that leaves the box is set to
        the nearest bound. The best point ever evaluated is stored separately from the population.

        The equation numbers are those of Improved Path Planning for Mobile Robot Based on Firefly Algorithm;
        docs/algorithm.md lists how each is read. */
    class OMPL_MFA_EXPORT FireflyOptimizer
    {
    public:
        enum class Variant
        {
            FA,  ///< eqs. (1)-(5); alpha and beta0 constant, at most one evaluation per firefly and generation
            MFA  ///< adds the trial vectors of eqs. (6)-(12) and the schedules of eqs. (13)-(16)
        };

        /** \brief How the random step alpha changes with the generation t of an epoch of M generations. */
        enum class AlphaSchedule
        {
            Constant,   ///< alpha
            Geometric,  ///< eq. (13): alpha (1 / (2 M))^(t / M)
            Yang,       ///< Yang's reference program: alpha (10^-4 / 0.9)^(t / M)
            Linear      ///< alpha (1 - t / M)
        };

        /** \brief How the attraction beta0 changes with the generation t of an epoch of M generations. */
        enum class BetaSchedule
        {
            Constant,   ///< eta
            Decreasing  ///< eq. (14): eta - t / M, never below 0
        };

        /** \brief The number of trial vectors of eqs. (8) to (12), in that order. */
        static constexpr unsigned int TRIAL_VECTORS = 5;

        /** \brief Number of operations without an evaluation after which step() evaluates its stop condition: about 50
            microseconds. */
        static constexpr std::uint64_t OPERATIONS_BETWEEN_STOPS = 4096;

        struct Settings
        {
            Variant variant{Variant::MFA};

            /** \brief N: at least 1, for MFA at least 4. */
            unsigned int populationSize{100};

            /** \brief Mmax: the number of generations in an epoch, over which alpha and beta0 shrink; at least 1. */
            unsigned int generations{50};

            /** \brief Light absorption coefficient, at least 0. It applies to the distance of two fireflies with every
                coordinate measured in tenths of its range: the same on every box, and the plain distance on [-5, 5]^2,
                for which the paper uses 0.5. */
            double gamma{0.5};

            /** \brief Random step at the beginning of an epoch, in [0, 1], as a fraction of a coordinate's range. */
            double alpha{0.2};

            /** \brief Attraction at distance 0 at the beginning of an epoch, in [0, 2]. */
            double eta{1.0};

            /** \brief Attraction in the limit of large distances, in [0, 2]; 0.2 in Yang's reference program. */
            double betaMin{0.0};

            /** \brief Unset: constant for FA, geometric for MFA. */
            std::optional<AlphaSchedule> alphaSchedule{};

            /** \brief Unset: constant for FA, decreasing for MFA. */
            std::optional<BetaSchedule> betaSchedule{};

            /** \brief Which trial vectors MFA uses, eqs. (8) to (12) in that order. */
            std::array<bool, TRIAL_VECTORS> trialVectors{{true, true, true, true, true}};

            /** \brief Throws std::invalid_argument naming the setting, its value and the accepted range. */
            void validate() const;
        };

        using StopCondition = std::function<bool()>;

        /** \brief N fireflies in the box [\e lower, \e upper], each d x 1 with d >= 1; a coordinate may have range 0.
            The first step() places them uniformly at random. The same seed gives the same run, bit for bit. Throws
            std::invalid_argument for invalid settings or bounds. */
        FireflyOptimizer(const Settings &settings, const Eigen::VectorXd &lower, const Eigen::VectorXd &upper,
                         std::uint_fast64_t seed);

        /** \brief Runs to the end of the current generation and returns true; the first call places and evaluates the
            initial population. \e stop is evaluated before every evaluation of \e objective, and otherwise at least
            once in OPERATIONS_BETWEEN_STOPS operations() (plus those of one move or merge: d or N). When it is true,
            step returns false, and the next call resumes as if there had been no interruption. Does not allocate. */
        bool step(ObjectiveFunction &objective, const StopCondition &stop);

        /** \brief Puts \e x (d x 1, clamped to the box) into the initial population, unevaluated, in place of a random
            member. Throws std::logic_error after the first step, or if N points were injected already. */
        void inject(const Eigen::Ref<const Eigen::VectorXd> &x);

        /** \brief To be called after the order defined by isBrighter() of \e objective has changed, for instance
            because a constraint became tighter. best() is selected again from itself and the population; the population
            is sorted by the new order before the next generation's moves. */
        void orderChanged(const ObjectiveFunction &objective);

        /** \brief Replaces the dimmest firefly by \e x (d x 1, clamped to the box) of the given brightness, which
            becomes the best if brighter. Throws std::logic_error before the initial population was evaluated. */
        void inject(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness &brightness,
                    const ObjectiveFunction &objective);

        /** \brief Restarts the schedules of alpha and beta0 with the next generation, keeping population and best. Also
            happens automatically after \e generations generations. */
        void restartEpoch();

        const Settings &settings() const
        {
            return settings_;
        }

        const Eigen::VectorXd &lower() const
        {
            return lower_;
        }

        const Eigen::VectorXd &upper() const
        {
            return upper_;
        }

        /** \brief d x N, one column per firefly. Before the first step() only the columns of injected points have
            values. */
        const Eigen::MatrixXd &population() const
        {
            return population_;
        }

        /** \brief The brightness of column \e i of population(); infinitely dim before its first evaluation. */
        const Brightness &brightness(unsigned int i) const
        {
            return brightness_[i];
        }

        /** \brief The columns of population(), brightest first: between two generations the present order, during a
            generation that at the beginning of its moves or of its trial vectors. Empty before the fireflies are
            placed, and in no particular order before all of them are evaluated. */
        const std::vector<unsigned int> &order() const
        {
            return order_;
        }

        /** \brief The first of order(); 0 if that is empty. */
        unsigned int brightestIndex() const
        {
            return order_.empty() ? 0 : order_.front();
        }

        /** \brief The brightest point ever evaluated or injected with a brightness, d x 1; before that the centre of
            the box. */
        const Eigen::VectorXd &best() const
        {
            return best_;
        }

        const Brightness &bestBrightness() const
        {
            return bestBrightness_;
        }

        /** \brief Completed generations, not counting the evaluation of the initial population. */
        unsigned int generation() const
        {
            return generation_;
        }

        /** \brief Calls of ObjectiveFunction::evaluate. */
        std::uint64_t evaluations() const
        {
            return evaluations_;
        }

        /** \brief Work other than evaluations: coordinates drawn, moved or computed for trial vectors, and fireflies
            merged while sorting. */
        std::uint64_t operations() const
        {
            return operations_;
        }

        /** \brief The random step of the next generation as a fraction of a coordinate's range; eq. (13). After the
            last generation of an epoch the final value of the schedule. */
        double alpha() const;

        /** \brief The attraction at distance 0 in the next generation; eq. (14). */
        double beta0() const;

    private:
        enum class Phase
        {
            Placing,  ///< drawing the initial population
            Initial,  ///< evaluating the initial population
            Between,  ///< between two generations
            Moving,   ///< moving the fireflies
            Moves,    ///< evaluating the moved fireflies
            Trials    ///< evaluating trial vectors
        };

        bool placeInitial(const StopCondition &stop);
        bool evaluateInitial(ObjectiveFunction &objective, const StopCondition &stop);
        bool evaluateMoves(ObjectiveFunction &objective, const StopCondition &stop);
        bool evaluateTrials(ObjectiveFunction &objective, const StopCondition &stop);

        bool beginGeneration(const ObjectiveFunction &objective, const StopCondition &stop);
        bool endGeneration(const ObjectiveFunction &objective, const StopCondition &stop);

        /** \brief Eqs. (4), (5), (16): moves every firefly toward every brighter one, into moved_. */
        bool move(const StopCondition &stop);

        /** \brief Eqs. (6)-(12): fills trials_ for firefly \e i. */
        void makeTrials(unsigned int i);

        /** \brief Draws n1..n4, pairwise distinct. */
        std::array<unsigned int, 4> drawDistinct();

        /** \brief Sorts order_ and counts brighter_; false if interrupted, then the next call resumes. */
        bool sortByBrightness(const ObjectiveFunction &objective, const StopCondition &stop);
        void countBrighter(const ObjectiveFunction &objective);

        /** \brief Evaluates \e stop, which is due again after OPERATIONS_BETWEEN_STOPS operations. */
        bool asked(const StopCondition &stop);

        /** \brief Evaluates \e stop if that is due. */
        bool askedIfDue(const StopCondition &stop);

        Brightness evaluate(ObjectiveFunction &objective, const Eigen::Ref<const Eigen::VectorXd> &x,
                            const Brightness *rival);
        void place(unsigned int i, const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness &brightness,
                   const ObjectiveFunction &objective);
        AlphaSchedule alphaSchedule() const;
        BetaSchedule betaSchedule() const;

        Settings settings_;
        Eigen::VectorXd lower_;
        Eigen::VectorXd upper_;
        Eigen::VectorXd range_;

        /** \brief 10 / range, 0 where the range is 0: the inverse length scale of gamma. */
        Eigen::VectorXd inverseScale_;
        RandomSource random_;

        Eigen::MatrixXd population_;
        std::vector<Brightness> brightness_;
        std::vector<unsigned int> order_;

        /** \brief State of the sort: runs of runLength_ (0: no sort in progress) of sorted_ are merged in pairs into
            merged_, so far up to mergedUpTo_. */
        std::vector<unsigned int> sorted_;
        std::vector<unsigned int> merged_;
        std::size_t runLength_{0};
        std::size_t mergedUpTo_{0};
        bool orderChanged_{false};

        /** \brief How many fireflies are strictly brighter than order_[rank]; those of equal brightness do not attract.
         */
        std::vector<unsigned int> brighter_;
        Eigen::VectorXd best_;
        Brightness bestBrightness_;

        /** \brief d x N: the new positions of the fireflies in this generation. */
        Eigen::MatrixXd moved_;

        /** \brief Which fireflies are still to be evaluated at moved_; all before the first generation. */
        std::vector<bool> moves_;

        /** \brief Settings::trialVectors. */
        std::vector<bool> trialsWanted_;

        /** \brief d x 5: the trial vectors of eqs. (8)-(12) for firefly cursor_. */
        Eigen::MatrixXd trials_;
        Eigen::VectorXd new1_;
        Eigen::VectorXd new2_;

        Phase phase_{Phase::Placing};

        /** \brief The rank of the firefly that moves, whether its move has begun, and how many brighter ones it still
            has to move toward. */
        unsigned int rank_{0};
        bool moving_{false};
        unsigned int movesLeft_{0};

        /** \brief The firefly, and its trial vector, to be placed or evaluated next. */
        unsigned int cursor_{0};
        unsigned int trial_{0};
        bool trialsMade_{false};

        unsigned int injected_{0};
        unsigned int generation_{0};
        unsigned int epochGeneration_{0};
        std::uint64_t evaluations_{0};
        std::uint64_t operations_{0};
        std::uint64_t operationsWhenAsked_{0};
    };
}  // namespace ompl_mfa

#endif
