// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "endmill/planning/detail/economy_tables.h"

/// \file
/// How well computed tables match given ones, in bits.
/// Source: experiments/economic-cl-data/lost-surface/criterion.md.

namespace endmill {

/// Greatest deviation of a matched TCD: one unit of the last printed digit, mm.
inline constexpr double matched_travel_mm = 0.1;

/// Bits of the deviation of one cell, 1/2 log2(1 + (difference / unit)^2), where the unit is half a
/// point for NCL and `matched_travel_mm` for TCD: zero if equal, and one more for each doubling of
/// a large deviation.
double deviation_bits(TableQuantity quantity, double difference);

/// Whether a run of given tables is left out: it has no points. It counts nowhere.
bool is_left_out(const DirectionCost& target);

/// Bits of the deviation of a run: those of NCL and TCD; 0 if `target` is left out.
double deviation_bits(const DirectionCost& run, const DirectionCost& target);

/// Bits of the deviation of all cells.
double deviation_bits(const EconomyTables& tables, const EconomyTables& target);

/// Number and information of the matched cells of one direction, or of both.
struct TableMatch {
    int ncl = 0;               ///< cells of NCL that are equal
    int tcd = 0;               ///< cells of TCD within `matched_travel_mm`
    double information = 0;    ///< bits of the matched cells
    double choice = 0;         ///< bits of the choice of the matched cells among all
    double worst_percent = 0;  ///< largest relative deviation of a cell, in percent
    double rms_percent = 0;    ///< root mean square of the relative deviations
    double deviation = 0;      ///< see deviation_bits
};

/// Compares the cells of `directions`, but for those that `target` leaves out.
/// \param tables  computed.
/// \param target  cells to match.
/// \param directions one or both; the cells of the others do not count.
/// \param quantities one or both tables.
TableMatch table_match(const EconomyTables& tables, const EconomyTables& target,
                       std::span<const Parameter> directions = table_directions,
                       std::span<const TableQuantity> quantities = table_quantities);

/// Bits that the free values of a surface cost: for each, log2(range / width), at least 1. The width
/// is the interval about the value in which `matched` does not fall below its number at `values`, all
/// other values being fixed. It is found by growing steps and bisection on either side, to 10 %.
/// \param values  of the surface.
/// \param ranges  that the search may use, one for each value.
/// \param matched number of matched cells for given values.
double bits_of_values(std::span<const double> values, std::span<const Interval> ranges,
                      const std::function<int(std::span<const double>)>& matched);

}  // namespace endmill
