// SPDX-License-Identifier: GPL-3.0-or-later
// Does the setup with the smaller rotary ranges make the shorter program? Kang & Suh minimise
// the ranges; here the same path over the teapot is posted for many setups.
//
//   five-axis-paths-setups OUTPUT_FOLDER
//
// Deterministic, about a minute. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "endmill/post/machine_path.h"
#include "endmill/setup/detail/sampled_poses.h"
#include "endmill/setup/setup_travel.h"
#include "support/dataset_mesh.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/setup_cells.h"
#include "support/studied_part.h"

using namespace endmill;

namespace {

Vec3 centroid(const TriangleMesh& mesh, std::size_t facet)
{
    const auto [a, b, c] = mesh.corners(facet);
    return (a + b + c) / 3;
}

// The facets in the order of a short way: each time the nearest one that is left, and of
// equally near ones the first.
std::vector<std::size_t> visiting_order(const TriangleMesh& mesh,
                                        const std::vector<std::size_t>& dropped)
{
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        if (!std::ranges::binary_search(dropped, k))
            left.push_back(k);
    std::vector<std::size_t> order{left.front()};
    left.erase(left.begin());
    order.reserve(left.size() + 1);
    while (!left.empty()) {
        const Vec3 here = centroid(mesh, order.back());
        const auto nearest = std::ranges::min_element(left, {}, [&](std::size_t k) {
            return (centroid(mesh, k) - here).squaredNorm();
        });
        order.push_back(*nearest);
        left.erase(nearest);
    }
    return order;
}

// What a machine of a family needs for the path in one setup.
struct Program {
    double area_deg2;  // floored area of the setup
    PoseRanges ranges;
    MachinePathReport report;
};

class Study {
public:
    Study(const StudiedPart& part, RotaryFamily family, double feed, double rate_deg)
        : part_{part},
          family_{family},
          feed_{feed},
          configuration_{configuration_of_family(family)},
          order_{visiting_order(part.mesh, part.visibility.dropped)}
    {
        machine_.configuration = configuration_;
        machine_.rotary = widest_limits(configuration_);
        const double rate = Angle::degrees(rate_deg).radians();
        machine_.rates.rotary_rad_per_min = {rate, rate};
    }

    // The program for the facets in their order, each from the direction within the setup's
    // ranges that needs the least rotation.
    Program program(const FittedPose& fit) const
    {
        const std::vector<std::optional<FacetReach>> reach =
            facet_reach(part_.visibility.map, part_.grid.centres,
                        pose_frame(configuration_, fit.pose), {fit.phi, fit.theta});
        ToolPath path;
        const auto add = [&](const Vec3& tip, const Vec3& axis) {
            PathPoint point{.pass = 0,
                            .point = static_cast<int>(path.points.size()),
                            .move = Move::Cut,
                            .location = {tip, axis}};
            point.conditions.feed_mm_per_min = feed_;
            path.points.push_back(point);
        };
        for (const std::size_t facet : order_) {
            const Vec3 tip = centroid(part_.mesh, facet);
            const Vec3& axis = part_.grid.centres[reach[facet].value().cell];
            if (!path.points.empty()) {
                // Far turns lead over the side of the tool axis at zero.
                const auto [last, before] = path.points.back().location;
                if (before.dot(axis) < 0)
                    add((last + tip) / 2,
                        (before + axis + fit.pose.tool_axis / 2).normalized());
            }
            add(tip, axis);
        }
        PartOnMachine setup;
        setup.machine = machine_;
        setup.part_to_machine = part_to_machine(fit.pose, configuration_);
        const PoseRanges ranges = pose_ranges(family_, fit);
        const PoseMeasure measure{.family = family_};
        return {square_degrees(measure(ranges)), ranges,
                machine_path(path, setup, {.tolerance = 0.01}).report};
    }

    // Poses over the whole range of areas, the least first.
    std::vector<FittedPose> poses(int count) const
    {
        const std::vector<FittedPose> all = sampled_poses(
            part_.grid, part_.visibility,
            {.reach = {.configuration = configuration_, .limits = machine_.rotary},
             .mode = SetupMode::Corrected,
             .measure = PoseMeasure{.family = family_}});
        std::vector<FittedPose> some;
        some.reserve(static_cast<std::size_t>(count));
        for (int k = 0; k < count; ++k)
            some.push_back(all[(all.size() - 1) * static_cast<std::size_t>(k) /
                               static_cast<std::size_t>(count - 1)]);
        return some;
    }

private:
    const StudiedPart& part_;
    RotaryFamily family_;
    double feed_;
    MachineConfiguration configuration_;
    Machine machine_;
    std::vector<std::size_t> order_;
};

// The numbers from 1 up in the order of the values.
std::vector<double> ranks(const std::vector<double>& values)
{
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return values[k]; });
    std::vector<double> rank(values.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        rank[order[k]] = static_cast<double>(k + 1);
    return rank;
}

// Spearman's rank correlation.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b)
{
    const std::vector<double> first = ranks(a);
    const std::vector<double> second = ranks(b);
    double sum = 0;
    for (std::size_t k = 0; k < first.size(); ++k)
        sum += (first[k] - second[k]) * (first[k] - second[k]);
    const auto n = static_cast<double>(first.size());
    return 1 - 6 * sum / (n * (n * n - 1));
}

NamedCells cells_of(const std::string& family, const Program& program)
{
    const auto degrees = [](double angle) { return Angle::radians(angle).degrees(); };
    return {{"family", family},
            {"area_deg2", program.area_deg2},
            {"width_deg", degrees(program.ranges.width)},
            {"height_deg", degrees(program.ranges.height())},
            {"rotary_travel_deg", degrees(program.report.rotary_travel)},
            {"time_min", program.report.time_min},
            {"branch_changes", static_cast<std::int64_t>(program.report.branch_changes)}};
}

// Adds a program to the result, and to the table that the figure shows.
void add_program(std::array<CsvTable*, 2> tables, const std::string& row,
                 const NamedCells& cells)
{
    for (CsvTable* table : tables)
        add_named(*table, row, cells);
}

void add_family(CsvTable& result, CsvTable& shown, const StudiedPart& part,
                const std::string& family, Experiment& run)
{
    const RotaryFamily kind = family_of_word(family);
    const Study study{part, kind, run.number("feed_mm_per_min"),
                      run.number("rotary_rate_deg_per_min")};
    std::vector<double> all_times;
    double of_least_area = 0;
    for (const std::string& mode : run.texts("modes")) {
        const PartSetup setup = unlimited_setup(part, kind, mode);
        const Program program = study.program(setup.shown().value());
        all_times.push_back(program.report.time_min);
        if (mode == "set")  // the least area over whole cones
            of_least_area = program.report.time_min;
        add_program({&result, &shown}, std::string{family}.append(", ").append(mode),
                    cells_of(family, program));
    }
    std::vector<double> areas;
    std::vector<double> travels;
    std::vector<double> times;
    const auto count = static_cast<int>(run.number("other_poses"));
    for (const FittedPose& pose : study.poses(count)) {
        const Program program = study.program(pose);
        areas.push_back(program.area_deg2);
        travels.push_back(program.report.rotary_travel);
        times.push_back(program.report.time_min);
        add_program({&result, &shown}, family + ", pose " + std::to_string(areas.size()),
                    cells_of(family, program));
    }
    add_named(result, family + ", rank correlation with the area",
              {{"rotary_travel_deg", rank_correlation(areas, travels)},
               {"time_min", rank_correlation(areas, times)}});
    all_times.insert(all_times.end(), times.begin(), times.end());
    const auto [shortest, longest] = std::ranges::minmax(all_times);
    add_named(result, family + ", least area",
              {{"time_over_shortest", of_least_area / shortest}});
    add_named(result, family + ", longest", {{"time_over_shortest", longest / shortest}});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "five-axis-paths/setups", [](Experiment& run) {
        const StudiedPart part =
            studied_part(moved(dataset_mesh(run.text("mesh")),
                               run.number("mm_per_unit") * Eigen::Matrix3d::Identity()),
                         run.text("grid"), Angle::degrees(run.number("incidence_deg")));
        CsvTable result{{"row", "family", "area_deg2", "width_deg", "height_deg",
                         "rotary_travel_deg", "time_min", "branch_changes",
                         "time_over_shortest"}};
        CsvTable shown = result;
        for (const std::string& family : run.texts("families"))
            add_family(result, shown, part, family, run);
        run.write_result(result);
        run.write("setups.csv", shown.text());
    });
}
