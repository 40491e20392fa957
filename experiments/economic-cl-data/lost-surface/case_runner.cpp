// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/lost-surface/case_runner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "economic-cl-data/lost-surface/searched_tables.h"

namespace endmill {
namespace {

// The numbers N to M of a text that ends with N..M, and the text before; none otherwise.
struct NumberRange {
    std::string before;
    int first;
    int last;
};

std::optional<NumberRange> range_at_end(const std::string& text)
{
    const auto dots = text.find("..");
    if (dots == std::string::npos)
        return std::nullopt;
    const auto start = text.rfind('-', dots) + 1;
    return NumberRange{text.substr(0, start), std::stoi(text.substr(start, dots - start)),
                       std::stoi(text.substr(dots + 2))};
}

// How far the values of a fit are from those of the planted surface: the largest difference in mm, and that of
// h / delta in percent. Empty for other tables.
std::array<CsvCell, 2> truth_errors(const SearchCase& search, const std::string& values)
{
    if (search.method != "stages" || search.table.rfind("planted-", 0) != 0)
        return {};
    const std::vector<double> truth = planted_surface(search).values;
    const std::vector<double> found = values_of(values);
    if (found.size() != truth.size())
        return {};
    double most = 0;
    for (std::size_t i = 0; i + 1 < truth.size(); ++i)
        most = std::max(most, std::abs(found[i] - truth[i]));
    return {most, 100 * std::abs(found.back() / truth.back() - 1)};
}

std::string file_of(const SearchCase& search)
{
    return search.name + ".csv";
}

}  // namespace

std::vector<SearchCase> read_cases(const std::filesystem::path& file)
{
    const CsvTable table = read_csv(file);
    std::vector<SearchCase> cases;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const auto number = [&](const char* column) {
            return table.number(i, column).value_or(0);
        };
        const SearchCase search{table.cell(i, "case"),
                                table.cell(i, "method"),
                                table.cell(i, "table"),
                                table.cell(i, "family"),
                                table.cell(i, "policies"),
                                static_cast<std::uint32_t>(number("seed")),
                                static_cast<int>(number("evaluations")),
                                static_cast<int>(number("curves")),
                                number("most_height_mm")};
        const auto range = range_at_end(search.table);
        if (!range) {
            cases.push_back(search);
            continue;
        }
        for (int k = range->first; k <= range->last; ++k) {
            SearchCase one = search;
            one.table = range->before + std::to_string(k);
            one.name += "-" + std::to_string(k);
            cases.push_back(one);
        }
    }
    return cases;
}

int run_missing_cases(const std::vector<SearchCase>& cases, const CaseShard& shard,
                      const std::filesystem::path& folder)
{
    std::vector<std::string> files;
    files.reserve(cases.size());
    for (const SearchCase& search : cases)
        files.push_back(file_of(search));
    return write_missing_results(
        files, shard, folder, [&](std::size_t i) { return run_case(cases[i]).text(); });
}

CsvTable collected_results(const std::vector<SearchCase>& cases,
                           const std::filesystem::path& folder)
{
    const CsvTable own = search_table();
    std::vector<std::string> columns{own.columns().begin(), own.columns().end()};
    columns.insert(columns.end(), {"value_error_mm", "ratio_error_percent"});
    CsvTable all{columns};
    for (const SearchCase& search : cases) {
        const CsvTable one = read_csv(folder / file_of(search));
        std::vector<CsvCell> row;
        for (const std::string& column : own.columns())
            row.emplace_back(one.cell(0, column));
        for (const CsvCell& error : truth_errors(search, one.cell(0, "values")))
            row.push_back(error);
        all.add_row(row);
    }
    return all;
}

}  // namespace endmill
