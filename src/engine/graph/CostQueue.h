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

#ifndef OMPL_MFA_ENGINE_GRAPH_COST_QUEUE_
#define OMPL_MFA_ENGINE_GRAPH_COST_QUEUE_

#include <algorithm>
#include <cmath>
#include <vector>

#include <ompl/base/Cost.h>

#include "path/PathEvaluator.h"

namespace ompl_mfa::engine::graph
{
    inline double combine(const path::PathEvaluator &evaluator, double a, double b)
    {
        return evaluator.objective()->combineCosts(ompl::base::Cost(a), ompl::base::Cost(b)).value();
    }

    /** \brief Whether \e cost is better than \e bound (infinity: any). */
    inline bool canBeat(const path::PathEvaluator &evaluator, double cost, double bound)
    {
        return std::isinf(bound) || evaluator.isBetter(cost, bound);
    }

    /** \brief A priority queue, the best cost first. */
    template <typename Item>
    class CostQueue
    {
    public:
        struct Entry
        {
            double key;
            Item item;
        };

        /** \brief \e evaluator, which compares costs, must outlive the object. */
        explicit CostQueue(const path::PathEvaluator &evaluator)
          : evaluator_(evaluator)
        {
        }

        /** \brief Removes all entries but keeps the memory. */
        void clear()
        {
            entries_.clear();
        }

        bool empty() const
        {
            return entries_.empty();
        }

        const Entry &top() const
        {
            return entries_.front();
        }

        void push(const Entry &entry)
        {
            entries_.push_back(entry);
            std::push_heap(entries_.begin(), entries_.end(), worse());
        }

        Entry pop()
        {
            std::pop_heap(entries_.begin(), entries_.end(), worse());
            const Entry entry = entries_.back();
            entries_.pop_back();
            return entry;
        }

    private:
        auto worse() const
        {
            return [this](const Entry &a, const Entry &b) { return evaluator_.isBetter(b.key, a.key); };
        }

        const path::PathEvaluator &evaluator_;
        std::vector<Entry> entries_;
    };
}  // namespace ompl_mfa::engine::graph

#endif
