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

#include "benchmark/PlannerTable.h"

#include <vector>

#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>
#include <ompl/geometric/planners/rlrt/BiRLRT.h>
#include <ompl/geometric/planners/rlrt/RLRT.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyLBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/rrt/TSRRT.h>
#include <ompl/geometric/planners/rrt/pRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/sbl/pSBL.h>
#include <ompl/geometric/planners/sst/SST.h>
#include <ompl/geometric/planners/stride/STRIDE.h>

#include "OmplCompatibility.h"
#include "benchmark/PositionTaskSpace.h"
#include "benchmark/RestartSimplify.h"
#include "ompl_mfa/planner/MFA.h"

#ifdef OMPL_MFA_HAS_EITSTAR
#include <ompl/geometric/planners/informedtrees/EITstar.h>
#endif
#ifdef OMPL_MFA_HAS_EIRMSTAR
#include <ompl/geometric/planners/informedtrees/EIRMstar.h>
#endif
#ifdef OMPL_MFA_HAS_BLITSTAR
#include <ompl/geometric/planners/lazyinformedtrees/BLITstar.h>
#endif
#ifdef OMPL_MFA_HAS_AOXRRTCONNECT
#include <ompl/geometric/planners/rrt/AOXRRTConnect.h>
#endif
#ifdef OMPL_MFA_HAS_ATRRT
#include <ompl/geometric/planners/rrt/ATRRT.h>
#endif
#ifdef OMPL_MFA_HAS_TRRTSTAR
#include <ompl/geometric/planners/rrt/TRRTstar.h>
#endif
#ifdef OMPL_MFA_HAS_QUOTIENT_SPACES
#include <ompl/geometric/planners/quotientspace/QRRT.h>
#endif
#ifdef OMPL_MFA_HAS_MULTILEVEL
#include <ompl/multilevel/planners/qmp/QMP.h>
#include <ompl/multilevel/planners/qmp/QMPStar.h>
#include <ompl/multilevel/planners/qrrt/QRRT.h>
#include <ompl/multilevel/planners/qrrt/QRRTStar.h>
#endif

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;
        namespace og = ompl::geometric;

        template <typename Planner>
        PlannerEntry entry(const std::string &title)
        {
            return {title,
                    [](const ob::SpaceInformationPtr &si) -> ob::PlannerPtr { return std::make_shared<Planner>(si); }};
        }

        /* Multi-level planners take a sequence of spaces; here it has length 1, the space of the config. */
        template <typename Planner>
        PlannerEntry singleLevelEntry(const std::string &title)
        {
            return {title,
                    [](const ob::SpaceInformationPtr &si) -> ob::PlannerPtr
                    {
                        std::vector<ob::SpaceInformationPtr> levels{si};
                        return std::make_shared<Planner>(levels);
                    }};
        }

        PlannerEntry paperEntry(const std::string &title, const std::string &variant)
        {
            PlannerEntry made = entry<MFA>(title);
            made.allocate = [variant](const ob::SpaceInformationPtr &si) -> ob::PlannerPtr
            {
                auto planner = std::make_shared<MFA>(si);
                planner->setVariant(variant);
                planner->setGuide("none");
                planner->setRecombination(false);
                planner->setTightening(false);
                return planner;
            };
            return made;
        }

        void addOwnPlanners(std::map<std::string, PlannerEntry> &table)
        {
            table["mfa"] = entry<MFA>("MFA");
            table["mfa_paper"] = paperEntry("MFA-paper", "mfa");
            table["fa_paper"] = paperEntry("FA-paper", "fa");
            table["restart_simplify"] = entry<RestartSimplify>("RestartSimplify");
        }

        ob::PlannerPtr allocateTSRRT(const ob::SpaceInformationPtr &si)
        {
            return std::make_shared<og::TSRRT>(si, std::make_shared<PositionTaskSpace>(si));
        }

        void addTreePlanners(std::map<std::string, PlannerEntry> &table)
        {
            table["rrt"] = entry<og::RRT>("RRT");
            table["rrtconnect"] = entry<og::RRTConnect>("RRTConnect");
            table["lazyrrt"] = entry<og::LazyRRT>("LazyRRT");
            table["trrt"] = entry<og::TRRT>("TRRT");
            table["bitrrt"] = entry<og::BiTRRT>("BiTRRT");
            table["tsrrt"] = {"TSRRT", allocateTSRRT};
            table["prrt"] = entry<og::pRRT>("pRRT");
            table["rlrt"] = entry<og::RLRT>("RLRT");
            table["birlrt"] = entry<og::BiRLRT>("BiRLRT");
            table["est"] = entry<og::EST>("EST");
            table["biest"] = entry<og::BiEST>("BiEST");
            table["projest"] = entry<og::ProjEST>("ProjEST");
            table["sbl"] = entry<og::SBL>("SBL");
            table["psbl"] = entry<og::pSBL>("pSBL");
            table["kpiece"] = entry<og::KPIECE1>("KPIECE1");
            table["bkpiece"] = entry<og::BKPIECE1>("BKPIECE1");
            table["lbkpiece"] = entry<og::LBKPIECE1>("LBKPIECE1");
            table["pdst"] = entry<og::PDST>("PDST");
            table["stride"] = entry<og::STRIDE>("STRIDE");
            table["sst"] = entry<og::SST>("SST");
        }

        void addRoadmapPlanners(std::map<std::string, PlannerEntry> &table)
        {
            table["prm"] = entry<og::PRM>("PRM");
            table["prmstar"] = entry<og::PRMstar>("PRMstar");
            table["lazyprm"] = entry<og::LazyPRM>("LazyPRM");
            table["lazyprmstar"] = entry<og::LazyPRMstar>("LazyPRMstar");
            table["spars"] = entry<og::SPARS>("SPARS");
            table["spars2"] = entry<og::SPARStwo>("SPARStwo");
            table["fmt"] = entry<og::FMT>("FMT");
            table["bfmt"] = entry<og::BFMT>("BFMT");
        }

        void addOptimizingPlanners(std::map<std::string, PlannerEntry> &table)
        {
            table["rrtstar"] = entry<og::RRTstar>("RRTstar");
            table["informedrrtstar"] = entry<og::InformedRRTstar>("InformedRRTstar");
            table["sorrtstar"] = entry<og::SORRTstar>("SORRTstar");
            table["rrtsharp"] = entry<og::RRTsharp>("RRTsharp");
            table["rrtxstatic"] = entry<og::RRTXstatic>("RRTXstatic");
            table["lbtrrt"] = entry<og::LBTRRT>("LBTRRT");
            table["lazylbtrrt"] = entry<og::LazyLBTRRT>("LazyLBTRRT");
            // OMPL gives these names to planners of the BIT* family that use k nearest neighbours, the default
            table["bitstar"] = entry<og::BITstar>("kBITstar");
            table["abitstar"] = entry<og::ABITstar>("kABITstar");
            table["aitstar"] = entry<og::AITstar>("AITstar");
            table["anytimepathshortening"] = entry<og::AnytimePathShortening>("AnytimePathShortening");
            table["aps"] = table["anytimepathshortening"];
            table["cforest"] = entry<og::CForest>("CForest");
        }

        void addNewerPlanners([[maybe_unused]] std::map<std::string, PlannerEntry> &table)
        {
#ifdef OMPL_MFA_HAS_EITSTAR
            table["eitstar"] = entry<og::EITstar>("EITstar");
#endif
#ifdef OMPL_MFA_HAS_EIRMSTAR
            table["eirmstar"] = entry<og::EIRMstar>("EIRMstar");
#endif
#ifdef OMPL_MFA_HAS_BLITSTAR
            table["blitstar"] = entry<og::BLITstar>("BLITstar");
#endif
#ifdef OMPL_MFA_HAS_AORRTC
            table["aorrtc"] = entry<ClearableAORRTC>("AORRTC");
#endif
#ifdef OMPL_MFA_HAS_AOXRRTCONNECT
            table["aoxrrtconnect"] = entry<og::AOXRRTConnect>("AOXRRTConnect");
#endif
#ifdef OMPL_MFA_HAS_ATRRT
            table["atrrt"] = entry<og::ATRRT>("ATRRT");
#endif
#ifdef OMPL_MFA_HAS_TRRTSTAR
            table["trrtstar"] = entry<og::TRRTstar>("TRRTstar");
#endif
#ifdef OMPL_MFA_HAS_QUOTIENT_SPACES
            table["qrrt"] = singleLevelEntry<og::QRRT>("QRRT");
#endif
#ifdef OMPL_MFA_HAS_MULTILEVEL
            table["qrrt"] = singleLevelEntry<ompl::multilevel::QRRT>("QRRT");
            table["qrrtstar"] = singleLevelEntry<ompl::multilevel::QRRTStar>("QRRTStar");
            table["qmp"] = singleLevelEntry<ompl::multilevel::QMP>("QMP");
            table["qmpstar"] = singleLevelEntry<ompl::multilevel::QMPStar>("QMPStar");
#endif
        }

        void markRequirements(std::map<std::string, PlannerEntry> &table)
        {
            for (const char *name : {"kpiece", "bkpiece", "lbkpiece", "projest", "sbl", "psbl", "pdst"})
            {
                table.at(name).needsProjection = true;
            }
            for (const char *name : {"biest", "birlrt", "bkpiece", "lbkpiece", "sbl", "psbl", "prm", "prmstar", "spars",
                                     "spars2", "rrtxstatic"})
            {
                table.at(name).needsSymmetry = true;
            }
            for (const char *name : {"lbtrrt", "lazylbtrrt"})
            {
                table.at(name).needsMetric = true;
            }
        }

        std::map<std::string, PlannerEntry> makeTable()
        {
            std::map<std::string, PlannerEntry> table;
            addOwnPlanners(table);
            addTreePlanners(table);
            addRoadmapPlanners(table);
            addOptimizingPlanners(table);
            addNewerPlanners(table);
            markRequirements(table);
            return table;
        }
    }  // namespace

    const std::map<std::string, PlannerEntry> &plannerTable()
    {
        static const std::map<std::string, PlannerEntry> TABLE = makeTable();
        return TABLE;
    }

    const std::map<std::string, std::string> &unavailablePlanners()
    {
        static const std::map<std::string, std::string> REASONS = {{"vfrrt", "it needs a vector field"},
                                                                   {"xxl", "it needs a decomposition of the space"},
                                                                   {"strrtstar", "it plans in space and time"},
                                                                   {"lightning", "it needs a database of experiences"},
                                                                   {"thunder", "it needs a database of experiences"},
                                                                   {"syclopest", "it plans with controls"},
                                                                   {"sycloprrt", "it plans with controls"}};
        return REASONS;
    }
}  // namespace ompl_mfa::benchmark
