// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of five-axis planning, removal, posting and reading, with the bars.
//
//   benchmarks-five-axis OUTPUT_FOLDER
//
// About a minute; measures time, so nothing else should run. Columns: README.md beside
// this.

#include <chrono>
#include <string>

#include "benchmarks/five-axis/leaning_path.h"
#include "benchmarks/height_parts.h"
#include "endmill/core/parallel.h"
#include "endmill/orientation/oriented_path.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/machine_gcode.h"
#include "endmill/post/machine_path.h"
#include "endmill/surface/nurbs.h"
#include "endmill/verification/verification.h"
#include "support/experiment.h"
#include "support/peak_memory.h"

using namespace endmill;

namespace {

// Wall time in s. The works last for seconds, so that one run is enough.
template <typename Work>
double seconds_of(const Work& work)
{
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
        .count();
}

// A plane that lies where the balls are deepest.
Part floor_part(double depth)
{
    return std::vector<Surface>{nurbs_surface(
        {{1, {0, 0, 1, 1}},
         {1, {0, 0, 1, 1}},
         {{10, 10, -depth}, {90, 10, -depth}, {10, 90, -depth}, {90, 90, -depth}},
         {}})};
}

// The same task by either engine.
double judged_saddle(const ToolPath& path, const Cutter& cutter, double pitch,
                     RemovalEngine engine)
{
    const Part part = std::vector<Surface>{low_saddle_surface()};
    VerificationTask task{.path = &path,
                          .cutter = cutter,
                          .judged = JudgedPart{&part},
                          .stock = LowSaddle::block()};
    task.resolution = pitch;
    task.engine = engine;
    return seconds_of([&] { verify_path(task); });
}

// Planning on the low saddle with an axis chosen at each contact, for 20 000 contacts.
double field_of_axes(const Cutter& cutter, double scallop_height)
{
    const std::vector<Surface> saddle{low_saddle_surface()};
    OrientedOptions options;
    options.mode = AxisMode::Field;
    options.scallop_height = scallop_height;
    options.safe_height = LowSaddle::block().high.z() + 1;
    std::size_t contacts = 0;
    const double time = seconds_of(
        [&] { contacts = plan_oriented(saddle, cutter, options).path.points.size(); });
    return time / static_cast<double>(contacts) * 20'000;
}

PartOnMachine table_table()
{
    PartOnMachine setup;
    setup.machine.configuration = configuration_from_word("W/caxyBz/T");
    setup.machine.rotary = widest_limits(setup.machine.configuration);
    setup.clamp = {-50, -50, 0};
    return setup;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/five-axis", [](Experiment& run) {
        const LeaningPath leaning{static_cast<int>(run.number("moves")),
                                  run.number("step_mm"), run.number("radius_mm"),
                                  run.number("depth_mm")};
        const double pitch = run.number("pitch_mm");
        const Cutter ball = Cutter::ball(leaning.radius);
        const ToolPath path = leaning.path();
        CsvTable result{{"row", "measured", "unit", "bar_at_most"}};

        VerificationTask removal{.path = &path, .cutter = ball, .stock = full_block()};
        removal.resolution = pitch;
        removal.engine = RemovalEngine::FiveAxis;
        const double peak = peak_memory_bytes([&] { verify_path(removal); });
        set_thread_count(1);
        const double by_one = seconds_of([&] { verify_path(removal); });
        set_thread_count(2);
        const double by_two = seconds_of([&] { verify_path(removal); });
        result.add_row({"removal in order, three fields", by_two, "s", 12});
        result.add_row({"the same by one thread", by_one, "s", {}});
        result.add_row({"memory of removal", peak / 1e6, "MB", 400});
        const Part part = floor_part(leaning.depth);
        VerificationTask judged = removal;
        judged.judged = JudgedPart{&part, {0.01, 0.5}};
        result.add_row(
            {"removal and verdict", seconds_of([&] { verify_path(judged); }), "s", {}});

        const ToolPath upright =
            saddle_path(ball, static_cast<int>(run.number("upright_lines")),
                        static_cast<int>(run.number("upright_steps")));
        result.add_row({"constant axis, five-axis engine by three-axis engine",
                        judged_saddle(upright, ball, pitch, RemovalEngine::FiveAxis) /
                            judged_saddle(upright, ball, pitch, RemovalEngine::ThreeAxis),
                        "times", 4});

        result.add_row({"planning with a field of axes, for 20 000 contacts",
                        field_of_axes(ball, run.number("field_scallop_height_mm")), "s",
                        8});

        const PartOnMachine setup = table_table();
        MachinePath made;
        WrittenMachineProgram program;
        result.add_row({"posting for a table-table machine", seconds_of([&] {
                            made = machine_path(path, setup, {.cutter = ball});
                            program = machine_gcode(
                                made, {.name = "leaning", .feed_mm_per_min = 1000});
                        }),
                        "s", 1.5});
        GcodeReadOptions reading;
        reading.rotary = RotaryReading{.setup = setup, .frame = Interpolation::Joint};
        const double blocks = static_cast<double>(program.program.lines);
        result.add_row({"reading it back, for 100 000 blocks",
                        seconds_of([&] {
                            parse_gcode(program.program.text, "leaning.ngc", reading);
                        }) / blocks *
                            1e5,
                        "s", 0.3});
        run.write_result(result);
    });
}
