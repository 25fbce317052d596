#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_RUN_FILE_
#define OMPL_MFA_BENCHMARKS_ANYTIME_RUN_FILE_

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <tuple>

#include "anytime/RunProcess.h"

namespace ompl_mfa::anytime
{
    /** \brief The runs of a campaign in a text file, a JSON object a line, appended as they come. A campaign that was
        interrupted, at any moment, goes on from its file. */
    class RunFile
    {
    public:
        /** \brief Opens \e file, and makes it if there is none; a last line without its end, which an interruption
            leaves, is removed. Throws InputError, naming file and line, where it is not a file of runs. */
        explicit RunFile(const std::filesystem::path &file);

        /** \brief Whether there is a run of this world, planner, seed, time limit and clock. */
        bool has(const RunRequest &request) const;

        /** \brief Appends a run that has finished. */
        void append(const RunProcess &run);

    private:
        using Key = std::tuple<std::string, std::string, std::uint32_t, double, std::string>;

        static Key keyOf(const RunRequest &request);

        void readKeys(const std::filesystem::path &file);

        std::set<Key> keys_;
        std::ofstream out_;
    };
}  // namespace ompl_mfa::anytime

#endif
