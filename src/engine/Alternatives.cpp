#include "engine/Alternatives.h"

namespace ompl_mfa
{
    namespace
    {
        constexpr std::size_t CAPACITY = 3;
    }  // namespace

    void Alternatives::add(const Waypoints &path)
    {
        if (paths_.size() < CAPACITY)
            paths_.push_back(path);
        else
            paths_[next_++ % CAPACITY] = path;
    }
}  // namespace ompl_mfa
