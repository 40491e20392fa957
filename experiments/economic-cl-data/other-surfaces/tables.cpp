// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/other-surfaces/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "support/named_cells.h"
#include "support/printed_tables.h"

namespace endmill {
namespace {

constexpr int middle = 1;  // of the three balls and of the three tolerances

// About the least that the printed tables allow; see docs/methods/economic-cl-data.md, section 13.2.
constexpr double least_scallop_per_tolerance = 0.5;

double percent(double share)
{
    return 100 * share;
}

double cell(const SurfaceStudy& study, TableQuantity quantity, Parameter direction)
{
    return study.tables.cell(quantity, direction, middle, middle);
}

std::string better_by(const SurfaceStudy& study, TableQuantity quantity)
{
    return smaller(cell(study, quantity, Parameter::U),
                   cell(study, quantity, Parameter::V));
}

std::string better_by_tips(const SurfaceStudy& study)
{
    return smaller(study.tips_mm[0], study.tips_mm[1]);
}

// Whether no cell rises with the diameter of the ball. Equal counts do not contradict the paper.
bool never_rises(const EconomyTables& tables)
{
    for (const TableQuantity quantity : table_quantities)
        for (const Parameter direction : table_directions)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 2; ++j)
                    if (tables.cell(quantity, direction, i, j + 1) >
                        tables.cell(quantity, direction, i, j))
                        return false;
    return true;
}

// Shares of the travel in percent, u and v.
double saved_against_uniform(const SurfaceStudy& study, int along)
{
    return percent(1 - study.travel[along].planned / study.travel[along].uniform);
}

double still_needless(const SurfaceStudy& study, int along)
{
    return percent(1 - study.local_mm[along] / study.iso_mm[along]);
}

double saved_by_planes(const SurfaceStudy& study)
{
    return percent(1 - study.planes_mm / std::min(study.iso_mm[0], study.iso_mm[1]));
}

double reduction(const SurfaceStudy& study, TableQuantity quantity)
{
    return percent(study.tables.reduction_between_directions(quantity, middle, middle));
}

// Of two choices, "either" agrees with both.
bool agree(const std::string& one, const std::string& other)
{
    return one == other || one == "either" || other == "either";
}

// A property that surfaces have or not; bounds are in percent.
struct Property {
    const char* row;
    std::function<bool(const SurfaceStudy&)> holds;
};

const Property properties[] = {
    {"surfaces", [](const SurfaceStudy&) { return true; }},
    {"NCL differs by 22 % or more between u and v",
     [](const SurfaceStudy& s) { return reduction(s, TableQuantity::Ncl) >= 22; }},
    {"TCD differs by 4 % or more between u and v",
     [](const SurfaceStudy& s) { return reduction(s, TableQuantity::Tcd) >= 4; }},
    {"twice the ball saves 25 to 35 % in all rows",
     [](const SurfaceStudy& s) {
         const ValueRange saved = reductions_by_diameter(s.tables);
         return percent(saved.least) >= 25 && percent(saved.greatest) <= 35;
     }},
    {"twice the ball saves 25 to 35 % in a row",
     [](const SurfaceStudy& s) {
         for (const TableQuantity quantity : table_quantities)
             for (const Parameter direction : table_directions)
                 for (int i = 0; i < 3; ++i) {
                     const double saved =
                         percent(s.tables.reduction_by_diameter(quantity, direction, i));
                     if (saved >= 25 && saved <= 35)
                         return true;
                 }
         return false;
     }},
    {"a larger ball raises NCL or TCD",
     [](const SurfaceStudy& s) { return !never_rises(s.tables); }},
    {"twice the ball raises NCL or TCD",
     [](const SurfaceStudy& s) { return reductions_by_diameter(s.tables).least < 0; }},
    {"NCL and TCD choose different directions",
     [](const SurfaceStudy& s) {
         return !agree(better_by(s, TableQuantity::Ncl),
                       better_by(s, TableQuantity::Tcd));
     }},
    {"contacts and tips choose different directions",
     [](const SurfaceStudy& s) {
         return !agree(better_by(s, TableQuantity::Tcd), better_by_tips(s));
     }},
    {"eq. (4) saves 10 % or more against equal intervals",
     [](const SurfaceStudy& s) {
         return saved_against_uniform(s, 0) >= 10 || saved_against_uniform(s, 1) >= 10;
     }},
    {"more than 10 % of the travel is still needless",
     [](const SurfaceStudy& s) {
         return std::min(still_needless(s, 0), still_needless(s, 1)) > 10;
     }},
    {"parallel planes save more than 1 %",
     [](const SurfaceStudy& s) { return saved_by_planes(s) > 1; }},
};

}  // namespace

CsvTable study_table()
{
    return CsvTable{{"row",
                     "ball_mm",
                     "ncl_u",
                     "ncl_v",
                     "tcd_u_mm",
                     "tcd_v_mm",
                     "tips_u_mm",
                     "tips_v_mm",
                     "ncl_reduction_percent",
                     "tcd_reduction_percent",
                     "better_by_ncl",
                     "better_by_tcd",
                     "better_by_tips",
                     "larger_is_better",
                     "twice_the_ball_least_percent",
                     "twice_the_ball_greatest_percent",
                     "saved_against_equal_u_percent",
                     "saved_against_equal_v_percent",
                     "needless_u_percent",
                     "needless_v_percent",
                     "planes_save_percent",
                     "tape_m",
                     "count",
                     "ratio"}};
}

void add_study(CsvTable& table, const NamedStudy& named)
{
    const SurfaceStudy& study = named.study;
    const ValueRange by_ball = reductions_by_diameter(study.tables);
    const auto points = [&study](Parameter direction) {
        return static_cast<std::int64_t>(cell(study, TableQuantity::Ncl, direction));
    };
    add_named(table, named.name,
              {{"ball_mm", named.ball_mm},
               {"ncl_u", points(Parameter::U)},
               {"ncl_v", points(Parameter::V)},
               {"tcd_u_mm", cell(study, TableQuantity::Tcd, Parameter::U)},
               {"tcd_v_mm", cell(study, TableQuantity::Tcd, Parameter::V)},
               {"tips_u_mm", study.tips_mm[0]},
               {"tips_v_mm", study.tips_mm[1]},
               {"ncl_reduction_percent", reduction(study, TableQuantity::Ncl)},
               {"tcd_reduction_percent", reduction(study, TableQuantity::Tcd)},
               {"better_by_ncl", better_by(study, TableQuantity::Ncl)},
               {"better_by_tcd", better_by(study, TableQuantity::Tcd)},
               {"better_by_tips", better_by_tips(study)},
               {"larger_is_better", word(never_rises(study.tables))},
               {"twice_the_ball_least_percent", percent(by_ball.least)},
               {"twice_the_ball_greatest_percent", percent(by_ball.greatest)},
               {"saved_against_equal_u_percent", saved_against_uniform(study, 0)},
               {"saved_against_equal_v_percent", saved_against_uniform(study, 1)},
               {"needless_u_percent", still_needless(study, 0)},
               {"needless_v_percent", still_needless(study, 1)},
               {"planes_save_percent", saved_by_planes(study)},
               {"tape_m", study.tape_m}});
}

void add_counts(CsvTable& table, const std::vector<NamedStudy>& studies)
{
    for (const Property& property : properties) {
        const auto count = std::ranges::count_if(studies, [&](const NamedStudy& named) {
            return property.holds(named.study);
        });
        add_named(table, std::string{"not fitted: "} + property.row,
                  {{"count", static_cast<std::int64_t>(count)}});
    }
}

void add_travel_against_plane(CsvTable& table, const Surface& plane)
{
    const EconomyTables printed = printed_tables();
    TablePolicies policies;
    policies.scallop_per_tolerance = least_scallop_per_tolerance;
    for (const Parameter direction : table_directions) {
        const ToolPath path =
            table_plan(plane, policies, direction, table_tolerances_mm[middle],
                       table_diameters_mm[middle])
                .path;
        add_named(table,
                  std::string{"printed TCD / that of the plane, "} +
                      (direction == Parameter::U ? "u" : "v"),
                  {{"ratio", printed.cell(TableQuantity::Tcd, direction, middle, middle) /
                                 path_cost(path, policies).tcd_mm}});
    }
}

}  // namespace endmill
