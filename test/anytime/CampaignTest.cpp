#include "anytime/Campaign.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include <unistd.h>

#include "anytime/WorldList.h"
#include "ompl_mfa/InputError.h"

namespace anytime = ompl_mfa::anytime;

namespace
{
    class Campaign : public testing::Test
    {
    protected:
        ~Campaign() override
        {
            std::filesystem::remove(file_);
        }

        std::size_t lineCount() const
        {
            std::ifstream in(file_);
            std::size_t count = 0;
            for (std::string line; std::getline(in, line);)
                ++count;
            return count;
        }

        anytime::CampaignRequest request_{
            anytime::selectWorlds("^(wall_gap|dividing_walls)_2d_1$"), {"rrtconnect"}, 2, 5.0, anytime::Clock::CPU, 1};
        std::filesystem::path file_{std::filesystem::temp_directory_path() /
                                    ("anytime-campaign-" + std::to_string(getpid()) + ".jsonl")};
        std::ostringstream progress_;
    };
}  // namespace

TEST_F(Campaign, MakesEveryRunOnce)
{
    anytime::runCampaign(request_, file_, progress_);
    EXPECT_EQ(lineCount(), 4U);
    EXPECT_NE(progress_.str().find("[4/4]"), std::string::npos) << progress_.str();
    request_.seeds = 3;
    progress_.str("");
    anytime::runCampaign(request_, file_, progress_);
    EXPECT_EQ(lineCount(), 6U);
    EXPECT_NE(progress_.str().find("[2/2]"), std::string::npos) << progress_.str();
}

TEST_F(Campaign, RefusesWhatCannotRun)
{
    request_.jobs = 0;
    EXPECT_THROW(anytime::runCampaign(request_, file_, progress_), ompl_mfa::InputError);
    request_.jobs = 1;
    request_.planners = {"no_such_planner"};
    EXPECT_THROW(anytime::runCampaign(request_, file_, progress_), ompl_mfa::InputError);
    request_.planners = {"rrtconnect:range=much"};
    EXPECT_THROW(anytime::runCampaign(request_, file_, progress_), ompl_mfa::InputError);
    EXPECT_EQ(lineCount(), 0U);
}
