#ifndef OMPL_MFA_BENCHMARKS_PAPER_STUDY_
#define OMPL_MFA_BENCHMARKS_PAPER_STUDY_

#include <cstddef>
#include <functional>
#include <string>

namespace ompl_mfa::paper
{
    /** \brief Where the study reads and writes, and how much of it runs. */
    struct StudyOptions
    {
        std::string worldFile;
        std::string outputFolder;
        unsigned int paperRuns{30};
        unsigned int seededRuns{10};
        unsigned int functionRuns{6};
        unsigned int sliceRuns{10};
        unsigned int threads{2};
    };

    /** \brief m - 1 of the study's path problems. */
    constexpr unsigned int SLICES = 6;

    /** \brief Calls job(0), ..., job(count - 1) from \e threads threads, in any order. */
    void runParallel(std::size_t count, unsigned int threads, const std::function<void(std::size_t)> &job);

    /** \brief The scenes and their optima: scenes.csv, obstacles.csv, optima.csv. */
    void writeScenes(const StudyOptions &options);

    /** \brief Path planning by contenders() and ablations(): runs.csv, times.csv, convergence.csv, paths.csv. */
    void studyPaths(const StudyOptions &options);

    /** \brief Path planning by the planner with all its parts, in one thread: the same files, named planner_runs.csv
        and so on. */
    void studyPlanner(const StudyOptions &options);

    /** \brief How the result depends on the number of slices: slices.csv. */
    void studySlices(const StudyOptions &options);

    /** \brief Test functions: functions.csv, and populations.csv for eq. (19). */
    void studyFunctions(const StudyOptions &options);
}  // namespace ompl_mfa::paper

#endif
