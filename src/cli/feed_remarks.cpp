// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/feed_remarks.h"

#include "endmill/core/text.h"

namespace endmill {
namespace {

std::string helix_remark(std::size_t moves, std::size_t of, double helix_deg)
{
    return std::string{"milled "} + (helix_deg > 0 ? "down" : "up") + " on " +
           std::to_string(moves) + " of " + counted(of, "segment") +
           ": the model takes --helix-deg " + to_text(helix_deg) +
           " there as a left-hand cutter under M03; a right-hand cutter needs "
           "--helix-deg " +
           to_text(-helix_deg);
}

}  // namespace

std::vector<std::string> feed_remarks(const FeedInput& input, const FedCuts& cuts)
{
    std::vector<std::string> remarks;
    if (cuts.zero_length > 0)
        remarks.push_back(counted(cuts.zero_length, "cutting move") +
                          (cuts.zero_length == 1 ? " has" : " have") +
                          " zero length and no planned feed");
    if (cuts.between > 0)
        remarks.push_back(counted(cuts.between, "segment") +
                          (cuts.between == 1 ? " has" : " have") +
                          " earlier passes on both sides; the plan uses the nearer pass");
    const bool is_turning = input.plan.peak != PeakRule::Constant;
    const double helix = input.job.tool.helix;
    // The moves on which a right-hand cutter has the opposite helix in the model. Slots do
    // not count: both helices have the same peaks there.
    const std::size_t moves = helix > 0 ? cuts.down : cuts.up;
    if (is_turning && helix != 0 && moves > 0)
        remarks.push_back(
            helix_remark(moves, cuts.points.size(), input.tool.helix->written_degrees()));
    return remarks;
}

}  // namespace endmill
