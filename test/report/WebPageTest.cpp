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

#include "report/WebPage.h"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::report
{
    TEST(WebPageTest, TextIsEscaped)
    {
        EXPECT_EQ(escaped("<b class=\"x\">'&'</b>"), "&lt;b class=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/b&gt;");
    }

    TEST(WebPageTest, SignificantDigits)
    {
        EXPECT_EQ(significant(1234.5, 3), "1234");
        EXPECT_EQ(significant(12.345, 3), "12.3");
        EXPECT_EQ(significant(0.00012345, 3), "0.000123");
        EXPECT_EQ(significant(-0.5, 2), "-0.50");
        EXPECT_EQ(significant(0.0, 3), "0");
        EXPECT_EQ(significant(std::numeric_limits<double>::infinity(), 3), "∞");
        EXPECT_EQ(significant(NAN, 3), "-");
    }

    TEST(WebPageTest, Base64OfRfc4648)
    {
        EXPECT_EQ(base64(""), "");
        EXPECT_EQ(base64("f"), "Zg==");
        EXPECT_EQ(base64("fo"), "Zm8=");
        EXPECT_EQ(base64("foo"), "Zm9v");
        EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
        EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
    }

    TEST(WebPageTest, NothingInTheDataEndsItsScript)
    {
        WebPage page;
        page.title = "<title>";
        page.data = {{"name", "</script><script>alert(1)</script>"}};
        page.scripts = {"run();"};
        const std::string html = htmlOf(page);
        EXPECT_EQ(html.find("</script><script>alert"), std::string::npos) << html;
        EXPECT_NE(html.find("\\u003c/script>\\u003cscript>alert(1)"), std::string::npos) << html;
        EXPECT_NE(html.find("<title>&lt;title&gt;</title>"), std::string::npos) << html;
        EXPECT_NE(html.find("default-src 'none'"), std::string::npos) << html;
    }

    TEST(WebPageTest, PicturesAreWhatTheirNamesSay)
    {
        const std::string folder = testing::TempDir() + "pictures_" + std::to_string(getpid()) + "/";
        std::filesystem::create_directories(folder);
        std::ofstream(folder + "a.svg") << "<svg/>";
        std::ofstream(folder + "a.png") << "<svg/>";
        std::ofstream(folder + "b.png") << "\x89PNG";
        std::ofstream(folder + "a.gif") << "GIF";
        EXPECT_EQ(pictureAddress(folder + "a.svg", "x"), "data:image/svg+xml;base64,PHN2Zy8+");
        EXPECT_EQ(pictureAddress(folder + "b.png", "x"), "data:image/png;base64,iVBORw==");
        EXPECT_THROW(pictureAddress(folder + "a.png", "x"), InputError);
        EXPECT_THROW(pictureAddress(folder + "a.gif", "x"), InputError);
        EXPECT_THROW(pictureAddress(folder + "none.png", "x"), InputError);
        std::filesystem::remove_all(folder);
    }

    TEST(WebPageTest, LooksAreDistinct)
    {
        for (std::size_t a = 0; a < 28; ++a)
        {
            for (std::size_t b = a + 1; b < 28; ++b)
            {
                EXPECT_TRUE(lineLook(a).colour != lineLook(b).colour || lineLook(a).pattern != lineLook(b).pattern)
                    << a << " " << b;
            }
        }
    }
}  // namespace ompl_mfa::report
