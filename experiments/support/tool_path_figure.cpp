// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/tool_path_figure.h"

#include <algorithm>
#include <cstdint>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/figures/tool_path_svg.h"
#include "endmill/files/path_file.h"
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

CsvTable caption_table(const TableRun& run, const std::string& surface,
                       const ToolPath& path, double caption_ncl)
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
    const PathEconomy economy = path_economy(path);

    CsvTable table{{"row", "passes", "ncl", "tcd_mm", "link_mm", "reduction_percent"}};
    table.add_row({surface,
                   static_cast<std::int64_t>(economy.passes),
                   static_cast<std::int64_t>(economy.ncl),
                   economy.cut.contact_mm + economy.link.contact_mm,
                   economy.link.contact_mm,
                   {}});
    const auto add_print = [&](const char* row, double ncl) {
        table.add_row({row,
                       {},
                       ncl,
                       printed_tcd,
                       printed_tcd - others.segment_mm * ncl,
                       reduction_percent(ncl, other_ncl)});
    };
    add_print("tables", printed_ncl);
    add_print("caption", caption_ncl);
    table.add_row({"other balls", {}, {}, {}, others.link_mm, {}});
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
    const ToolPath path =
        table_plan(dataset_surface(name), policies, direction, tolerance, diameter).path;
    const DirectionCost cost = path_cost(path, policies);

    FigureOptions figure;
    const std::string letter = direction == Parameter::U ? "u" : "v";
    figure.title = "Passes along " + letter + " on " + name;
    figure.captions = {"ball of diameter " + to_text(diameter) + " mm, chord tolerance " +
                           to_text(tolerance) + " mm",
                       std::to_string(cost.ncl) + " CL points, travel " +
                           std::to_string(std::lround(cost.tcd_mm)) + " mm"};
    experiment.write("toolpath.svg", tool_path_svg(path, figure));
    experiment.write("toolpath.csv", tool_path_csv(path));
    const double caption_ncl = published_number(experiment.name(), "tables", "ncl");
    experiment.write_result(caption_table(run, name, path, caption_ncl));
}

}  // namespace endmill
