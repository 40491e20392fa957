// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/dexel_stock.h"

#include <cmath>
#include <limits>
#include <string>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr double finest_unit = 0x1p-20;  // mm
// Longest ray in units; a power of two below the range of a number of 32 bits.
constexpr double most_units = 0x1p30;
// Memory per ray while its tile is cut: two intervals, their numbers, and lists.
constexpr double bytes_a_ray = 120;
// Share by which a proposed pitch grows until the stock fits.
constexpr double pitch_step = 0.05;

int cells_across(double side, double pitch)
{
    const double cells = std::max(1.0, std::ceil(side / pitch * (1 - 1e-12)));
    if (!(cells <= std::numeric_limits<int>::max()))
        throw LimitError{"a pitch of " + to_text(pitch) +
                         " mm gives more than 2^31 - 1 rays side by side"};
    return static_cast<int>(cells);
}

void check(const Block& block, double pitch)
{
    require(block.low.allFinite() && block.high.allFinite() &&
                (block.low.array() < block.high.array()).all(),
            "DexelStock: need a finite block with low < high");
    require(std::isfinite(pitch) && pitch > 0, "DexelStock: need 0 < pitch");
}

double checked_unit(const Block& block, double pitch)
{
    check(block, pitch);
    double unit = finest_unit;
    while ((block.high - block.low).maxCoeff() > most_units * unit)
        unit *= 2;
    return unit;
}

DexelField full_field(const Block& block, int axis, double pitch, double unit)
{
    const double length = block.high[axis] - block.low[axis];
    return {block, axis, pitch, static_cast<std::int32_t>(std::lround(length / unit))};
}

double interval_length(std::span<const DexelInterval> intervals)
{
    std::int64_t sum = 0;
    for (const DexelInterval& interval : intervals)
        sum += std::int64_t{interval.to} - interval.from;
    return static_cast<double>(sum);
}

}  // namespace

DexelField::DexelField(const Block& block, int axis, double pitch, std::int32_t units)
    : block_{block},
      axis_{axis}
{
    const int along_columns = (axis + 1) % 3;
    const int along_rows = (axis + 2) % 3;
    const Vec3 sides = block.high - block.low;
    columns_ = cells_across(sides[along_columns], pitch);
    rows_ = cells_across(sides[along_rows], pitch);
    const double rays = static_cast<double>(columns_) * rows_;
    if (!(rays < std::numeric_limits<std::int32_t>::max()))
        throw LimitError{"a pitch of " + to_text(pitch) +
                         " mm gives more than 2^31 - 1 rays"};
    column_step_ = sides[along_columns] / columns_;
    row_step_ = sides[along_rows] / rows_;
    const auto count = static_cast<std::size_t>(rays);
    for (Intervals* of : {&upper_, &lower_}) {
        of->all.assign(count, {0, units});
        of->first.reserve(count + 1);
        for (std::size_t k = 0; k <= count; ++k)
            of->first.push_back(static_cast<std::uint32_t>(k));
    }
}

Vec3 DexelField::start(int column, int row) const
{
    Vec3 place = block_.low;
    place[(axis_ + 1) % 3] += (column + 0.5) * column_step_;
    place[(axis_ + 2) % 3] += (row + 0.5) * row_step_;
    return place;
}

void DexelField::assign(std::span<const Dexel> dexels)
{
    require(dexels.size() == static_cast<std::size_t>(columns_) * rows_,
            "DexelField: need one dexel for each ray");
    const auto fill = [&](Intervals& of, std::vector<DexelInterval> Dexel::*set) {
        std::size_t count = 0;
        for (const Dexel& dexel : dexels)
            count += (dexel.*set).size();
        Intervals filled;
        filled.all.reserve(count);
        filled.first.reserve(dexels.size() + 1);
        for (const Dexel& dexel : dexels) {
            filled.first.push_back(static_cast<std::uint32_t>(filled.all.size()));
            filled.all.insert(filled.all.end(), (dexel.*set).begin(), (dexel.*set).end());
        }
        filled.first.push_back(static_cast<std::uint32_t>(filled.all.size()));
        of = std::move(filled);
    };
    fill(upper_, &Dexel::upper);
    fill(lower_, &Dexel::lower);
}

DexelStock::DexelStock(const Block& block, double pitch)
    : block_{block},
      pitch_{pitch},
      unit_{checked_unit(block, pitch)},
      fields_{full_field(block, 0, pitch, unit_), full_field(block, 1, pitch, unit_),
              full_field(block, 2, pitch, unit_)}
{
}

DexelVolume dexel_volume(const DexelStock& stock, int axis)
{
    const DexelField& field = stock.field(axis);
    DexelVolume sum{0, 0};
    for (int row = 0; row < field.rows(); ++row)
        for (int column = 0; column < field.columns(); ++column) {
            sum.upper += interval_length(field.upper(column, row));
            sum.lower += interval_length(field.lower(column, row));
        }
    const double volume = stock.unit() * field.cell_area();
    return {sum.upper * volume, sum.lower * volume};
}

double required_dexel_bytes(const Block& block, double pitch, double extra)
{
    const Vec3 sides = block.high - block.low;
    double rays = 0;
    for (int axis = 0; axis < 3; ++axis)
        rays += std::ceil(sides[(axis + 1) % 3] / pitch) *
                std::ceil(sides[(axis + 2) % 3] / pitch);
    return rays * (bytes_a_ray + extra);
}

void require_dexel_memory(const Block& block, double pitch, double memory_gib,
                          double extra)
{
    check(block, pitch);
    const double bytes = required_dexel_bytes(block, pitch, extra);
    const double limit = memory_gib * bytes_per_gib;
    if (bytes <= limit)
        return;
    double fitting = pitch;
    while (required_dexel_bytes(block, fitting, extra) > limit)
        fitting *= 1 + pitch_step;
    const double digits = std::pow(10, 1 - std::floor(std::log10(fitting)));
    throw LimitError{"a stock of dexels at a resolution of " + to_text(pitch) +
                     " mm would need about " +
                     to_text(std::ceil(bytes / bytes_per_gib * 10) / 10) +
                     " GiB; expected at most " + to_text(memory_gib) +
                     " GiB (--max-memory), which a resolution of " +
                     to_text(std::ceil(fitting * digits) / digits) + " mm fits"};
}

}  // namespace endmill
