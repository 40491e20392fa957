// SPDX-License-Identifier: GPL-3.0-or-later
// How many points keep a tolerance on machines of three kinds, and how far the tip really
// deviates.
//
//   five-axis-paths-linearisation OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "endmill/core/text.h"
#include "endmill/machine/tool_motion.h"
#include "endmill/post/machine_path.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// Rings of a ball over a dome; the tool leans towards its feed.
struct Dome {
    double radius;  // mm
    double lead;    // rad
    int rings;
    int points;  // of a ring

    ToolPath path(const Cutter& cutter) const
    {
        ToolPath made;
        for (int ring = 1; ring <= rings; ++ring)
            for (int k = 0; k <= points; ++k) {
                const double polar = std::numbers::pi / 3 * ring / rings;
                const double turn = 2 * std::numbers::pi * k / points;
                const Vec3 normal{std::sin(polar) * std::cos(turn),
                                  std::sin(polar) * std::sin(turn), std::cos(polar)};
                const Vec3 feed{-std::sin(turn), std::cos(turn), 0};
                const Vec3 axis =
                    (std::cos(lead) * normal + std::sin(lead) * feed).normalized();
                made.points.push_back(
                    {.pass = ring,
                     .point = k,
                     .move = Move::Cut,
                     .location = {control_point(cutter, {radius * normal, normal},
                                                ControlPoint::Tip, axis),
                                  axis}});
            }
        return made;
    }
};

// The largest distance in mm of a machine's tip from the straight line between the ends of a
// piece, at places inside it.
double sampled_error(const MachinePath& made)
{
    constexpr int places = 16;
    const MachineMotion& motion = made.path.machine.value();
    double most = 0;
    for (std::size_t k = 1; k < motion.positions.size(); ++k) {
        const ToolMotion piece{motion.setup, motion.interpolation,
                               motion.positions[k - 1], motion.positions[k]};
        const Vec3 from = piece.location(0).tip;
        const Vec3 way = piece.location(1).tip - from;
        for (int i = 1; i < places; ++i) {
            const double u = static_cast<double>(i) / places;
            most = std::max(most, (piece.location(u).tip - from - u * way).norm());
        }
    }
    return most;
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string name = "five-axis-paths/linearisation";
    return run_experiment(argc, argv, name, [](Experiment& run) {
        const Cutter ball = Cutter::ball(5);
        const Dome dome{run.number("dome_radius_mm"),
                        Angle::degrees(run.number("lead_deg")).radians(),
                        static_cast<int>(run.number("rings")),
                        static_cast<int>(run.number("points_a_ring"))};
        const ToolPath path = dome.path(ball);
        const auto moves = static_cast<double>(path.points.size() - 1);
        const std::vector<std::string> words = run.texts("machines");
        const std::vector<std::string> kinds = run.texts("kinds");
        const double pivot = run.number("pivot_mm");
        const double tool_length = run.number("tool_length_mm");
        CsvTable result{{"row", "kind", "frame", "tolerance_mm", "pieces",
                         "pieces_a_move", "bound_mm", "sampled_mm"}};
        const std::vector<double> tolerances = run.numbers("tolerances_mm");
        for (const std::string& frame : run.texts("frames"))
            for (std::size_t k = 0; k < words.size(); ++k)
                for (const double tolerance : tolerances) {
                    PartOnMachine setup;
                    setup.machine.configuration = configuration_from_word(words[k]);
                    setup.machine.rotary = widest_limits(setup.machine.configuration);
                    setup.machine.pivot = pivot;
                    setup.tool_length = tool_length;
                    const bool is_joint = frame == "joint";
                    const MachinePath made = machine_path(
                        path, setup,
                        {.frame = is_joint ? Interpolation::Joint : Interpolation::Tcp,
                         .tolerance = tolerance,
                         .cutter = ball});
                    const auto pieces = static_cast<double>(made.report.pieces);
                    result.add_row({kinds[k] + ", " + frame + ", " + to_text(tolerance),
                                    kinds[k], frame, tolerance,
                                    static_cast<std::int64_t>(made.report.pieces),
                                    pieces / moves, made.report.max_tip_error_mm,
                                    sampled_error(made)});
                }
        run.write_result(result);
    });
}
