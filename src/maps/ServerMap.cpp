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

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "maps/MapImage.h"
#include "maps/MapReaders.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "text/NumberText.h"

namespace ompl_mfa::maps
{
    namespace
    {
        enum class Mode
        {
            Trinary,
            Scale,
            Raw
        };

        /* The keys of the YAML file. */
        struct Description
        {
            std::string image;
            std::string imagePlace;
            Mode mode{Mode::Trinary};
            bool negate{false};
            float occupiedThreshold{0.0F};
            float freeThreshold{0.0F};
            MapFrame frame;
        };

        class Reader
        {
        public:
            explicit Reader(const std::filesystem::path &file)
              : file_(file)
            {
                try
                {
                    root_ = YAML::LoadFile(file.string());
                }
                catch (const YAML::BadFile &)
                {
                    throw InputError(file.string() + ": map not found or not readable");
                }
                catch (const YAML::Exception &error)
                {
                    throw InputError(place(error.mark) + ": malformed YAML: " + error.msg);
                }
                checkKeys();
            }

            Description read() const
            {
                Description description;
                description.image = scalar("image", "the name of a PGM, PNG or BMP image");
                description.imagePlace = place(root_["image"].Mark()) + ": image = " + description.image;
                if (description.image.empty())
                {
                    fail("image", "expected the name of a PGM, PNG or BMP image");
                }
                description.frame.resolution = number("resolution", "a number above 0 (metres per cell)");
                if (description.frame.resolution <= 0.0)
                {
                    fail("resolution", "expected a number above 0 (metres per cell)");
                }
                readOrigin(description.frame);
                readMode(description);
                readThresholds(description);
                description.negate = readNegate();
                return description;
            }

        private:
            std::string place(const YAML::Mark &mark) const
            {
                return file_.string() + (mark.is_null() ? "" : ":" + std::to_string(mark.line + 1));
            }

            [[noreturn]] void fail(const std::string &key, const std::string &fault) const
            {
                const YAML::Node node = root_[key];
                throw InputError(place(node.Mark()) + ": " + key +
                                 (node.IsScalar() ? " = " + node.Scalar() : std::string()) + ": " + fault);
            }

            void checkKeys() const
            {
                static const std::set<std::string> KEYS = {
                    "image", "mode", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"};
                if (!root_.IsMap())
                {
                    throw InputError(file_.string() +
                                     ": expected the keys of a map: image, resolution, origin, occupied_thresh, "
                                     "free_thresh, negate, mode");
                }
                std::set<std::string> seen;
                for (const auto &entry : root_)
                {
                    const auto key = entry.first.as<std::string>("");
                    if (KEYS.count(key) == 0)
                    {
                        throw InputError(place(entry.first.Mark()) + ": unknown key '" + key +
                                         "'; accepted are image, resolution, origin, occupied_thresh, free_thresh, "
                                         "negate and mode");
                    }
                    if (!seen.insert(key).second)
                    {
                        throw InputError(place(entry.first.Mark()) + ": the key '" + key + "' is set twice");
                    }
                }
            }

            std::string scalar(const std::string &key, const std::string &accepted) const
            {
                const YAML::Node node = root_[key];
                if (!node || node.IsNull())
                {
                    throw InputError(file_.string() + ": the key '" + key + "' is missing; expected " + accepted);
                }
                if (!node.IsScalar())
                {
                    fail(key, "expected " + accepted);
                }
                return node.Scalar();
            }

            double number(const std::string &key, const std::string &accepted) const
            {
                double value = 0.0;
                if (!text::readNumber(scalar(key, accepted), value) || !std::isfinite(value))
                {
                    fail(key, "expected " + accepted);
                }
                return value;
            }

            void readOrigin(MapFrame &frame) const
            {
                constexpr std::size_t SIZE = 3;
                const YAML::Node node = root_["origin"];
                const std::string accepted = "expected [x, y, yaw], the pose of the lower left corner of the image";
                if (!node)
                {
                    throw InputError(file_.string() + ": the key 'origin' is missing; " + accepted);
                }
                if (!node.IsSequence() || node.size() != SIZE)
                {
                    fail("origin", accepted);
                }
                std::array<double, SIZE> values{};
                for (std::size_t i = 0; i < SIZE; ++i)
                {
                    if (!node[i].IsScalar() || !text::readNumber(node[i].Scalar(), values[i]) ||
                        !std::isfinite(values[i]))
                    {
                        fail("origin", accepted);
                    }
                }
                frame.origin = Eigen::Vector2d(values[0], values[1]);
                frame.yaw = values[2];
            }

            void readMode(Description &description) const
            {
                if (!root_["mode"])
                {
                    return;
                }
                const std::string accepted = "one of trinary, scale, raw";
                const std::string mode = scalar("mode", accepted);
                if (mode != "trinary" && mode != "scale" && mode != "raw")
                {
                    fail("mode", "expected " + accepted);
                }
                description.mode = mode == "trinary" ? Mode::Trinary : mode == "scale" ? Mode::Scale : Mode::Raw;
            }

            void readThresholds(Description &description) const
            {
                const std::string accepted = "a number from 0 to 1";
                for (const char *key : {"occupied_thresh", "free_thresh"})
                {
                    const double value = number(key, accepted);
                    if (value < 0.0 || value > 1.0)
                    {
                        fail(key, "expected " + accepted);
                    }
                    (std::string(key) == "free_thresh" ? description.freeThreshold : description.occupiedThreshold) =
                        static_cast<float>(value);
                }
                if (description.freeThreshold >= description.occupiedThreshold)
                {
                    fail("free_thresh", "expected less than occupied_thresh");
                }
            }

            bool readNegate() const
            {
                const std::string accepted = "one of 0, 1, false, true";
                const std::string word = lowerCase(scalar("negate", accepted));
                if (word != "0" && word != "1" && word != "false" && word != "true")
                {
                    fail("negate", "expected " + accepted);
                }
                return word == "1" || word == "true";
            }

            std::filesystem::path file_;
            YAML::Node root_;
        };

        /* The cell of each brightness. */
        std::array<Cell, 256> cellsOf(const Description &description)
        {
            constexpr int OCCUPIED = 100;
            constexpr float WHITE = 255.0F;
            std::array<Cell, 256> cells{};
            for (int shade = 0; shade < static_cast<int>(cells.size()); ++shade)
            {
                Cell &cell = cells[static_cast<std::size_t>(shade)];
                if (description.mode == Mode::Raw)
                {
                    cell = shade < OCCUPIED ? Cell::Free : shade == OCCUPIED ? Cell::Occupied : Cell::Unknown;
                    continue;
                }
                const float brightness = static_cast<float>(shade) / WHITE;
                const float occupancy = description.negate ? brightness : 1.0F - brightness;
                const float share = (occupancy - description.freeThreshold) /
                                    (description.occupiedThreshold - description.freeThreshold);
                const bool isOccupied =
                    share >= 1.0F || (description.mode == Mode::Scale && std::lround(share * OCCUPIED) >= OCCUPIED);
                const Cell between = description.mode == Mode::Scale ? Cell::Free : Cell::Unknown;
                cell = isOccupied ? Cell::Occupied : share <= 0.0F ? Cell::Free : between;
            }
            return cells;
        }
    }  // namespace

    GridMap loadServerMap(const std::filesystem::path &file)
    {
        constexpr std::uint8_t OPAQUE = 255;
        const Description description = Reader(file).read();
        // an absolute name replaces the folder
        const GrayImage image = readImage(file.parent_path() / description.image, description.imagePlace);
        const std::array<Cell, 256> cellOf = cellsOf(description);
        const bool seesThrough = !image.opacity.empty() && description.mode != Mode::Raw;
        std::vector<Cell> cells(image.width * image.height);
        for (std::size_t y = 0; y < image.height; ++y)
        {
            const std::size_t row = (image.height - 1 - y) * image.width;
            for (std::size_t x = 0; x < image.width; ++x)
            {
                const bool isOpaque = !seesThrough || image.opacity[row + x] == OPAQUE;
                cells[y * image.width + x] = isOpaque ? cellOf[image.brightness[row + x]] : Cell::Unknown;
            }
        }
        return GridMap(image.width, image.height, std::move(cells), description.frame);
    }
}  // namespace ompl_mfa::maps
