#include "PlyHeader.h"

#include <fstream>
#include <sstream>
#include <string>

#include "ompl_mfa/NumberText.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // Lines of a header end as on Unix, Windows or old Macs. A line that is longer than any of a header ends it.
        bool nextLine(std::istream &stream, std::string &line)
        {
            constexpr std::size_t longest = 4096;
            line.clear();
            for (int byte = stream.get(); stream && line.size() < longest; byte = stream.get())
            {
                if (byte == '\n' || byte == '\r')
                {
                    if (!line.empty())
                    {
                        return true;
                    }
                }
                else
                {
                    line += static_cast<char>(byte);
                }
            }
            return false;
        }
    }  // namespace

    std::size_t announcedTriangleStrips(const std::filesystem::path &file)
    {
        std::ifstream stream(file, std::ios::binary);
        std::string line;
        if (!nextLine(stream, line) || line.compare(0, 3, "ply") != 0)
        {
            return 0;
        }
        std::size_t strips = 0;
        while (nextLine(stream, line) && line.compare(0, 10, "end_header") != 0)
        {
            std::istringstream words(line);
            std::string keyword;
            std::string element;
            std::string number;
            std::size_t count = 0;
            words >> keyword >> element >> number;
            if (keyword == "element" && element == "tristrips" && readNumber(number, count))
            {
                strips += count;
            }
        }
        return strips;
    }
}  // namespace ompl_mfa::collision
