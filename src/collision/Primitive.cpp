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

#include "ompl_mfa/collision/Primitive.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "collision/PrimitiveShapes.h"
#include "text/NumberText.h"

namespace ompl_mfa::collision
{
    namespace
    {
        template <typename... Shapes>
        std::vector<PrimitiveKind> kindsOf(const std::tuple<Shapes...> * /*list*/)
        {
            return {ShapeTraits<Shapes>::kind()...};
        }
    }  // namespace

    const std::vector<PrimitiveKind> &primitiveKinds()
    {
        static const std::vector<PrimitiveKind> KINDS = kindsOf(static_cast<const Primitives *>(nullptr));
        return KINDS;
    }

    const PrimitiveKind *findPrimitiveKind(const std::string &nameOrNumber)
    {
        for (const PrimitiveKind &kind : primitiveKinds())
        {
            if (!nameOrNumber.empty() && (nameOrNumber == kind.name || nameOrNumber == kind.number))
            {
                return &kind;
            }
        }
        return nullptr;
    }

    std::string primitiveNames()
    {
        std::string names;
        for (const PrimitiveKind &kind : primitiveKinds())
        {
            names += (names.empty() ? "" : ", ") + std::string(kind.name);
        }
        return names;
    }

    std::shared_ptr<fcl::CollisionGeometryd> makePrimitive(const PrimitiveKind &kind,
                                                           const std::vector<double> &dimensions)
    {
        std::ostringstream message;
        message.imbue(std::locale::classic());
        if (dimensions.size() != kind.dimensions.size())
        {
            message << "a " << kind.name << " has " << kind.dimensions.size() << " dimensions (";
            for (std::size_t i = 0; i < kind.dimensions.size(); ++i)
            {
                message << (i == 0 ? "" : " ") << kind.dimensions[i];
            }
            message << "), not " << dimensions.size();
            throw std::invalid_argument(message.str());
        }
        for (std::size_t i = 0; i < dimensions.size(); ++i)
        {
            const bool accepted =
                std::isfinite(dimensions[i]) && (dimensions[i] > 0. || (kind.mayVanish && dimensions[i] == 0.));
            if (!accepted)
            {
                message << kind.name << ' ' << kind.dimensions[i] << " = " << text::numberText(dimensions[i])
                        << ": must be " << (kind.mayVanish ? "at least 0" : "greater than 0") << " and finite";
                throw std::invalid_argument(message.str());
            }
        }
        return kind.make(dimensions);
    }
}  // namespace ompl_mfa::collision
