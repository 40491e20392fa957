// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/setup_file.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/strict_json.h"

namespace endmill {
namespace {

// An axis of a summary is made unit; one that is off by more is refused.
constexpr double most_off_unit = 1e-3;
// Largest number of facets that a summary may state.
constexpr std::int64_t most_facets = 2'147'483'647;
// Characters of a word that a message shows.
constexpr std::size_t most_shown = 40;

// The text without white space at both ends.
std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blank = " \t\r";
    const std::size_t from = text.find_first_not_of(blank);
    if (from == std::string_view::npos)
        return {};
    return text.substr(from, text.find_last_not_of(blank) - from + 1);
}

std::optional<std::size_t> facet_number(std::string_view word)
{
    std::size_t number = 0;
    const auto [end, error] =
        std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return number;
}

// Collects the numbers of a list.
class FacetList {
public:
    FacetList(std::string file, std::size_t facets)
        : file_{std::move(file)},
          line_of_(facets, 0)
    {
    }

    // Adds a word of a line, numbered from 1.
    void add(std::string_view word, std::size_t line)
    {
        const std::size_t facets = line_of_.size();
        const std::optional<std::size_t> facet = facet_number(word);
        const std::string shown = '"' + printable(word, most_shown) + '"';
        if (!facet)
            throw complaint(line, shown, "one facet number from 0 on a line");
        if (*facet >= facets)
            throw complaint(
                line, shown,
                facets == 0 ? "no facet: the mesh has none"
                            : "a facet number from 0 to " + std::to_string(facets - 1));
        if (line_of_[*facet] > 0)
            throw complaint(
                line,
                shown + ", which line " + std::to_string(line_of_[*facet]) + " has too",
                "every facet once");
        line_of_[*facet] = line;
    }

    std::vector<std::size_t> facets() const
    {
        std::vector<std::size_t> facets;
        for (std::size_t facet = 0; facet < line_of_.size(); ++facet)
            if (line_of_[facet] > 0)
                facets.push_back(facet);
        return facets;
    }

private:
    FormatError complaint(std::size_t line, const std::string& found,
                          const std::string& expected) const
    {
        return {"E_FACET", {file_, std::to_string(line), found, expected}};
    }

    std::string file_;
    std::vector<std::size_t> line_of_;  // on which a facet stands, from 1; 0: on none
};

Vec3 axis_of(const JsonValue& value)
{
    if (value.size() != 3)
        throw value.complaint(value.shown(), "[x, y, z]");
    Vec3 axis;
    for (std::size_t k = 0; k < 3; ++k)
        axis[static_cast<Eigen::Index>(k)] = value.item(k).number();
    if (!(std::abs(axis.norm() - 1) <= most_off_unit))
        throw value.complaint("the length " + to_text(axis.norm()), "a unit vector");
    return axis.normalized();
}

std::optional<JsonValue> present(const JsonValue& object, std::string_view key)
{
    std::optional<JsonValue> value = object.find_member(key);
    return value && value->shown() != "null" ? value : std::nullopt;
}

}  // namespace

std::vector<std::size_t> read_facet_list(const std::filesystem::path& path,
                                         std::size_t facets, const ReadLimits& limits)
{
    const std::string text = read_file(path, limits);
    require_memory(shown_path(path), 8.0 * static_cast<double>(facets), limits);
    FacetList list{shown_path(path), facets};
    std::string_view rest = text;
    for (std::size_t line = 1; !rest.empty(); ++line) {
        const std::size_t end = rest.find('\n');
        const std::string_view whole = rest.substr(0, end);
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
        const std::string_view word = trimmed(whole.substr(0, whole.find('#')));
        if (!word.empty())
            list.add(word, line);
    }
    std::vector<std::size_t> found = list.facets();
    if (found.empty())
        throw FormatError{"E_EMPTY",
                          {shown_path(path), "", "no facet number", "one on a line"}};
    return found;
}

SetupDirections read_setup_directions(const std::filesystem::path& path,
                                      const ReadLimits& limits)
{
    const JsonDocument document{read_file(path, limits), shown_path(path), limits};
    const JsonValue root = document.root();
    SetupDirections found;
    if (const auto word = present(root, "configuration"))
        found.machine = word->text();
    if (const auto setups = present(root, "setups")) {
        for (std::size_t k = 0; k < setups->size(); ++k) {
            const JsonValue setup = setups->item(k);
            found.axes.push_back(axis_of(setup.member("tool_axis")));
        }
    } else if (const auto axis = present(root, "tool_axis")) {
        found.axes.push_back(axis_of(*axis));
    }
    if (found.axes.empty())
        throw root.complaint("no setup (setups or tool_axis)",
                             "the summary.json of endmill setup, which found a setup");
    return found;
}

SetupSubject read_setup_subject(const std::filesystem::path& path,
                                const ReadLimits& limits)
{
    const JsonDocument document{read_file(path, limits), shown_path(path), limits};
    const JsonValue root = document.root();
    SetupSubject found;
    if (const auto name = present(root, "name"))
        found.name = name->text();
    if (const auto facets = present(root, "facets"))
        found.facets = static_cast<std::size_t>(facets->whole_number(0, most_facets));
    return found;
}

}  // namespace endmill
