#ifndef OMPL_MFA_TEST_PLANNER_CONSOLE_RECORD_
#define OMPL_MFA_TEST_PLANNER_CONSOLE_RECORD_

#include <string>
#include <vector>

#include <ompl/util/Console.h>

namespace ompl_mfa::test
{
    /** \brief Takes OMPL's console over while it lives and keeps what is written to it. */
    class ConsoleRecord : private ompl::msg::OutputHandler
    {
    public:
        ConsoleRecord()
          : previous_(ompl::msg::getOutputHandler())
          , previousLevel_(ompl::msg::getLogLevel())
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_INFO);
            ompl::msg::useOutputHandler(this);
        }

        ~ConsoleRecord() override
        {
            ompl::msg::useOutputHandler(previous_);
            ompl::msg::setLogLevel(previousLevel_);
        }

        ConsoleRecord(const ConsoleRecord &) = delete;
        ConsoleRecord &operator=(const ConsoleRecord &) = delete;

        /** \brief Whether a warning or an error contained \e text. */
        bool mentions(const std::string &text) const
        {
            for (const auto &line : complaints_)
            {
                if (line.find(text) != std::string::npos)
                    return true;
            }
            return false;
        }

        const std::vector<std::string> &complaints() const
        {
            return complaints_;
        }

    private:
        void log(const std::string &text, ompl::msg::LogLevel level, const char * /*filename*/, int /*line*/) override
        {
            if (level >= ompl::msg::LOG_WARN)
                complaints_.push_back(text);
        }

        ompl::msg::OutputHandler *previous_;
        ompl::msg::LogLevel previousLevel_;
        std::vector<std::string> complaints_;
    };
}  // namespace ompl_mfa::test

#endif
