// SPDX-License-Identifier: GPL-3.0-or-later
// Speed and memory of material removal, with the bars.
//
//   benchmarks-simulation OUTPUT_FOLDER
//
// About 300 s; measures time, so nothing else should run. Columns: README.md beside this.

#include "benchmarks/height_parts.h"
#include "benchmarks/simulation/net_modes.h"
#include "endmill/verification/verification.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

double removed_volume(const ToolPath& path, const Cutter& cutter, double pitch)
{
    HeightStock stock = block_stock(LowSaddle::block(), pitch);
    return remove_along(stock, path, cutter).total;
}

double verified_volume(const ToolPath& path, const Cutter& cutter, double pitch)
{
    const Part part = std::vector<Surface>{low_saddle_surface()};
    VerificationTask task{.path = &path,
                          .cutter = cutter,
                          .judged = JudgedPart{&part},
                          .stock = LowSaddle::block()};
    task.resolution = pitch;
    return verify_path(task).removal.total;
}

double cells(double pitch)
{
    const StockGrid grid = grid_over(LowSaddle::block(), pitch);
    return static_cast<double>(grid.columns) * grid.rows;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/simulation", [](Experiment& run) {
        const int lines = static_cast<int>(run.number("lines"));
        const int steps = static_cast<int>(run.number("steps"));
        const double coarse = run.number("coarse_pitch_mm");
        const double fine = run.number("fine_pitch_mm");
        const Cutter ball = Cutter::ball(run.number("radius_mm"));
        const Cutter bull{run.number("radius_mm"), run.number("corner_radius_mm")};
        const ToolPath of_ball = saddle_path(ball, lines, steps);
        const ToolPath of_bull = saddle_path(bull, lines, steps);
        const double peak =
            peak_memory_bytes([&] { removed_volume(of_ball, ball, coarse); });
        const DefaultNet net{dataset_surface(run.text("net"))};
        const std::vector<NetMode> modes = net_modes(net, coarse);
        add_net_benchmarks(net, modes, coarse);
        add_benchmark("ball", [&] { return removed_volume(of_ball, ball, coarse); });
        add_benchmark("fine ball", [&] { return removed_volume(of_ball, ball, fine); });
        add_benchmark("bull", [&] { return removed_volume(of_bull, bull, coarse); });
        add_benchmark("fine bull", [&] { return removed_volume(of_bull, bull, fine); });
        add_benchmark("judged", [&] { return verified_volume(of_ball, ball, coarse); });
        add_benchmark("fine judged",
                      [&] { return verified_volume(of_ball, ball, fine); });
        add_benchmark("bull judged",
                      [&] { return verified_volume(of_bull, bull, coarse); });
        const ShortestTimes times = shortest_times();

        CsvTable result{{"row", "pitch_mm", "moves", "measured", "unit", "bar_at_most"}};
        const auto moves = static_cast<double>(of_ball.points.size());
        const auto add = [&](auto row, double pitch, double measured, auto unit,
                             const CsvCell& bar) {
            result.add_row({row, pitch, moves, measured, unit, bar});
        };
        add("ball, coarse", coarse, times.of("ball").wall_s, "s", {});
        add("ball, fine", fine, times.of("fine ball").wall_s, "s", {});
        add("bull-nose, coarse", coarse, times.of("bull").wall_s, "s", {});
        add("bull-nose, fine", fine, times.of("fine bull").wall_s, "s", {});
        add("ball, coarse, judged", coarse, times.of("judged").wall_s, "s", 2);
        add("ball, fine, judged", fine, times.of("fine judged").wall_s, "s", 5);
        add("bull-nose, coarse, judged", coarse, times.of("bull judged").wall_s, "s", 5);
        add_net_rows(result, modes, times, coarse);
        constexpr double bytes_per_result = 16;  // for each move
        const double bytes = peak - bytes_per_result * moves;
        add("stock and work", coarse, bytes / cells(coarse), "bytes a cell", 12);
        run.write_result(result);
    });
}
