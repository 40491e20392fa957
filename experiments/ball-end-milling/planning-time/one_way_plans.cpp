// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/planning-time/one_way_plans.h"

#include "endmill/planning/iso_parametric.h"
#include "endmill/planning/verified_plan.h"

namespace endmill {
namespace {

LinkOptions one_way(const OneWayRequest& request)
{
    return {.order = PassOrder::OneWay, .safe_height = request.return_z};
}

}  // namespace

ToolPath one_way_paper_path(const Surface& part, const OneWayRequest& request)
{
    return plan_iso_parametric(part, BallCutter{request.radius},
                               {.chord_tolerance = request.tolerance,
                                .scallop_height = request.scallop,
                                .link = one_way(request)})
        .path;
}

ToolPath one_way_verified_path(const Surface& part, const OneWayRequest& request)
{
    return plan_verified({&part, 1}, BallCutter{request.radius},
                         {.tolerances = {request.tolerance, request.tolerance},
                          .scallop_height = request.scallop,
                          .link = one_way(request)})
        .path;
}

}  // namespace endmill
