// SPDX-License-Identifier: GPL-3.0-or-later
#include "interference/correctness/family_table.h"

#include <cstdint>

namespace endmill {
namespace {

CsvCell count_cell(std::size_t count)
{
    return static_cast<std::int64_t>(count);
}

std::vector<std::string> columns()
{
    std::vector<std::string> names{"row", "curves", "self-crossing"};
    for (const TriedMethod& method : tried_methods())
        names.push_back(method.label);
    return names;
}

std::vector<CsvCell> first_cells(const std::string& name,
                                 std::span<const TrimmingTrial> trials)
{
    return {name, count_cell(trials.size()), count_cell(crossing_curves(trials))};
}

}  // namespace

FamilyTable::FamilyTable(Experiment& run) : run_{run}, table_{columns()} {}

void FamilyTable::add(const std::string& name, std::span<const TrimmingTrial> trials,
                      const std::string& stated)
{
    std::vector<CsvCell> found = first_cells(name, trials);
    for (const TriedMethod& method : tried_methods())
        found.push_back(count_cell(wrong_curves(trials, method)));
    table_.add_row(found);
    add_stated(name, stated);
}

void FamilyTable::add_without_three_runs(const std::string& name,
                                         std::span<const TrimmingTrial> trials,
                                         const std::string& stated)
{
    std::vector<CsvCell> found = first_cells(name, trials);
    for (TriedMethod method : tried_methods()) {
        method.patterns = FoldPatterns::P4;
        found.push_back(method.detection == FoldDetection::Literal
                            ? count_cell(wrong_curves(trials, method))
                            : CsvCell{});
    }
    table_.add_row(found);
    add_stated(name, stated);
}

void FamilyTable::add_stated(const std::string& name, const std::string& stated)
{
    std::vector<CsvCell> counts{name + ", stated"};
    for (const double count : run_.numbers(stated))
        counts.emplace_back(count);
    counts.resize(table_.columns().size());
    table_.add_row(counts);
}

}  // namespace endmill
