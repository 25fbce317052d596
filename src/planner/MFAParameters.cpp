#include <stdexcept>

#include <boost/lexical_cast.hpp>

#include <ompl/util/Exception.h>

#include "ompl_mfa/planner/MFA.h"
#include "ompl_mfa/planner/RangedParam.h"

namespace ompl_mfa
{
    namespace
    {
        constexpr unsigned int MAX_SLICES = 1000;
        constexpr unsigned int MAX_THREADS = 64;
        /* Fireflies of the paper, and of a swarm that other parts assist. */
        constexpr unsigned int PAPER_POPULATION = 100;
        constexpr unsigned int POPULATION = 20;

        FireflyOptimizer::Settings validated(const FireflyOptimizer::Settings &settings)
        {
            try
            {
                settings.validate();
            }
            catch (const std::invalid_argument &error)
            {
                throw ompl::Exception("MFA", error.what());
            }
            return settings;
        }
    }  // namespace

    void MFA::declareParameters()
    {
        const auto declare = [this](const char *name, auto setter, auto getter, const char *range)
        {
            using T = decltype((this->*getter)());
            params_.add(std::make_shared<RangedParam<T>>(
                name, [this, setter](const T &value) { (this->*setter)(value); },
                [this, getter] { return (this->*getter)(); }, range));
        };
        declare("variant", &MFA::setVariant, &MFA::getVariant, "mfa,fa");
        declare("population_size", &MFA::setPopulationSize, &MFA::getPopulationSize, "0:1:10000");
        declare("slices", &MFA::setSlices, &MFA::getSlices, "1:1:1000");
        declare("generations", &MFA::setGenerations, &MFA::getGenerations, "1:1:100000");
        declare("gamma", &MFA::setGamma, &MFA::getGamma, "0.0:0.01:100.0");
        declare("alpha", &MFA::setAlpha, &MFA::getAlpha, "0.0:0.01:1.0");
        declare("eta", &MFA::setEta, &MFA::getEta, "0.0:0.01:2.0");
        declare("guide", &MFA::setGuide, &MFA::getGuide, "none,trees,roadmap,both");
        declare("recombination", &MFA::setRecombination, &MFA::getRecombination, "0,1");
        declare("tightening", &MFA::setTightening, &MFA::getTightening, "0,1");
        declare("seed", &MFA::setSeed, &MFA::getSeed, "0:1:4294967295");
        declare("threads", &MFA::setThreads, &MFA::getThreads, "1:1:64");
    }

    template <typename T>
    void MFA::setSwarm(T FireflyOptimizer::Settings::*setting, T value)
    {
        auto settings = settings_;
        settings.*setting = value;
        settings_ = validated(settings);
    }

    void MFA::setVariant(const std::string &variant)
    {
        if (variant != "mfa" && variant != "fa")
            throw ompl::Exception("MFA", "variant = '" + variant + "': accepted are mfa and fa");
        setSwarm(&FireflyOptimizer::Settings::variant,
                 variant == "mfa" ? FireflyOptimizer::Variant::MFA : FireflyOptimizer::Variant::FA);
    }

    std::string MFA::getVariant() const
    {
        return settings_.variant == FireflyOptimizer::Variant::MFA ? "mfa" : "fa";
    }

    void MFA::setPopulationSize(unsigned int size)
    {
        auto settings = settings_;
        if (size != 0)
            settings.populationSize = size;
        validated(settings);
        populationSize_ = size;
    }

    unsigned int MFA::getPopulationSize() const
    {
        return populationSize_;
    }

    FireflyOptimizer::Settings MFA::swarmSettings() const
    {
        const bool paper = !useTrees_ && !useRoadmap_ && !useRecombination_ && !useTightening_;
        auto settings = settings_;
        if (populationSize_ != 0)
            settings.populationSize = populationSize_;
        else
            settings.populationSize = paper ? PAPER_POPULATION : POPULATION;
        return settings;
    }

    void MFA::setSlices(unsigned int slices)
    {
        if (slices < 1 || slices > MAX_SLICES)
            throw ompl::Exception(
                "MFA", "slices = " + std::to_string(slices) + ": accepted is 1 to " + std::to_string(MAX_SLICES));
        slices_ = slices;
    }

    unsigned int MFA::getSlices() const
    {
        return slices_;
    }

    void MFA::setGenerations(unsigned int generations)
    {
        setSwarm(&FireflyOptimizer::Settings::generations, generations);
    }

    unsigned int MFA::getGenerations() const
    {
        return settings_.generations;
    }

    void MFA::setGamma(double gamma)
    {
        setSwarm(&FireflyOptimizer::Settings::gamma, gamma);
    }

    double MFA::getGamma() const
    {
        return settings_.gamma;
    }

    void MFA::setAlpha(double alpha)
    {
        setSwarm(&FireflyOptimizer::Settings::alpha, alpha);
    }

    double MFA::getAlpha() const
    {
        return settings_.alpha;
    }

    void MFA::setEta(double eta)
    {
        setSwarm(&FireflyOptimizer::Settings::eta, eta);
    }

    double MFA::getEta() const
    {
        return settings_.eta;
    }

    void MFA::setGuide(const std::string &guide)
    {
        if (guide != "none" && guide != "trees" && guide != "roadmap" && guide != "both")
            throw ompl::Exception("MFA", "guide = '" + guide + "': accepted are none, trees, roadmap and both");
        useTrees_ = guide == "trees" || guide == "both";
        useRoadmap_ = guide == "roadmap" || guide == "both";
    }

    std::string MFA::getGuide() const
    {
        if (useTrees_)
            return useRoadmap_ ? "both" : "trees";
        return useRoadmap_ ? "roadmap" : "none";
    }

    void MFA::setRecombination(bool recombination)
    {
        useRecombination_ = recombination;
    }

    bool MFA::getRecombination() const
    {
        return useRecombination_;
    }

    void MFA::setTightening(bool tightening)
    {
        useTightening_ = tightening;
    }

    bool MFA::getTightening() const
    {
        return useTightening_;
    }

    void MFA::setSeed(std::uint32_t seed)
    {
        seed_ = seed;
    }

    std::uint32_t MFA::getSeed() const
    {
        return seed_;
    }

    void MFA::setThreads(unsigned int threads)
    {
        if (threads < 1 || threads > MAX_THREADS)
            throw ompl::Exception(
                "MFA", "threads = " + std::to_string(threads) + ": accepted is 1 to " + std::to_string(MAX_THREADS));
        threads_ = threads;
    }

    unsigned int MFA::getThreads() const
    {
        return threads_;
    }

    void MFA::setGuidePlanner(const ompl::base::PlannerAllocator &allocator)
    {
        guidePlanner_ = allocator;
    }
}  // namespace ompl_mfa
