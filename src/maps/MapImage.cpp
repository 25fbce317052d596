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

#include "maps/MapImage.h"

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <mutex>

#include <magick/api.h>

#include "ompl_mfa/InputError.h"
#include "text/CLocaleScope.h"

namespace ompl_mfa::maps
{
    namespace
    {
        struct ImageDeleter
        {
            void operator()(Image *image) const
            {
                DestroyImage(image);
            }
        };

        struct ImageInfoDeleter
        {
            void operator()(ImageInfo *info) const
            {
                DestroyImageInfo(info);
            }
        };

        using ImagePointer = std::unique_ptr<Image, ImageDeleter>;

        class Exception
        {
        public:
            Exception()
            {
                GetExceptionInfo(&info_);
            }

            ~Exception()
            {
                DestroyExceptionInfo(&info_);
            }

            Exception(const Exception &) = delete;
            Exception &operator=(const Exception &) = delete;

            ExceptionInfo *get()
            {
                return &info_;
            }

            /* Warnings included: a truncated PNG is one. */
            bool isSet() const
            {
                return info_.severity != UndefinedException;
            }

            std::string text() const
            {
                const std::string reason = info_.reason != nullptr ? info_.reason : "unknown fault";
                return reason + (info_.description != nullptr ? std::string(": ") + info_.description : "");
            }

        private:
            ExceptionInfo info_;
        };

        void initialize()
        {
            static std::once_flag done;
            std::call_once(done,
                           []
                           {
                               Exception exception;
                               InitializeMagickEx(nullptr, MAGICK_OPT_NO_SIGNAL_HANDER, exception.get());
                               // campaigns fork, which threads of a library would not survive
                               SetMagickResourceLimit(ThreadsResource, 1);
                           });
        }

        /* GraphicsMagick's name of the format; empty for those that are not accepted. It would also run files that are
           programs, such as PostScript. */
        std::string formatOf(const std::string &bytes)
        {
            if (bytes.rfind("P2", 0) == 0 || bytes.rfind("P5", 0) == 0)
            {
                return "PGM";
            }
            if (bytes.rfind("\x89PNG", 0) == 0)
            {
                return "PNG";
            }
            return bytes.rfind("BM", 0) == 0 ? "BMP" : "";
        }

        std::vector<std::uint8_t> channel(const Image &image, const char *name, const std::string &place)
        {
            std::vector<std::uint8_t> values(image.columns * image.rows);
            Exception exception;
            if (DispatchImage(&image, 0, 0, image.columns, image.rows, name, CharPixel, values.data(),
                              exception.get()) != MagickPass)
            {
                throw InputError(place + ": cannot be converted to shades of grey: " + exception.text());
            }
            return values;
        }
    }  // namespace

    void requireMemory(std::size_t width, std::size_t height, const std::string &place)
    {
        // bytes per cell while a map is read: the image, its pixels in GraphicsMagick, the cells and their distances
        constexpr double CELL = 16.0;
        const double needed = CELL * static_cast<double>(width) * static_cast<double>(height);
        const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
        if (needed > memory)
        {
            constexpr double MEGABYTE = 1048576.0;
            throw InputError(place + ": a map of " + std::to_string(width) + " x " + std::to_string(height) +
                             " cells needs " + std::to_string(static_cast<std::uint64_t>(needed / MEGABYTE)) +
                             " MB; the machine has " + std::to_string(static_cast<std::uint64_t>(memory / MEGABYTE)) +
                             " MB");
        }
    }

    GrayImage readImage(const std::filesystem::path &file, const std::string &place)
    {
        std::ifstream in(file, std::ios::binary | std::ios::ate);
        if (!in || std::filesystem::is_directory(file))
        {
            throw InputError(place + ": no such image, or not readable: " + file.string());
        }
        std::string bytes(static_cast<std::size_t>(in.tellg()), '\0');
        in.seekg(0);
        in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        const std::string format = formatOf(bytes);
        if (!in || format.empty())
        {
            throw InputError(place + ": " + file.string() + " is not an image of a map; accepted are PGM, PNG and BMP");
        }

        initialize();
        const text::CLocaleScope plainNumbers;
        const std::unique_ptr<ImageInfo, ImageInfoDeleter> info(CloneImageInfo(nullptr));
        std::snprintf(info->magick, sizeof(info->magick), "%s", format.c_str());
        std::snprintf(info->filename, sizeof(info->filename), "%s:map", format.c_str());
        const auto readBy = [&](Image *(*read)(const ImageInfo *, const void *, const size_t, ExceptionInfo *))
        {
            Exception exception;
            ImagePointer image(read(info.get(), bytes.data(), bytes.size(), exception.get()));
            if (!image || exception.isSet())
            {
                throw InputError(place + ": " + file.string() + " is damaged: " + exception.text());
            }
            return image;
        };
        const ImagePointer size = readBy(PingBlob);
        requireMemory(size->columns, size->rows, place);
        const ImagePointer image = readBy(BlobToImage);
        return {image->columns, image->rows, channel(*image, "I", place),
                image->matte != 0 ? channel(*image, "A", place) : std::vector<std::uint8_t>()};
    }
}  // namespace ompl_mfa::maps
