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

#include "engine/fireflies/PathSwarm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/refinement/TightenRounds.h"
#include "path/PathDeformation.h"
#include "path/PathWalk.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* Share of random detours among the moves, where both kinds are used. */
        constexpr double DETOURS = 0.5;
        /* Share of the trials that move the best path; the others move any firefly of the pool. */
        constexpr double BEST = 0.5;
        /* Least length of a window, as a fraction of the path's. */
        constexpr double LEAST_WINDOW = 0.1;
        /* A segment that is about to be tightened may be longer than the present one by this fraction of the path. */
        constexpr double SLACK = 0.15;
        /* A tight segment may cost more than the present one, and a tight path more than the best one, by this
           fraction of the path's cost: tightening the whole path, or in full, may make up for it. */
        constexpr double SEGMENT_SLACK = 0.01;
        constexpr double PATH_SLACK = 0.01;
        constexpr double PROPOSAL_SLACK = 0.003;
        /* Motions between a new segment and the present one by which their homotopy classes are compared. */
        constexpr unsigned int RUNGS = 5;
        /* A segment that is cheaper by this fraction of the path's cost is of use in the same homotopy class, too. */
        constexpr double USEFUL_GAIN = 0.002;
        /* Budget of the trees of a window, as a factor of the work of checking the segment. */
        constexpr double TREE_WORK = 2.0;
        constexpr std::uint64_t LEAST_TREE_WORK = 200;
        /* A bridge may be longer than the gap by this factor, and by SLACK. */
        constexpr double BRIDGE = 1.3;
        /* Share of the moves in which only some coordinates move. */
        constexpr double CROSSOVER = 0.5;
        /* Fireflies that eqs. (6) and (7) need. */
        constexpr std::size_t LEAST_FIREFLIES = 4;
    }  // namespace

    PathSwarm::PathSwarm(const SearchContext &context, const FireflyOptimizer::Settings &settings)
      : context_(context)
      , settings_(settings)
      , random_(streamSeed(context.seed, Stream::PathSwarm))
      , rng_(static_cast<std::uint_fast32_t>(streamSeed(context.seed, Stream::PathSwarm, 1)))
      , tightening_(context.chart, context.evaluator(), streamSeed(context.seed, Stream::SwarmTightening))
      , trees_(context.chart, context.evaluator(), streamSeed(context.seed, Stream::LocalTrees))
      , window_(context.chart->space())
    {
    }

    bool PathSwarm::ready() const
    {
        return context_.incumbent.hasFinitePath() && context_.pool.size() > 0;
    }

    void PathSwarm::advance(std::uint64_t work, Findings &findings)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        const path::StrideScope draft(evaluator, context_.draftStride());
        const std::uint64_t limit = evaluator.work() + work;
        while (evaluator.work() < limit && !evaluator.stopped())
        {
            if (trial(findings))
            {
                return;
            }
        }
    }

    /* \e fraction of the best path's cost, or 0 where a factor of the cost gives no slack. */
    double PathSwarm::slack(double fraction) const
    {
        const double best = context_.incumbent.cost();
        return context_.evaluator().withSlack(best, 1.0 + fraction) - best;
    }

    std::uint64_t PathSwarm::treeWork() const
    {
        return LEAST_TREE_WORK + static_cast<std::uint64_t>(
                                     TREE_WORK * static_cast<double>(context_.evaluator().checkWork(window_.segment)));
    }

    /* Moves one firefly in one window; true if that was proposed. */
    bool PathSwarm::trial(Findings &findings)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        evaluator.addWork(1);
        countTrial();
        const Move move = chooseMove();
        if (!open(move))
        {
            return false;
        }
        path::Waypoints found(context_.chart->space());
        if (!(move == Move::Detour ? detour(found) : fly(move, found)) || evaluator.interrupted())
        {
            return false;
        }
        // a segment that can be deformed into the present one would only be tightened to that
        if (path::seemDeformable(evaluator, found, window_.segment, RUNGS) || !tightenSegment(found))
        {
            return false;
        }
        const std::size_t proposed = findings.paths.size();
        judge(found, findings);
        return findings.paths.size() > proposed;
    }

    /* A generation has as many trials as there are fireflies. */
    void PathSwarm::countTrial()
    {
        if (++trials_ >= context_.pool.size())
        {
            trials_ = 0;
            ++generation_;
            ++context_.progress.iterations;
        }
    }

    PathSwarm::Move PathSwarm::chooseMove()
    {
        const std::string &moves = context_.settings.fireflyMoves;
        const double detours = moves == "both" ? DETOURS : (moves == "detours" ? 1.0 : 0.0);
        if (context_.pool.size() < LEAST_FIREFLIES || random_.uniform() < detours)
        {
            return Move::Detour;
        }
        if (settings_.variant == FireflyOptimizer::Variant::FA)
        {
            return Move::Attraction;
        }
        constexpr std::array<Move, 4> EQUATIONS{Move::Attraction, Move::Mutation, Move::BestMutation, Move::Worst};
        return EQUATIONS[random_.index(EQUATIONS.size())];
    }

    /* Chooses a firefly and a window of it. */
    bool PathSwarm::open(Move move)
    {
        const PathPool &pool = context_.pool;
        const auto size = static_cast<unsigned int>(pool.size());
        window_.member = random_.uniform() < BEST ? pool.brightest() : random_.index(size);
        const PathPool::Member &member = pool[window_.member];
        window_.path = member.path;
        window_.slices = member.slices;
        window_.cost = member.cost;
        const double length = member.path.length();
        if (move == Move::Detour)
        {
            const double width = LEAST_WINDOW + (1.0 - LEAST_WINDOW) * random_.uniform();
            const double from = (1.0 - width) * random_.uniform();
            cut(from * length, (from + width) * length);
        }
        else
        {
            const unsigned int count = 1 + random_.index(PathPool::SLICES);
            window_.firstSlice = random_.index(PathPool::SLICES - count + 1);
            window_.lastSlice = window_.firstSlice + count;
            cut(length * window_.firstSlice / (PathPool::SLICES + 1),
                length * (window_.lastSlice + 1) / (PathPool::SLICES + 1));
        }
        path::PathEvaluator &evaluator = context_.evaluator();
        if (window_.segment.size() < 3 || !evaluator.checkState(window_.segment.front()) ||
            !evaluator.checkState(window_.segment.back()))
        {
            return false;
        }
        window_.segmentCost = evaluator.cost(window_.segment).value();
        return !evaluator.interrupted();
    }

    /* Sets the segment to the section of the path between two distances from its beginning. */
    void PathSwarm::cut(double from, double to)
    {
        const path::Waypoints &path = window_.path;
        const auto &space = path.space();
        path::Waypoints ends(space);
        ends.resize(2);
        path::PathWalk walk(path);
        walk.stateAt(from, ends[0]);
        window_.first = from > 0.0 ? walk.next() : 0;
        walk.stateAt(to, ends[1]);
        window_.last = walk.next();
        // the length of the path is not computed by the same sum
        if (to >= (1.0 - 1e-9) * path.length())
        {
            space->copyState(ends[1], path.back());
            window_.last = path.size();
        }
        if (window_.first == 0)
        {
            space->copyState(ends[0], path.front());
        }
        window_.segment.clear();
        window_.segment.append(ends[0]);
        for (std::size_t i = std::max<std::size_t>(window_.first, 1); i < window_.last; ++i)
        {
            if (i + 1 < path.size())
            {
                window_.segment.append(path[i]);
            }
        }
        window_.segment.append(ends[1]);
    }

    bool PathSwarm::detour(path::Waypoints &found)
    {
        const double longest = window_.segment.length() + SLACK * window_.path.length();
        return trees_.connect(window_.segment.front(), window_.segment.back(), longest, treeWork(), found);
    }

    bool PathSwarm::fly(Move move, path::Waypoints &found)
    {
        path::Waypoints moved(context_.chart->space());
        displace(drawMove(move), moved);
        return bridge(moved, found);
    }

    /* A firefly that is brighter than \e member; itself if there is none. */
    std::size_t PathSwarm::brighter(std::size_t member)
    {
        const PathPool &pool = context_.pool;
        std::vector<std::size_t> candidates;
        for (std::size_t i = 0; i < pool.size(); ++i)
        {
            if (context_.evaluator().isBetter(pool[i].cost, pool[member].cost))
            {
                candidates.push_back(i);
            }
        }
        return candidates.empty() ? member : candidates[random_.index(static_cast<unsigned int>(candidates.size()))];
    }

    /* The fraction of the epoch that is over. */
    double PathSwarm::progress() const
    {
        return static_cast<double>(generation_ % settings_.generations) / settings_.generations;
    }

    /* Eq. (13); constant for the plain algorithm. */
    double PathSwarm::alpha() const
    {
        return settings_.variant == FireflyOptimizer::Variant::FA
                   ? settings_.alpha
                   : settings_.alpha * std::pow(1.0 / (2.0 * settings_.generations), progress());
    }

    /* Eqs. (3), (4), (14) and (15): toward \e member, in the window, with distances in tenths of the path's length. */
    double PathSwarm::attraction(std::size_t member) const
    {
        const PathPool &pool = context_.pool;
        double sum = 0.0;
        for (unsigned int k = window_.firstSlice; k < window_.lastSlice; ++k)
        {
            const double distance = context_.chart->distance(window_.slices[k], pool[member].slices[k]);
            sum += distance * distance;
        }
        const double unit = 0.1 * window_.path.length();
        const double squared = sum / (window_.lastSlice - window_.firstSlice) / std::max(unit * unit, 1e-300);
        const double beta0 = settings_.variant == FireflyOptimizer::Variant::FA
                                 ? settings_.eta
                                 : std::max(0.0, settings_.eta - progress());
        return beta0 * std::exp(-settings_.gamma * squared);
    }

    SliceMove PathSwarm::drawMove(Move kind)
    {
        const PathPool &pool = context_.pool;
        const Eigen::Index d = context_.chart->dimension();
        SliceMove move;
        move.equation = kind == Move::Attraction     ? SliceMove::Equation::Attraction
                        : kind == Move::Mutation     ? SliceMove::Equation::Mutation
                        : kind == Move::BestMutation ? SliceMove::Equation::BestMutation
                                                     : SliceMove::Equation::Worst;
        for (std::size_t i = 0; i < move.others.size(); ++i)
        {
            do
            {
                move.others[i] = random_.index(static_cast<unsigned int>(pool.size()));
            } while (std::find(move.others.begin(), move.others.begin() + i, move.others[i]) !=
                     move.others.begin() + i);
        }
        move.best = pool.brightest();
        move.worst = pool.dimmest();
        move.brighter = brighter(window_.member);
        move.beta = attraction(move.brighter);
        move.step = alpha() * window_.segment.length();
        for (double &lambda : move.lambda)
        {
            lambda = random_.uniform();
        }
        const bool crossover = random_.uniform() < CROSSOVER;
        move.mask.setOnes(d);
        move.direction.resize(d);
        for (Eigen::Index j = 0; j < d; ++j)
        {
            move.mask[j] = crossover && random_.uniform() < 0.5 ? 0.0 : 1.0;
            move.direction[j] = rng_.gaussian01() / std::sqrt(static_cast<double>(d));
        }
        return move;
    }

    /* Computes where the slices of the window move. */
    void PathSwarm::displace(const SliceMove &move, path::Waypoints &moved) const
    {
        const path::StateChart &chart = *context_.chart;
        moved.clear();
        moved.append(window_.segment.front());
        for (unsigned int k = window_.firstSlice; k < window_.lastSlice; ++k)
        {
            const auto relative = [&](std::size_t member)
            {
                Eigen::VectorXd x(chart.dimension());
                chart.difference(window_.slices[k], context_.pool[member].slices[k], x);
                return x;
            };
            const double phase =
                static_cast<double>(k - window_.firstSlice + 1) / (window_.lastSlice - window_.firstSlice + 1);
            moved.resize(moved.size() + 1);
            chart.displace(window_.slices[k], move.displacement(relative, phase), moved[moved.size() - 1]);
        }
        moved.append(window_.segment.back());
    }

    /* Joins the valid states of \e moved by motions or, where these collide, by small trees. */
    bool PathSwarm::bridge(const path::Waypoints &moved, path::Waypoints &found)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        const std::uint64_t work = treeWork() / 2;
        path::Waypoints joint(moved.space());
        path::Waypoints from(moved.space());
        found.clear();
        found.append(moved.front());
        for (std::size_t i = 1; i < moved.size(); ++i)
        {
            if (i + 1 < moved.size() && !evaluator.checkState(moved[i]))
            {
                continue;
            }
            if (evaluator.checkMotion(found.back(), moved[i]))
            {
                found.append(moved[i]);
                continue;
            }
            from.clear();
            from.append(found.back());
            const double longest = BRIDGE * context_.chart->distance(from[0], moved[i]) + SLACK * window_.path.length();
            if (evaluator.interrupted() || !trees_.connect(from[0], moved[i], longest, work, joint))
            {
                return false;
            }
            for (std::size_t k = 1; k < joint.size(); ++k)
            {
                found.append(joint[k]);
            }
        }
        return true;
    }

    /* Whether the tight segment is good enough, and not the present one. */
    bool PathSwarm::tightenSegment(path::Waypoints &found)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        const ob::OptimizationObjective &objective = context_.objective();
        const ob::Cost rival(window_.segmentCost + slack(SEGMENT_SLACK));
        tightening_.begin(found);
        const ob::Cost cost = refinement::tightenRounds(tightening_, evaluator, evaluator.cost(found), rival, true);
        if (evaluator.interrupted() || objective.isCostBetterThan(rival, cost))
        {
            return false;
        }
        found = tightening_.path();
        const ob::Cost useful(window_.segmentCost - slack(USEFUL_GAIN));
        return objective.isCostBetterThan(cost, useful) ||
               !path::seemDeformable(evaluator, found, window_.segment, RUNGS);
    }

    /* Tightens the whole path with the new segment, which replaces a firefly of the pool; proposes it if it promises
       to become the best path. */
    void PathSwarm::judge(const path::Waypoints &segment, Findings &findings)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        const ob::OptimizationObjective &objective = context_.objective();
        const double best = context_.incumbent.cost();
        path::Waypoints whole(segment.space());
        for (std::size_t i = 0; i < window_.first; ++i)
        {
            whole.append(window_.path[i]);
        }
        for (std::size_t i = 0; i < segment.size(); ++i)
        {
            whole.append(segment[i]);
        }
        for (std::size_t i = window_.last; i < window_.path.size(); ++i)
        {
            whole.append(window_.path[i]);
        }
        tightening_.begin(whole);
        const ob::Cost rival(best + slack(PATH_SLACK));
        const ob::Cost cost = refinement::tightenRounds(tightening_, evaluator, evaluator.cost(whole), rival, false);
        ++context_.progress.evaluations;
        if (evaluator.interrupted())
        {
            return;
        }
        Proposal proposal{tightening_.path(), cost, Proposal::Stage::Tight, PartKind::Fireflies, true};
        if (objective.isCostBetterThan(cost, ob::Cost(best + slack(PROPOSAL_SLACK))))
        {
            findings.paths.push_back(std::move(proposal));
        }
        else
        {
            findings.drafts.push_back(std::move(proposal));
        }
    }
}  // namespace ompl_mfa::engine::fireflies
