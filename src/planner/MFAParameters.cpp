#include <type_traits>

#include "ompl_mfa/planner/MFA.h"
#include "ompl_mfa/planner/RangedParam.h"

namespace ompl_mfa
{
    namespace
    {
        /* Fireflies of the paper, and of a swarm that other parts assist. */
        constexpr unsigned int PAPER_POPULATION = 100;
        constexpr unsigned int POPULATION = 20;
    }  // namespace

    void MFA::declareParameters()
    {
        const auto declare = [this](const auto &parameter)
        {
            const auto member = parameter.member;
            using T = std::decay_t<decltype(settings_.*member)>;
            params_.add(std::make_shared<RangedParam<T>>(
                parameter.name, parameter.accepted, [this, member](const T &value) { settings_.*member = value; },
                [this, member] { return settings_.*member; }));
        };
        for (const auto &parameter : mfaParameters())
            std::visit(declare, parameter);
    }

    template <typename T>
    void MFA::set(T MFASettings::*member, const T &value)
    {
        for (const auto &any : mfaParameters())
        {
            const auto *parameter = std::get_if<MFAParameter<T>>(&any);
            if (parameter != nullptr && parameter->member == member)
                require(parameter->accepted, getName() + ": " + parameter->name, value);
        }
        settings_.*member = value;
    }

    FireflyOptimizer::Settings MFA::swarmSettings() const
    {
        FireflyOptimizer::Settings settings;
        settings.variant = search_.variant == "mfa" ? FireflyOptimizer::Variant::MFA : FireflyOptimizer::Variant::FA;
        settings.populationSize = paper_ ? PAPER_POPULATION : POPULATION;
        if (search_.populationSize != 0)
            settings.populationSize = search_.populationSize;
        settings.generations = search_.generations;
        settings.gamma = search_.gamma;
        settings.alpha = search_.alpha;
        settings.eta = search_.eta;
        return settings;
    }

    void MFA::setVariant(const std::string &variant)
    {
        set(&MFASettings::variant, variant);
    }

    std::string MFA::getVariant() const
    {
        return settings_.variant;
    }

    void MFA::setPopulationSize(unsigned int size)
    {
        set(&MFASettings::populationSize, size);
    }

    unsigned int MFA::getPopulationSize() const
    {
        return settings_.populationSize;
    }

    void MFA::setSlices(unsigned int slices)
    {
        set(&MFASettings::slices, slices);
    }

    unsigned int MFA::getSlices() const
    {
        return settings_.slices;
    }

    void MFA::setGenerations(unsigned int generations)
    {
        set(&MFASettings::generations, generations);
    }

    unsigned int MFA::getGenerations() const
    {
        return settings_.generations;
    }

    void MFA::setGamma(double gamma)
    {
        set(&MFASettings::gamma, gamma);
    }

    double MFA::getGamma() const
    {
        return settings_.gamma;
    }

    void MFA::setAlpha(double alpha)
    {
        set(&MFASettings::alpha, alpha);
    }

    double MFA::getAlpha() const
    {
        return settings_.alpha;
    }

    void MFA::setEta(double eta)
    {
        set(&MFASettings::eta, eta);
    }

    double MFA::getEta() const
    {
        return settings_.eta;
    }

    void MFA::setGuide(const std::string &guide)
    {
        set(&MFASettings::guide, guide);
    }

    std::string MFA::getGuide() const
    {
        return settings_.guide;
    }

    void MFA::setRecombination(bool recombination)
    {
        set(&MFASettings::recombination, recombination);
    }

    bool MFA::getRecombination() const
    {
        return settings_.recombination;
    }

    void MFA::setTightening(bool tightening)
    {
        set(&MFASettings::tightening, tightening);
    }

    bool MFA::getTightening() const
    {
        return settings_.tightening;
    }

    void MFA::setSeed(std::uint32_t seed)
    {
        set(&MFASettings::seed, seed);
    }

    std::uint32_t MFA::getSeed() const
    {
        return settings_.seed;
    }

    void MFA::setStateCheckTime(double microseconds)
    {
        set(&MFASettings::stateCheckTime, microseconds);
    }

    double MFA::getStateCheckTime() const
    {
        return settings_.stateCheckTime;
    }

    void MFA::setThreads(unsigned int threads)
    {
        set(&MFASettings::threads, threads);
    }

    unsigned int MFA::getThreads() const
    {
        return settings_.threads;
    }

    void MFA::setGuidePlanner(const ompl::base::PlannerAllocator &allocator)
    {
        guidePlanner_ = allocator;
    }
}  // namespace ompl_mfa
