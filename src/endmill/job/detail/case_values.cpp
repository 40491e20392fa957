// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/case_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "endmill/core/text.h"
#include "endmill/files/detail/csv_lines.h"
#include "endmill/job/detail/drawn_fraction.h"

namespace endmill {
namespace {

// Calls `check`. Its DomainError becomes an error at this place of the plan.
template <class Check>
void at_place(const JsonValue& place, const Check& check)
{
    try {
        check();
    } catch (const DomainError& error) {
        throw place.complaint(error.what(), "");
    }
}

void add_key(std::vector<std::string>& keys, const std::string& key,
             const CaseCommand& command)
{
    if (std::ranges::find(keys, key) != keys.end())
        throw DomainError{"key \"" + printable(key, 60) +
                          "\" occurs twice; expected each key once"};
    command.require_key(key);
    keys.push_back(key);
}

// The texts of an array of values, each of which was checked.
std::vector<std::string> checked_texts(const JsonValue& values, const std::string& key,
                                       const CaseCommand& command)
{
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const JsonValue item = values.item(i);
        texts.push_back(checked_argument(item));
        at_place(item, [&] {
            if (command.checks_values(key))
                command.require_value({key, texts.back()});
        });
    }
    if (texts.empty())
        throw values.complaint("an empty array", "at least one value");
    return texts;
}

}  // namespace

namespace {

// A whole number with all its digits, as far as a double has them.
std::string whole_text(double number)
{
    constexpr double most = 1e15;
    return number < most ? std::to_string(static_cast<std::uint64_t>(number))
                         : to_text(number);
}

}  // namespace

bool has_control_characters(const std::string& text)
{
    return printable(text) != text;
}

std::string checked_argument(const JsonValue& value)
{
    std::string text = value.argument();
    if (text.empty())
        throw value.complaint("an empty text", "a value");
    if (has_control_characters(text))
        throw value.complaint(value.shown(), "a text without control characters");
    return text;
}

CaseGrid::CaseGrid(const JsonValue& axes, const CaseCommand& command)
{
    double product = 1;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const JsonValue axis = axes.item(i);
        add_axis(axis, command);
        product *= static_cast<double>(axes_.back().steps);
    }
    if (axes_.empty())
        throw axes.complaint("an empty array", "at least one object with keys");
    if (product > static_cast<double>(most_cases))
        throw axes.complaint("a grid of " + whole_text(product) + " cases",
                             "at most " + std::to_string(most_cases));
    count_ = static_cast<std::uint64_t>(product);
}

void CaseGrid::add_axis(const JsonValue& keys, const CaseCommand& command)
{
    Axis axis;
    for (const std::string_view name : keys.keys()) {
        const std::string key{name};
        const JsonValue values = keys.member(name);
        at_place(values, [&] { add_key(keys_, key, command); });
        axis.values.push_back(checked_texts(values, key, command));
        axis.steps = axis.values.front().size();
        if (values.size() != axis.steps)
            throw values.complaint(
                counted(values.size(), "value"),
                std::to_string(axis.steps) + " as for the other keys of this axis");
    }
    if (axis.values.empty())
        throw keys.complaint("an object without keys", "at least one key");
    axes_.push_back(std::move(axis));
}

std::vector<std::string> CaseGrid::values(std::uint64_t number) const
{
    std::vector<std::size_t> steps(axes_.size());
    for (std::size_t i = axes_.size(); i-- > 0;) {
        steps[i] = number % axes_[i].steps;
        number /= axes_[i].steps;
    }
    std::vector<std::string> all;
    for (std::size_t i = 0; i < axes_.size(); ++i)
        for (const auto& of_key : axes_[i].values)
            all.push_back(of_key[steps[i]]);
    return all;
}

namespace {

// Checks the rows of a list. A value that was checked in its column is not checked again.
class RowCheck {
public:
    RowCheck(const std::vector<std::string>& keys, const CaseCommand& command)
        : keys_{keys},
          command_{command},
          checked_(keys.size())
    {
    }

    void operator()(const CsvLines& lines)
    {
        const auto& cells = lines.cells();
        if (cells.size() != keys_.size())
            throw lines.complaint("E_CSV", counted(cells.size(), "cell"),
                                  std::to_string(keys_.size()) + " as in the header");
        if (cells.size() == 1 && cells.front().empty())
            throw lines.complaint("E_CSV", "an empty line", "a value");
        try {
            for (std::size_t i = 0; i < cells.size(); ++i)
                check(i, cells[i]);
        } catch (const DomainError& error) {
            throw lines.complaint("E_CSV", error.what(), "");
        }
    }

private:
    void check(std::size_t column, std::string_view cell)
    {
        if (has_control_characters(std::string{cell}))
            throw DomainError{"found a control character; expected a text without"};
        if (cell.empty() && keys_[column] == "input")
            throw DomainError{"found an empty cell under input; expected a file"};
        if (cell.empty() || !command_.checks_values(keys_[column]) ||
            checked_[column].contains(cell))
            return;
        command_.require_value({keys_[column], std::string{cell}});
        checked_[column].emplace(cell);
    }

    const std::vector<std::string>& keys_;
    const CaseCommand& command_;
    std::vector<std::set<std::string, std::less<>>> checked_;
};

}  // namespace

CaseList::CaseList(std::string content, const std::filesystem::path& file,
                   const CaseCommand& command)
    : content_{std::move(content)}
{
    CsvLines lines{content_, printable(file.string())};
    lines.next();
    try {
        for (const std::string_view cell : lines.cells())
            add_key(keys_, std::string{cell}, command);
    } catch (const DomainError& error) {
        throw lines.complaint("E_CSV", error.what(), "");
    }
    const auto here = [&] { return content_.size() - lines.rest().size(); };
    RowCheck check{keys_, command};
    for (std::size_t begin = here(); lines.next(); begin = here()) {
        check(lines);
        rows_.push_back(begin);
    }
    if (rows_.empty())
        throw lines.complaint("E_CSV", "no row after the header", "at least one case");
    if (rows_.size() > most_cases)
        throw lines.complaint("E_CSV",
                              "a list of " + std::to_string(rows_.size()) + " cases",
                              "at most " + std::to_string(most_cases));
}

std::vector<std::string> CaseList::values(std::uint64_t number) const
{
    CsvLines lines{std::string_view{content_}.substr(rows_[number]), "", 1};
    lines.next();
    return {lines.cells().begin(), lines.cells().end()};
}

CaseSamples::CaseSamples(const JsonValue& random, const CaseCommand& command)
{
    constexpr std::int64_t largest_seed = std::int64_t{1} << 53;
    random.allow_only(std::array<std::string_view, 3>{"count", "seed", "parameters"});
    const JsonValue count = random.member("count");
    count_ = static_cast<std::uint64_t>(
        count.whole_number(1, static_cast<std::int64_t>(most_cases)));
    const JsonValue seed = random.member("seed");
    seed_ = static_cast<std::uint64_t>(seed.whole_number(0, largest_seed));
    const JsonValue parameters = random.member("parameters");
    for (const std::string_view name : parameters.keys()) {
        const std::string key{name};
        const JsonValue parameter = parameters.member(name);
        at_place(parameter, [&] { add_key(keys_, key, command); });
        if (const auto one_of = parameter.find_member("one_of")) {
            parameter.allow_only(std::array<std::string_view, 1>{"one_of"});
            parameters_.emplace_back(checked_texts(*one_of, key, command));
            continue;
        }
        if (command.checks_values(key))
            throw parameter.complaint("a range of numbers",
                                      "one_of with the values of this key");
        parameters_.emplace_back(range_of(parameter));
    }
    if (keys_.empty())
        throw parameters.complaint("an object without keys", "at least one key");
}

CaseSamples::Range CaseSamples::range_of(const JsonValue& parameter)
{
    constexpr double largest_whole = 1e15;
    constexpr std::array<std::string_view, 2> scales{"linear", "log"};
    parameter.allow_only(
        std::array<std::string_view, 5>{"from", "to", "scale", "whole", "one_of"});
    const JsonValue from = parameter.member("from");
    const JsonValue to = parameter.member("to");
    const auto scale = parameter.find_member("scale");
    const auto whole = parameter.find_member("whole");
    const Range range{from.number(), to.number(),
                      scale && scale->word(scales) == scales[1], whole && whole->truth()};
    if (!(range.low <= range.high) || !std::isfinite(range.high - range.low))
        throw to.complaint(to.shown(), "a number from " + from.shown() + " on");
    if (range.is_geometric &&
        !(range.low > 0 && std::isfinite((range.high + 1) / range.low)))
        throw from.complaint(from.shown(), "a number above 0 for a logarithmic scale");
    if (!range.is_whole)
        return range;
    for (const JsonValue& end : {from, to})
        if (std::trunc(end.number()) != end.number() ||
            std::abs(end.number()) > largest_whole)
            throw end.complaint(end.shown(), "a whole number");
    return range;
}

std::vector<std::string> CaseSamples::values(std::uint64_t number) const
{
    std::vector<std::string> all;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const double share = drawn_fraction(seed_, keys_[i], number);
        if (const auto* const choices = std::get_if<Choices>(&parameters_[i])) {
            const auto count = static_cast<double>(choices->size());
            all.push_back((*choices)[static_cast<std::size_t>(share * count)]);
            continue;
        }
        const Range& range = std::get<Range>(parameters_[i]);
        const double end = range.is_whole ? range.high + 1 : range.high;
        const double value = range.is_geometric ? geometric_between(range.low, end, share)
                                                : range.low + (end - range.low) * share;
        all.push_back(range.is_whole ? std::to_string(static_cast<std::int64_t>(
                                           std::min(std::floor(value), range.high)))
                                     : to_text(value));
    }
    return all;
}

}  // namespace endmill
