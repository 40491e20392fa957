// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/tool_rows.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

// A row of a table of LinuxCNC has words of a letter and a number, in any order, then a
// comment after a semicolon. T is the number of the tool and D its diameter. P is its
// pocket; X Y Z A B C U V W are offsets, I J and Q describe a lathe tool. The table knows
// no kind of cutter, so that a comment has to name it.
// LinuxCNC's user manual describes it under "Tool Table Format".

namespace endmill {
namespace {

constexpr std::string_view letters = "TPDXYZABCUVWIJQ";
constexpr int most_number = 99999;
constexpr std::size_t longest_line = std::size_t{1} << 20;
// mm, by which D may differ from the diameter of the comment: a table has few decimals.
constexpr double diameter_rounding = 0.01;

// The next word up to a blank, which is removed from `rest`; empty at the end.
std::string_view take_word(std::string_view& rest)
{
    constexpr std::string_view blanks = " \t\r";
    const std::size_t begin = std::min(rest.find_first_not_of(blanks), rest.size());
    const std::size_t end = std::min(rest.find_first_of(blanks, begin), rest.size());
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

// A line of the table, for messages.
class RowReader {
public:
    RowReader(const std::string& file, std::size_t line, std::string_view text)
        : file_{file},
          line_{line}
    {
        while (text.ends_with('\r'))
            text.remove_suffix(1);
        has_return_ = text.find('\r') != std::string_view::npos;
        const std::size_t end = std::min(text.find(';'), text.size());
        words_ = text.substr(0, end);
        comment_ = text.substr(std::min(end + 1, text.size()));
    }

    // A CR within the line is the end of a line for some programs.
    void refuse_lone_return() const
    {
        if (has_return_)
            throw complaint("a carriage return without a line feed",
                            "lines that end with LF or CRLF");
    }

    // The values of the words by their letters.
    std::map<char, double> words() const
    {
        std::map<char, double> values;
        std::string_view rest = words_;
        for (std::string_view word = take_word(rest); !word.empty();
             word = take_word(rest)) {
            const char letter = 'a' <= word.front() && word.front() <= 'z'
                                    ? static_cast<char>(word.front() - 'a' + 'A')
                                    : word.front();
            const auto value = number_from_text(word.substr(1));
            if (letters.find(letter) == std::string_view::npos || !value)
                throw complaint(quoted(word),
                                "words of a letter and a number, such as T1 P1 D6.0 Z0");
            if (!values.emplace(letter, *value).second)
                throw complaint(std::string{"two words "} + letter, "one of each");
        }
        return values;
    }

    // The cutter that the first word of the comment names; nothing if it names none.
    std::optional<Cutter> named_cutter(const std::optional<double>& diameter) const
    {
        std::string_view rest = comment_;
        const std::string_view word = take_word(rest);
        if (word == "ball" && diameter)
            return Cutter::ball(*diameter / 2);
        if (!word.starts_with("ball:") && !word.starts_with("flat:") &&
            !word.starts_with("bull:"))
            return std::nullopt;
        const auto cutter = cutter_from_word(word);
        if (!cutter)
            throw complaint(quoted(word), expected_cutter(word));
        return cutter;
    }

    std::string comment() const
    {
        constexpr std::size_t longest = 200;
        const std::size_t begin =
            std::min(comment_.find_first_not_of(" \t"), comment_.size());
        return printable(comment_.substr(begin), longest);
    }

    FormatError complaint(const std::string& found, const std::string& expected) const
    {
        return {"E_TOOLS", {file_, std::to_string(line_), found, expected}};
    }

private:
    static std::string quoted(std::string_view word)
    {
        constexpr std::size_t longest = 40;
        return '"' + printable(word, longest) + '"';
    }

    const std::string& file_;
    std::size_t line_;
    std::string_view words_;
    std::string_view comment_;
    bool has_return_ = false;
};

// The whole number after T.
int number_of(const RowReader& row, const std::map<char, double>& words)
{
    const auto found = words.find('T');
    if (found == words.end())
        throw row.complaint("a row without T", "the number of the tool, such as T1");
    const double number = found->second;
    if (!(number >= 0 && number <= most_number && number == std::floor(number)))
        throw row.complaint("T" + to_text(number),
                            "a whole number from 0 to " + std::to_string(most_number));
    return static_cast<int>(number);
}

// D in the unit of the table, if it is given and not 0.
std::optional<double> diameter_of(const RowReader& row,
                                  const std::map<char, double>& words)
{
    const auto found = words.find('D');
    if (found == words.end() || found->second == 0)
        return std::nullopt;
    if (found->second < 0)
        throw row.complaint("D" + to_text(found->second), "a diameter above 0");
    return found->second;
}

// The cutter of a row; nothing if the row states no diameter.
std::optional<Cutter> cutter_of(const RowReader& row, const std::optional<double>& given,
                                const std::string& file,
                                const std::optional<double>& unit_mm, double most_mm)
{
    std::optional<double> diameter;
    if (given && unit_mm)
        diameter = *given * *unit_mm;
    if (diameter && !(*diameter <= most_mm))
        throw row.complaint("a diameter of " + to_text(*diameter) + " mm",
                            "at most " + to_text(most_mm) + " mm");
    const std::optional<Cutter> named = row.named_cutter(diameter);
    if (named && diameter &&
        std::abs(2 * named->radius() - *diameter) > diameter_rounding)
        throw row.complaint("D is " + to_text(*diameter) + " mm and the comment names " +
                                cutter_word(*named),
                            "the same diameter");
    if (named || !given)
        return named;
    if (!diameter)
        throw DomainError{file +
                          ": a tool table of LinuxCNC does not state its unit; "
                          "expected --tools-units mm or inch"};
    return Cutter::flat(*diameter / 2);
}

}  // namespace

std::vector<ToolRow> tool_rows(std::string_view text, const std::string& file,
                               const std::optional<double>& unit_mm, double most_mm)
{
    std::vector<ToolRow> rows;
    for (std::size_t line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const RowReader row{file, line, text.substr(0, end)};
        if (end > longest_line)
            throw row.complaint("a line of more than 1 MiB", "a tool table");
        text.remove_prefix(std::min(end + 1, text.size()));
        row.refuse_lone_return();
        const std::map<char, double> words = row.words();
        if (words.empty())
            continue;
        const int number = number_of(row, words);
        if (const auto cutter =
                cutter_of(row, diameter_of(row, words), file, unit_mm, most_mm))
            rows.push_back({number, *cutter, line, row.comment()});
    }
    return rows;
}

}  // namespace endmill
