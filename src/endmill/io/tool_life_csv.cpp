// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/tool_life_csv.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "endmill/core/numbers.h"
#include "endmill/io/csv_lines.h"
#include "endmill/io/printable.h"
#include "endmill/io/read_file.h"
#include "endmill/io/suggestion.h"

namespace endmill {
namespace {

constexpr std::array<std::string_view, 2> names{"phi_over_pi", "v_m_per_min"};
constexpr std::size_t longest_echo = 40;
constexpr double most_speed = 1e6;  // m/min: beyond any, and its powers are finite

class CuttingSpeedReader {
public:
    CuttingSpeedReader(std::string_view text, const std::string& file)
        : lines_{text, file}
    {
    }

    std::vector<CuttingSpeedDatum> read_all(const std::string& file,
                                            const ReadLimits& limits)
    {
        lines_.next();  // an empty text has no columns
        read_header();
        require_memory(
            file,
            static_cast<double>(line_count(lines_.rest())) * sizeof(CuttingSpeedDatum),
            limits);
        std::vector<CuttingSpeedDatum> data;
        while (lines_.next())
            data.push_back(datum());
        const auto is_other = [&](const CuttingSpeedDatum& other) {
            return other.phi_over_pi != data.front().phi_over_pi;
        };
        if (!std::ranges::any_of(data, is_other))
            throw lines_.complaint("E_CSV",
                                   data.empty() ? "no row after the header"
                                   : data.size() == 1
                                       ? "one row after the header"
                                       : "phi_over_pi is the same in all rows",
                                   "two rows with different phi_over_pi, at least");
        return data;
    }

private:
    void read_header()
    {
        for (std::size_t place = 0; place < lines_.cells().size(); ++place) {
            const std::string_view word = lines_.cells()[place];
            const auto known = std::ranges::find(names, word);
            if (known == names.end())
                throw lines_.complaint(
                    "E_CSV", "unknown column \"" + printable(word, longest_echo) + '"',
                    one_of(names, word));
            auto& column = columns_[static_cast<std::size_t>(known - names.begin())];
            if (column)
                throw lines_.complaint("E_CSV", "column " + std::string{word} + " twice",
                                       "each once");
            column = place;
        }
        for (std::size_t k = 0; k < names.size(); ++k)
            if (!columns_[k])
                throw lines_.complaint("E_CSV", "no column " + std::string{names[k]},
                                       "phi_over_pi and v_m_per_min");
    }

    CuttingSpeedDatum datum() const
    {
        if (lines_.cells().size() != names.size())
            throw lines_.complaint("E_CSV",
                                   "row has " + counted(lines_.cells().size(), "cell"),
                                   std::to_string(names.size()));
        return {number(0, 1), number(1, most_speed)};
    }

    double number(std::size_t column, double most) const
    {
        const std::string_view text = lines_.cells()[*columns_[column]];
        const auto number = number_from_text(text);
        if (number && *number > 0 && *number <= most)
            return *number;
        const std::string found =
            text.empty() ? "empty" : '"' + printable(text, longest_echo) + '"';
        throw lines_.complaint("E_CSV", std::string{names[column]} + " is " + found,
                               "a number above 0, at most " + to_text(most));
    }

    CsvLines lines_;
    std::array<std::optional<std::size_t>, 2> columns_{};  // as `names`
};

}  // namespace

std::vector<CuttingSpeedDatum> parse_cutting_speeds(std::string_view text,
                                                    const std::string& file,
                                                    const ReadLimits& limits)
{
    return CuttingSpeedReader{text, file}.read_all(file, limits);
}

std::vector<CuttingSpeedDatum> read_cutting_speeds(const std::filesystem::path& path,
                                                   const ReadLimits& limits)
{
    return parse_cutting_speeds(read_file(path, limits), shown_path(path), limits);
}

}  // namespace endmill
