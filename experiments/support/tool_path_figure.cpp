// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/tool_path_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/files/path_file.h"
#include "endmill/planning/path_error.h"
#include "support/printed_tables.h"

namespace endmill {
namespace {

// The run of the tables that a figure shows.
struct TableRun {
    Parameter direction;
    int tolerance;
    int diameter;
};

template <std::size_t Count>
int place_of(const std::array<double, Count>& values, double value)
{
    const auto found = std::ranges::find(values, value);
    require(found != values.end(), "the tables have no run with these parameters");
    return static_cast<int>(found - values.begin());
}

// Length of all links, on the assumption that it and the mean segment are the same for
// all three balls.
struct LinkEstimate {
    double segment_mm;
    double link_mm;
};

LinkEstimate link_estimate(const EconomyTables& tables, const TableRun& run)
{
    const auto cell = [&](TableQuantity quantity, int diameter) {
        return tables.cell(quantity, run.direction, run.tolerance, diameter);
    };
    const int one = run.diameter == 0 ? 1 : 0;
    const int other = run.diameter == 2 ? 1 : 2;
    const double points = cell(TableQuantity::Ncl, one) - cell(TableQuantity::Ncl, other);
    const double travel = cell(TableQuantity::Tcd, one) - cell(TableQuantity::Tcd, other);
    const double segment = travel / points;
    return {segment,
            cell(TableQuantity::Tcd, one) - segment * cell(TableQuantity::Ncl, one)};
}

double reduction_percent(double count, double other)
{
    return 100 * (std::max(count, other) - std::min(count, other)) /
           std::max(count, other);
}

// A straight step, and the place of the pass that is farthest from it.
struct Step {
    std::size_t end;  // index of its last point in the path
    double chord_mm;  // distance of the pass from the step
    SurfacePoint at;
};

std::vector<Step> measured_steps(const Surface& surface, const ToolPath& path,
                                 Parameter direction)
{
    std::vector<Step> steps;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        if (path.points[k].move != Move::Cut)
            continue;
        const ToolPath step{{path.points[k - 1], path.points[k]}};
        const ChordError error = chord_error(surface, step, direction);
        steps.push_back({k, error.greatest_mm, error.at});
    }
    return steps;
}

const Step& worst_of(const std::vector<Step>& steps)
{
    return *std::ranges::max_element(steps, {}, &Step::chord_mm);
}

// The path and what is marked on it.
struct MarkedPath {
    const Surface& surface;
    const ToolPath& path;
    std::vector<Step> steps;
    double far_mm;  // steps that leave the surface by more are marked
};

constexpr LineStyle cut_style{"#6f8fbf", 0.6, ""};
constexpr LineStyle link_style{"#009e73", 1.6, ""};
constexpr LineStyle far_style{"#d55e00", 2.4, ""};
constexpr LineStyle gap_style{"#000000", 1.4, "4 2"};

std::vector<Vec3> contacts_of(const ToolPath& path)
{
    std::vector<Vec3> contacts;
    for (const PathPoint& point : path.points)
        contacts.push_back(point.contact()->contact.point);
    return contacts;
}

Vec3 nearest_on_chord(const Vec3& from, const Vec3& to, const Vec3& point)
{
    const Vec3 chord = to - from;
    const double share = (point - from).dot(chord) / chord.squaredNorm();
    return from + std::clamp(share, 0.0, 1.0) * chord;
}

std::string rounded(double value)
{
    return to_text(std::round(10 * value) / 10);
}

// Draws the runs of consecutive points to which moves of one kind lead.
void add_runs(AxonometricFigure& figure, const MarkedPath& marked,
              std::span<const Vec3> contacts, Move move, const LineStyle& style)
{
    const std::vector<PathPoint>& points = marked.path.points;
    for (std::size_t begin = 1; begin < points.size();) {
        std::size_t end = begin;
        while (end < points.size() && points[end].move == move)
            ++end;
        figure.add_curve(contacts.subspan(begin - 1, end - begin + 1), style);
        begin = end + 1;
    }
}

// The contacts in cutting order, and above them the steps that leave the surface.
std::string marked_path_svg(const MarkedPath& marked, const FigureOptions& options)
{
    const std::vector<Vec3> contacts = contacts_of(marked.path);
    const std::span<const Vec3> all{contacts};
    AxonometricFigure figure{options, contacts};
    add_runs(figure, marked, contacts, Move::Cut, cut_style);
    add_runs(figure, marked, contacts, Move::Link, link_style);
    for (const Step& step : marked.steps)
        if (step.chord_mm > marked.far_mm)
            figure.add_curve(all.subspan(step.end - 1, 2), far_style);

    const Step& worst = worst_of(marked.steps);
    const Vec3 place = marked.surface.tangents(worst.at.u, worst.at.v).point;
    const Vec3 gap[] = {
        place, nearest_on_chord(contacts[worst.end - 1], contacts[worst.end], place)};
    figure.add_curve(gap, gap_style);
    figure.add_disc(place, 3, gap_style.colour);
    figure.add_label(place, {0.0, -14.0}, rounded(worst.chord_mm) + " mm",
                     gap_style.colour);

    figure.add_legend("step", cut_style);
    figure.add_legend("link between passes", link_style);
    figure.add_legend("step off by more than " + rounded(marked.far_mm) + " mm",
                      far_style);
    figure.add_legend("worst step: its distance", gap_style);
    return figure.text();
}

// The pass with the worst step in its own plane: the surface along the pass, and the contacts of its steps.
CsvTable worst_pass_table(const MarkedPath& marked, Parameter direction)
{
    constexpr int samples = 400;
    CsvTable table{{"line", "along_mm", "z_mm"}};
    const Step& worst = worst_of(marked.steps);
    const auto add = [&](const char* line, const Vec3& point) {
        table.add_row(
            {line, direction == Parameter::U ? point.x() : point.y(), point.z()});
    };
    const Interval range = marked.surface.range(direction);
    for (int k = 0; k <= samples; ++k) {
        const double along = std::lerp(range.low, range.high, k / double(samples));
        add("surface", direction == Parameter::U
                           ? marked.surface.tangents(along, worst.at.v).point
                           : marked.surface.tangents(worst.at.u, along).point);
    }
    for (const PathPoint& point : marked.path.points)
        if (point.pass == marked.path.points[worst.end].pass)
            add("steps", point.contact()->contact.point);
    return table;
}

// Title and captions: what is drawn, the mode and its objective, the pose, and the result.
FigureOptions figure_options(const MarkedPath& marked, const TableRun& run,
                             const std::string& surface, const DirectionCost& cost)
{
    const std::string letter = run.direction == Parameter::U ? "u" : "v";
    const auto far = std::ranges::count_if(
        marked.steps, [&](const Step& step) { return step.chord_mm > marked.far_mm; });
    FigureOptions figure;
    figure.title = "Passes along " + letter + " on " + surface + ", a fit to the tables";
    figure.captions = {
        "mode paper; objective: longest steps within the chord tolerance, widest "
        "intervals within "
        "the scallop height",
        "pose: part as in its file, tool axis +z; ball of diameter " +
            to_text(table_diameters_mm[run.diameter]) +
            " mm, chord tolerance = scallop height = " +
            to_text(table_tolerances_mm[run.tolerance]) + " mm",
        std::to_string(cost.ncl) + " CL points, travel " +
            std::to_string(std::lround(cost.tcd_mm)) + " mm; " + std::to_string(far) +
            " steps leave the surface by more than " + rounded(marked.far_mm) +
            " mm, the worst by " + rounded(worst_of(marked.steps).chord_mm) + " mm"};
    return figure;
}

CsvTable caption_table(const TableRun& run, const std::string& surface,
                       const MarkedPath& marked, double caption_ncl)
{
    const EconomyTables printed = printed_tables();
    const auto cell = [&](TableQuantity quantity, Parameter direction) {
        return printed.cell(quantity, direction, run.tolerance, run.diameter);
    };
    const double printed_ncl = cell(TableQuantity::Ncl, run.direction);
    const double printed_tcd = cell(TableQuantity::Tcd, run.direction);
    const double other_ncl = cell(
        TableQuantity::Ncl, run.direction == Parameter::U ? Parameter::V : Parameter::U);
    const LinkEstimate others = link_estimate(printed, run);
    const PathEconomy economy = path_economy(marked.path);

    CsvTable table{{"row", "passes", "ncl", "tcd_mm", "link_mm", "reduction_percent",
                    "worst_step_mm"}};
    table.add_row({surface,
                   static_cast<std::int64_t>(economy.passes),
                   static_cast<std::int64_t>(economy.ncl),
                   economy.cut.contact_mm + economy.link.contact_mm,
                   economy.link.contact_mm,
                   {},
                   worst_of(marked.steps).chord_mm});
    const auto add_print = [&](const char* row, double ncl) {
        table.add_row({row,
                       {},
                       ncl,
                       printed_tcd,
                       printed_tcd - others.segment_mm * ncl,
                       reduction_percent(ncl, other_ncl),
                       {}});
    };
    add_print("tables", printed_ncl);
    add_print("caption", caption_ncl);
    table.add_row({"other balls", {}, {}, {}, others.link_mm, {}, {}});
    return table;
}

}  // namespace

void draw_tool_path(Experiment& experiment, Parameter direction)
{
    const std::string name = experiment.text("surface");
    const double tolerance = experiment.number("chord_tolerance_mm");
    const double diameter = experiment.number("cutter_diameter_mm");
    const TableRun run{direction, place_of(table_tolerances_mm, tolerance),
                       place_of(table_diameters_mm, diameter)};

    TablePolicies policies;
    policies.scallop_per_tolerance = experiment.number("scallop_height_mm") / tolerance;
    const Surface surface = dataset_surface(name);
    const ToolPath path =
        table_plan(surface, policies, direction, tolerance, diameter).path;
    const MarkedPath marked{surface, path, measured_steps(surface, path, direction),
                            2 * tolerance};
    const FigureOptions figure =
        figure_options(marked, run, name, path_cost(path, policies));
    experiment.write("toolpath.svg", marked_path_svg(marked, figure));
    experiment.write("toolpath.csv", tool_path_csv(path));
    experiment.write("worst-pass.csv", worst_pass_table(marked, direction).text());
    const double caption_ncl = published_number(experiment.name(), "tables", "ncl");
    experiment.write_result(caption_table(run, name, marked, caption_ncl));
}

}  // namespace endmill
