// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/grid_word.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double most_cells = 1e7;

[[noreturn]] void refuse(std::string_view name)
{
    throw DomainError{
        "sphere grid \"" + std::string{name} +
        "\": need hex:F, cube:F, latlong:NxM (N >= 3, M >= 2) or ico:L with "
        "at most 10000000 cells"};
}

// Parses a decimal integer of at least `least`.
std::optional<int> whole_number(std::string_view text, int least)
{
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || value < least)
        return {};
    return value;
}

std::optional<GridKind> grid_kind(std::string_view word)
{
    constexpr std::array<std::string_view, 4> kinds{"hex", "cube", "latlong", "ico"};
    const auto found = std::ranges::find(kinds, word);
    if (found == kinds.end())
        return {};
    return static_cast<GridKind>(found - kinds.begin());
}

}  // namespace

GridWord grid_word(std::string_view name)
{
    const std::size_t colon = std::min(name.find(':'), name.size());
    const std::string_view rest = name.substr(std::min(colon + 1, name.size()));
    const std::optional<GridKind> kind = grid_kind(name.substr(0, colon));
    if (!kind)
        refuse(name);
    GridWord word{*kind, 0};
    std::optional<int> first;
    if (*kind == GridKind::LatLong) {
        const std::size_t cross = std::min(rest.find('x'), rest.size());
        first = whole_number(rest.substr(0, cross), 3);
        word.bands =
            whole_number(rest.substr(std::min(cross + 1, rest.size())), 2).value_or(0);
    } else {
        first = whole_number(rest, *kind == GridKind::Ico ? 0 : 1);
    }
    word.fineness = first.value_or(0);
    word.cells = *kind == GridKind::LatLong ? 2.0 * word.fineness * (word.bands - 1.0)
                 : *kind == GridKind::Ico   ? 20 * std::pow(4.0, word.fineness)
                                            : 12.0 * word.fineness * word.fineness;
    if (!first || !(word.cells > 0 && word.cells <= most_cells))
        refuse(name);
    return word;
}

}  // namespace endmill
