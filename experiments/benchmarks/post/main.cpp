// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of writing a path for a machine and of reading it back, with the bars.
//
//   benchmarks-post OUTPUT_FOLDER
//
// About 20 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <cmath>

#include "endmill/files/detail/tool_path_reader.h"
#include "endmill/files/path_file.h"
#include "endmill/post/apt.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/gcode_writer.h"
#include "support/experiment.h"
#include "support/shortest_times.h"

using namespace endmill;

namespace {

// A zigzag of a ball of radius 5 over a wavy plate. All three axes move in nearly every
// line, and every number has all its digits.
ToolPath wavy_zigzag(int points)
{
    constexpr int points_per_pass = 500;
    ToolPath path;
    for (int k = 0; k < points; ++k) {
        const int pass = k / points_per_pass;
        const double along = (k % points_per_pass) / (points_per_pass - 1.0);
        const double u = pass % 2 == 0 ? along : 1 - along;
        const double v = pass / 200.0;
        const Vec3 contact{120 * u, 80 * v, 10 * std::sin(7 * u) * std::cos(4 * v)};
        const Vec3 normal = Vec3{-0.6 * std::cos(7 * u), 0.3 * v, 1}.normalized();
        const Vec3 tip = contact + 5 * (normal - Vec3::UnitZ());
        path.points.push_back({pass,
                               k % points_per_pass,
                               k == 0 ? Move::Plunge : Move::Cut,
                               0,
                               {tip, Vec3::UnitZ()},
                               SurfaceContact{u, v, {contact, normal}}});
    }
    return path;
}

std::size_t points_of(const Program& program)
{
    return program.path.points.size();
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/post", [](Experiment& run) {
        const ToolPath path = wavy_zigzag(static_cast<int>(run.number("points")));
        const GcodeOptions options{.name = "zigzag", .feed_mm_per_min = 1000};
        const AptOptions apt_options{.name = "zigzag", .feed_mm_per_min = 1000};
        const std::string program = gcode(path, options).text;
        const std::string cl_data = apt(path, apt_options).text;
        const std::string table = tool_path_csv(path);
        add_benchmark("writing", [&] { return gcode(path, options).lines; });
        add_benchmark("reading", [&] { return points_of(parse_gcode(program, "f")); });
        add_benchmark("apt", [&] { return apt(path, apt_options).lines; });
        add_benchmark("apt_reading", [&] { return points_of(parse_apt(cl_data, "f")); });
        add_benchmark("csv_reading",
                      [&] { return points_of(parse_tool_path(table, "f")); });
        const ShortestTimes times = shortest_times();

        CsvTable result{{"row", "lines", "measured", "unit", "bar", "bar_is"}};
        const auto add = [&](const char* row, double seconds, double bar) {
            result.add_row(
                {row, std::int64_t(path.points.size()), seconds, "s", bar, "at most"});
        };
        add("posting G-code and reading it back",
            times.of("writing").cpu_s + times.of("reading").cpu_s, 0.5);
        add("posting APT and reading it back",
            times.of("apt").cpu_s + times.of("apt_reading").cpu_s, 0.5);
        add("reading a tool path (CSV)", times.of("csv_reading").cpu_s, 0.15);
        run.write_result(result);
    });
}
