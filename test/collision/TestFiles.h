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

#ifndef OMPL_MFA_TEST_COLLISION_TEST_FILES_
#define OMPL_MFA_TEST_COLLISION_TEST_FILES_

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::collision
{
    /** \brief A temporary folder, removed at the end of the test. */
    class TemporaryFolder
    {
    public:
        TemporaryFolder()
          : path_(std::filesystem::temp_directory_path() /
                  ("ompl_mfa_" + std::to_string(getpid()) + "_" + std::to_string(count()++)))
        {
            std::filesystem::create_directories(path_);
        }

        ~TemporaryFolder()
        {
            std::error_code ignored;
            std::filesystem::remove_all(path_, ignored);
        }

        TemporaryFolder(const TemporaryFolder &) = delete;
        TemporaryFolder &operator=(const TemporaryFolder &) = delete;

        std::filesystem::path write(const std::string &name, const std::string &content) const
        {
            std::ofstream(path_ / name, std::ios::binary) << content;
            return path_ / name;
        }

        const std::filesystem::path &path() const
        {
            return path_;
        }

    private:
        static int &count()
        {
            static int folders = 0;
            return folders;
        }

        std::filesystem::path path_;
    };

    /** \brief The message of the InputError that `action` throws; empty, and a test failure, if it throws none. */
    template <typename Action>
    std::string inputErrorOf(const Action &action)
    {
        try
        {
            action();
        }
        catch (const InputError &error)
        {
            std::string message = error.what();
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            return message;
        }
        ADD_FAILURE() << "no InputError";
        return "";
    }

    /** \brief Expects an InputError whose message contains all parts. */
    template <typename Action, typename... Parts>
    void expectInputError(const Action &action, const Parts &...parts)
    {
        const std::string message = inputErrorOf(action);
        for (const std::string &part : {std::string(parts)...})
        {
            EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
        }
    }

    /** \brief The output of `action` on standard error. */
    template <typename Action>
    std::string standardErrorOf(const Action &action)
    {
        ::testing::internal::CaptureStderr();
        try
        {
            action();
        }
        catch (const std::exception &error)
        {
            ADD_FAILURE() << error.what();
        }
        return ::testing::internal::GetCapturedStderr();
    }

    /** \brief The number of occurrences of `part` in `text`. */
    inline std::size_t countOf(const std::string &part, const std::string &text)
    {
        std::size_t count = 0;
        for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        {
            ++count;
        }
        return count;
    }

    /** \brief A unit cube centred at the origin as Wavefront .obj: 12 triangles, closed. */
    inline std::string cubeObj()
    {
        return "v -0.5 -0.5 -0.5\nv 0.5 -0.5 -0.5\nv 0.5 0.5 -0.5\nv -0.5 0.5 -0.5\n"
               "v -0.5 -0.5 0.5\nv 0.5 -0.5 0.5\nv 0.5 0.5 0.5\nv -0.5 0.5 0.5\n"
               "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\n"
               "f 4 1 5\nf 4 5 8\n";
    }
}  // namespace ompl_mfa::collision

#endif
