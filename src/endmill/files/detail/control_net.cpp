// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/control_net.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "endmill/core/text.h"

// Arrays are read row by row. The expected numbers of rows and columns come from other
// keys of the file, so an error states both numbers and the keys that they follow from.

namespace endmill {
namespace {

// The length in `value` in mm. The limit applies after the conversion; the message states
// the number in the file and, if it was converted, the length in mm.
double read_length(const JsonValue& value, const LengthRule& rule)
{
    const double length = rule.mm_per_unit * value.number();
    const double most = rule.max_extent_mm;
    if (!(std::abs(length) <= most))
        throw value.complaint(
            "coordinate " + value.shown() +
                (rule.mm_per_unit == 1 ? "" : " (" + to_text(length) + " mm)"),
            "at most " + to_text(most) + " mm (--max-extent)", "E_RANGE");
    return length;
}

// The point in `value`, an array of three lengths.
Vec3 read_point(const JsonValue& value, const LengthRule& rule)
{
    if (value.size() != 3)
        throw value.complaint("a point of " + std::to_string(value.size()) + " numbers",
                              "3: x, y, z");
    Vec3 point;
    for (int c = 0; c < 3; ++c)
        point[c] = read_length(value.item(c), rule);
    return point;
}

// Checks the length of a row. `thing` names the items in the message.
void require_columns(const JsonValue& row, const ExpectedCount& columns,
                     const char* thing)
{
    if (row.size() != columns.count)
        throw row.complaint("row has " + counted(row.size(), thing),
                            std::to_string(columns.count) + " (" + columns.reason + ")",
                            "E_SURFACE");
}

// Checks the number of rows. `thing` names the array in the message.
void require_rows(const JsonValue& value, const ExpectedCount& rows, const char* thing)
{
    if (value.size() != rows.count)
        throw value.complaint(std::string{thing} + " has " + counted(value.size(), "row"),
                              std::to_string(rows.count) + " (" + rows.reason + ")",
                              "E_SURFACE");
}

// The values `read(item)` of the items of all rows, row by row.
template <class Read>
std::vector<double> read_rows(const JsonValue& value, const ExpectedCount& columns,
                              const ExpectedCount& rows, const Read& read)
{
    require_rows(value, rows, "array");
    std::vector<double> numbers;
    for (std::size_t j = 0; j < rows.count; ++j) {
        const JsonValue row = value.item(j);
        require_columns(row, columns, "number");
        for (std::size_t i = 0; i < columns.count; ++i)
            numbers.push_back(read(row.item(i)));
    }
    return numbers;
}

}  // namespace

ControlNet read_net(const JsonValue& value, const LengthRule& rule,
                    const std::optional<ExpectedCount>& columns,
                    const std::optional<ExpectedCount>& rows)
{
    if (rows)
        require_rows(value, *rows, "net");
    // Memory grows as points are read; nothing is reserved for the counts that a file
    // claims.
    ControlNet net{0, value.size(), {}};
    for (std::size_t j = 0; j < net.rows; ++j) {
        const JsonValue row = value.item(j);
        if (j == 0)
            net.columns = columns ? columns->count : row.size();
        require_columns(row, columns.value_or(ExpectedCount{net.columns, "as in row 0"}),
                        "point");
        for (std::size_t i = 0; i < net.columns; ++i)
            net.points.push_back(read_point(row.item(i), rule));
    }
    if (net.points.size() > 1 && std::ranges::all_of(net.points, [&](const Vec3& p) {
            return p == net.points.front();
        }))
        throw value.complaint("all control points are equal", "a surface", "E_SURFACE");
    return net;
}

std::vector<double> read_lengths(const JsonValue& value, const LengthRule& rule)
{
    std::vector<double> lengths;
    for (std::size_t k = 0; k < value.size(); ++k)
        lengths.push_back(read_length(value.item(k), rule));
    return lengths;
}

std::vector<double> read_length_rows(const JsonValue& value, const LengthRule& rule,
                                     const ExpectedCount& columns,
                                     const ExpectedCount& rows)
{
    return read_rows(value, columns, rows,
                     [&](const JsonValue& item) { return read_length(item, rule); });
}

std::vector<double> read_weights(const JsonValue& value, const ExpectedCount& columns,
                                 const ExpectedCount& rows)
{
    constexpr double greatest_ratio = 1e4;  // larger ratios cost partials their accuracy
    std::vector<double> weights =
        read_rows(value, columns, rows, [](const JsonValue& item) {
            const double weight = item.number();
            if (!(weight > 0))
                throw item.complaint("weight " + item.shown(), "a number above zero",
                                     "E_SURFACE");
            return weight;
        });
    const auto [least, greatest] = std::ranges::minmax(weights);
    if (greatest > greatest_ratio * least)
        throw value.complaint(
            "weights from " + to_text(least) + " to " + to_text(greatest),
            "weights that differ by a factor of at most " + to_text(greatest_ratio),
            "E_SURFACE");
    // Only ratios matter, and scaling by a power of two is exact.
    const int exponent = std::ilogb(greatest);
    for (double& weight : weights)
        weight = std::ldexp(weight, -exponent);
    return weights;
}

}  // namespace endmill
