// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/milling_jobs.h"

#include "endmill/files/machining_data.h"

namespace endmill {

MillingJob reference_job(const std::string& material)
{
    return {read_material("datasets/materials/" + material + ".json"),
            milling_tool(read_tool("datasets/tools/ball-10-steel-and-aluminium.json")),
            read_machine("datasets/machines/milling-machine-steel.json").limits};
}

MillingJob right_hand_job(const MillingJob& job)
{
    MillingJob turned = job;
    turned.tool.helix = -job.tool.helix;
    return turned;
}

OneWayPasses reference_passes()
{
    return {.surface = ball_end_test_surface, .extent = {{-60, 60}, {-40, 40}}};
}

std::vector<SegmentCut> reference_cuts()
{
    constexpr double printed_length_mm = 5385.6;
    return stretched(milled_path(reference_passes()).cuts, printed_length_mm);
}

double limit_share(const FeedPlanTotals& totals, FeedLimit limit)
{
    return totals.limit_shares[static_cast<std::size_t>(limit)];
}

double limit_share(const FeedPlanTotals& totals, SpeedLimit limit)
{
    return totals.speed_limit_shares[static_cast<std::size_t>(limit)];
}

}  // namespace endmill
