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

#include "campaign/RunJournal.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "benchmark/InputErrorOf.h"

using ompl_mfa::test::inputErrorOf;

namespace ompl_mfa::campaign
{
    namespace
    {
        std::filesystem::path temporaryJournal(const std::string &name)
        {
            return testing::TempDir() + "journal_" + std::to_string(getpid()) + "_" + name;
        }

        JournalHeader someHeader()
        {
            return {"abc", "1/2", "today", {{"cores", 2}}, 0.0};
        }

        Json someRun(unsigned int run)
        {
            return {{"run", run}, {"message", "line one\nbytes \xff\xfe"}, {"cost", 0.1234567890123}};
        }

        /* Appends each record to \e records. */
        RecordVisitor keepIn(std::vector<Json> &records)
        {
            return [&records](const Json &record, std::size_t) { records.push_back(record); };
        }

        void ignore(const Json &, std::size_t)
        {
        }
    }  // namespace

    TEST(RunJournal, GivesBackWhatItWasGiven)
    {
        const auto file = temporaryJournal("whole");
        {
            RunJournal journal(file, someHeader());
            journal.append(someRun(3), 0.25);
            EXPECT_EQ(journal.header().duration, 0.25);
        }
        std::vector<Json> records;
        const JournalHeader header = readJournal(file, keepIn(records));
        EXPECT_EQ(header.campaign, "abc");
        EXPECT_EQ(header.shard, "1/2");
        EXPECT_EQ(header.start, "today");
        EXPECT_EQ(header.description, (Json{{"cores", 2}}));
        EXPECT_EQ(header.duration, 0.25);
        ASSERT_EQ(records.size(), 1u);
        EXPECT_EQ(records[0].at("run"), 3);
        EXPECT_EQ(records[0].at("cost"), 0.1234567890123);
        EXPECT_EQ(records[0].at("message").get<std::string>().substr(0, 15), "line one\nbytes ");
        std::filesystem::remove(file);
    }

    TEST(RunJournal, SurvivesBeingCutOffAnywhere)
    {
        const auto file = temporaryJournal("cut");
        std::vector<std::uintmax_t> ends;
        {
            RunJournal journal(file, someHeader());
            ends.push_back(std::filesystem::file_size(file));
            for (unsigned int run = 0; run < 3; ++run)
            {
                journal.append(someRun(run), 1.5);
                ends.push_back(std::filesystem::file_size(file));
            }
            EXPECT_EQ(journal.header().duration, 4.5);
        }
        const auto copy = temporaryJournal("copy");
        for (std::uintmax_t size = 0; size <= ends[3]; ++size)
        {
            std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing);
            std::filesystem::resize_file(copy, size);
            if (size < ends[0])
            {
                EXPECT_NE(inputErrorOf([&] { readJournal(copy, ignore); }), "") << size;
                continue;
            }
            std::size_t whole = 0;
            while (whole < 3 && ends[whole + 1] <= size)
            {
                ++whole;
            }
            std::vector<Json> records;
            readJournal(copy, keepIn(records));
            EXPECT_EQ(records.size(), whole);
            EXPECT_EQ(std::filesystem::file_size(copy), size) << "reading does not change the file";
            {
                RunJournal journal(copy, ignore);
                EXPECT_EQ(journal.header().duration, 1.5 * static_cast<double>(whole));
                journal.append(someRun(9), 1.0);
            }
            // The next record must not be appended to the rest of the truncated line.
            records.clear();
            readJournal(copy, keepIn(records));
            ASSERT_EQ(records.size(), whole + 1);
            EXPECT_EQ(records.back().at("run"), 9);
        }
        std::filesystem::remove(file);
        std::filesystem::remove(copy);
    }

    TEST(RunJournal, RefusesWhatIsNoJournal)
    {
        const auto file = temporaryJournal("other");
        const auto errorOf = [&file](const RecordVisitor &visit)
        { return inputErrorOf([&] { RunJournal journal(file, visit); }); };
        std::ofstream(file) << "hello\nworld\n";
        EXPECT_NE(errorOf(ignore).find(file.string() + ":1: not the first line of a campaign's journal"),
                  std::string::npos);
        const std::string header = R"({"campaign":"a","shard":"","start":"t","description":null})";
        std::ofstream(file) << header << "\n{\"run\": 3}\n";
        EXPECT_NE(errorOf(ignore).find(":2: not a run: "), std::string::npos) << "it has no duration";
        std::ofstream(file) << header << "\n{\"run\": 3, \"duration\": 1.0}\n{\"run\": 4, \"duration\": 1.0}\n";
        EXPECT_EQ(errorOf(ignore), "");
        const auto refuse = [](const Json &record, std::size_t)
        {
            if (record.at("run") == 4)
            {
                throw std::invalid_argument("not like this");
            }
        };
        EXPECT_NE(errorOf(refuse).find(":3: not like this"), std::string::npos);
        EXPECT_NE(errorOf([](const Json &record, std::size_t) { record.at("cost"); }).find(":2: not a run: "),
                  std::string::npos);
        std::filesystem::remove(file);
        EXPECT_NE(inputErrorOf([&] { readJournal(file, ignore); }).find("cannot be read"), std::string::npos);
        EXPECT_NE(
            inputErrorOf([] { RunJournal journal("/no/such/journal", JournalHeader()); }).find("cannot be written"),
            std::string::npos);
    }

    TEST(RunJournal, IsWrittenByOneCampaignAtATime)
    {
        const auto file = temporaryJournal("locked");
        {
            const RunJournal journal(file, someHeader());
            EXPECT_NE(inputErrorOf([&] { RunJournal other(file, ignore); }).find("in use"), std::string::npos);
            EXPECT_EQ(readJournal(file, ignore).campaign, "abc") << "reading is allowed";
        }
        // A journal that could not be opened is not left locked.
        std::ofstream(file) << "hello\n";
        EXPECT_NE(inputErrorOf([&] { RunJournal other(file, ignore); }), "");
        EXPECT_EQ(inputErrorOf([&] { RunJournal other(file, someHeader()); }), "");
        std::filesystem::remove(file);
    }
}  // namespace ompl_mfa::campaign
