#ifndef OMPL_MFA_BENCHMARK_RUN_JOURNAL_
#define OMPL_MFA_BENCHMARK_RUN_JOURNAL_

#include <filesystem>
#include <string>
#include <vector>

#include "ompl_mfa/benchmark/RunRecord.h"

namespace ompl_mfa
{
    /** \brief The first line of a journal: which campaign its runs are of. */
    struct JournalHeader
    {
        /** \brief Campaign::fingerprint(). */
        std::string campaign;
        /** \brief "i/n", or empty for a whole campaign. */
        std::string shard;
        /** \brief When the campaign was started for the first time. */
        std::string start;
        /** \brief Seconds spent on the runs so far. */
        double duration{0.0};
    };

    /** \brief The runs of a campaign as they come in, in a file that survives the end of the program at any point.

        A text file with a line of JSON for the header and one for each run; a line is on the disk before append()
        returns. A last line that was cut off is dropped. */
    class RunJournal
    {
    public:
        /** \brief Starts a journal, replacing \e file. Throws InputError when it cannot be written or
            is in use. */
        RunJournal(std::filesystem::path file, JournalHeader header);

        /** \brief Opens a journal to continue it. Throws InputError when \e file cannot be read, is no journal or
            is in use. */
        explicit RunJournal(std::filesystem::path file);

        ~RunJournal();

        RunJournal(const RunJournal &) = delete;
        RunJournal &operator=(const RunJournal &) = delete;

        /** \brief Adds a run that ended \e duration seconds after the previous one, or after the start. Throws
            std::system_error when the disk is full. */
        void append(RunRecord record, double duration);

        const JournalHeader &header() const;

        /** \brief All runs, in the order in which they ended. */
        const std::vector<RunRecord> &records() const;

        /** \brief Reads only the header of \e file. Throws InputError when there is none. */
        static JournalHeader readHeader(const std::filesystem::path &file);

    private:
        void readRecords();
        void truncate(std::size_t size);
        void appendLine(const std::string &line);

        std::filesystem::path path_;
        JournalHeader header_;
        std::vector<RunRecord> records_;
        int file_{-1};
    };
}  // namespace ompl_mfa

#endif
