#ifndef OMPL_MFA_TEST_CLI_PDF_TEXT_
#define OMPL_MFA_TEST_CLI_PDF_TEXT_

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "cli/RunProgram.h"

/** \brief What poppler's pdftotext finds in a file. */
inline std::string pdfToText(const std::string &options, const std::string &file)
{
    const std::string out = temporaryFile("pdftotext");
    const std::string command = "pdftotext " + options + " '" + file + "' '" + out + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;  // NOLINT(bugprone-command-processor): the tests' own file
    std::string text = readFile(out);
    std::remove(out.c_str());
    return text;
}

/** \brief The words of a PDF, a line of the picture a line. */
inline std::string pdfText(const std::string &file)
{
    return pdfToText("", file);
}

#endif
