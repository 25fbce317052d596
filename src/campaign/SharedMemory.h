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

#ifndef OMPL_MFA_CAMPAIGN_SHARED_MEMORY_
#define OMPL_MFA_CAMPAIGN_SHARED_MEMORY_

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::campaign
{
    /** \brief Allocates \e size zero bytes that this process shares with those that it forks afterwards. Throws
        std::system_error if the allocation fails. */
    OMPL_MFA_EXPORT void *mapSharedMemory(std::size_t size);

    /** \brief Frees memory of mapSharedMemory(). */
    OMPL_MFA_EXPORT void unmapSharedMemory(void *memory, std::size_t size);

    /** \brief An object that this process shares with those that it forks afterwards: what they write survives their
        crash. Throws std::system_error if the system has no memory for it. */
    template <typename Shared>
    std::shared_ptr<Shared> makeShared()
    {
        static_assert(std::is_trivially_destructible_v<Shared>, "what it owned would be in the memory of one process");
        return {new (mapSharedMemory(sizeof(Shared))) Shared,
                [](Shared *shared) { unmapSharedMemory(shared, sizeof(Shared)); }};
    }
}  // namespace ompl_mfa::campaign

#endif
