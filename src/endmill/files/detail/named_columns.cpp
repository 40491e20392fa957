// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/named_columns.h"

#include <algorithm>

#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr std::size_t longest_echo = 40;

// "a, b and c", for messages.
std::string needed_words(std::span<const std::string_view> needed)
{
    std::string words;
    for (std::size_t k = 0; k < needed.size(); ++k) {
        words += k == 0 ? "" : k + 1 == needed.size() ? " and " : ", ";
        words += needed[k];
    }
    return words;
}

// What is expected in place of an unknown column. If every column is needed, they are
// listed with "and".
std::string expected_column(std::span<const std::string_view> names, std::size_t needed,
                            std::string_view word)
{
    if (needed < names.size())
        return one_of(names, word);
    const auto closest = closest_word(word, names);
    return needed_words(names) +
           (closest ? "; did you mean \"" + std::string{*closest} + "\"?" : "");
}

}  // namespace

// Finds the position of each known column. Unknown columns are refused instead of
// ignored: they are usually misspelt.
NamedColumns::NamedColumns(const CsvLines& lines, std::span<const std::string_view> names,
                           std::size_t needed)
    : names_{names},
      places_(names.size()),
      count_{lines.cells().size()}
{
    for (std::size_t place = 0; place < count_; ++place) {
        const std::string_view word = lines.cells()[place];
        const auto known = std::ranges::find(names, word);
        if (known == names.end())
            throw lines.complaint(
                "E_CSV", "unknown column \"" + printable(word, longest_echo) + '"',
                expected_column(names, needed, word));
        auto& column = places_[static_cast<std::size_t>(known - names.begin())];
        if (column)
            throw lines.complaint("E_CSV", "column " + std::string{word} + " twice",
                                  "each once");
        column = place;
    }
    for (std::size_t k = 0; k < needed; ++k)
        if (!places_[k])
            throw lines.complaint("E_CSV", "no column " + std::string{names[k]},
                                  needed_words(names.first(needed)));
}

void NamedColumns::check_row(const CsvLines& lines) const
{
    if (lines.cells().size() != count_)
        throw lines.complaint("E_CSV", "row has " + counted(lines.cells().size(), "cell"),
                              std::to_string(count_));
}

FormatError NamedColumns::complaint(const CsvLines& lines, std::size_t column,
                                    const std::string& expected) const
{
    const std::string_view text = cell(lines, column);
    const std::string found =
        text.empty() ? "empty" : '"' + printable(text, longest_echo) + '"';
    return lines.complaint("E_CSV", std::string{names_[column]} + " is " + found,
                           expected);
}

}  // namespace endmill
