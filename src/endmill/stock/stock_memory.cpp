// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_memory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr double bytes_per_gib = 0x1p30;
// What `remove_along` takes for the moves at hand and their bins; measured with a margin.
constexpr double work_bytes_per_cell = 1.5;
constexpr double bytes_of_work = 2.5e6;

// Tiles over a width; a tile more, for a grid is widened to whole cells and tiles.
double tiles_across(double width, double pitch)
{
    return std::ceil(width / pitch / HeightStock::tile_side) + 1;
}

std::string two_digits(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2g", value);
    return text.data();
}

}  // namespace

double required_bytes(const Block& box, double pitch, double extra)
{
    const Vec3 size = box.high - box.low;
    return tiles_across(size.x(), pitch) * tiles_across(size.y(), pitch) *
               HeightStock::tile_size * (sizeof(double) + work_bytes_per_cell + extra) +
           bytes_of_work;
}

std::optional<double> fitting_pitch(const Block& box, double bytes, double extra)
{
    const Vec3 size = box.high - box.low;
    const double largest = std::max(size.x(), size.y());
    // One tile and one more in each direction, whatever the pitch.
    const double least_bytes =
        4.0 * HeightStock::tile_size * (sizeof(double) + work_bytes_per_cell + extra) +
        bytes_of_work;
    if (!(bytes >= least_bytes) || !(largest > 0))
        return std::nullopt;
    // A lower bound: as if the cells were all.
    const double bound = std::sqrt(size.x() * size.y() * sizeof(double) / bytes);
    double decade = std::pow(10, std::floor(std::log10(std::max(bound, largest * 1e-9))));
    for (;; decade *= 10)
        for (int digits = 10; digits < 100; ++digits) {
            // As text, so that the pitch is the double nearest to its two digits.
            const double pitch = *number_from_text(two_digits(decade * digits / 10));
            if (pitch >= bound && required_bytes(box, pitch, extra) <= bytes)
                return pitch;
        }
}

void require_stock_memory(const Block& box, double pitch, double memory_gib, double extra)
{
    require(box.low.allFinite() && box.high.allFinite() &&
                (box.high - box.low).minCoeff() >= 0 && std::isfinite(pitch) && pitch > 0,
            "require_stock_memory: need a finite box and 0 < pitch");
    const double bytes = required_bytes(box, pitch, extra);
    if (bytes <= memory_gib * bytes_per_gib)
        return;
    const Vec3 size = box.high - box.low;
    const auto fits = fitting_pitch(box, memory_gib * bytes_per_gib, extra);
    throw LimitError{"a stock of " + to_text(size.x()) + " x " + to_text(size.y()) +
                     " mm in cells of " + to_text(pitch) + " mm would need about " +
                     two_digits(bytes / bytes_per_gib) + " GiB; expected at most " +
                     to_text(memory_gib) + " GiB (--max-memory)" +
                     (fits && std::isfinite(*fits)
                          ? ", which cells of " + to_text(*fits) + " mm fit"
                          : std::string{})};
}

}  // namespace endmill
