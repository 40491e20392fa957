// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/planning/detail/economy_tables.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// One row of the tables: CL points and travel for the three balls.
struct CostRow {
    std::array<int, 3> ncl;
    std::array<double, 3> tcd_mm;
};

/// An interpretation of a row by whole numbers. It assumes N passes of equal chord length
/// L, with f points on each forward pass and b points on each backward pass, joined by
/// links of total length W:
///
///     NCL = (f + b) floor(N / 2) [+ f if N is odd],  TCD = N L + W,
///
/// where f, b, L and W are the same for all three balls.
struct Decoding {
    int points_a_pair;                  ///< f + b
    std::optional<int> points_forward;  ///< f; none if every N is even
    std::array<int, 3> passes;          ///< N, all different
    double chord_mm;                    ///< L, by least squares
    double link_mm;                     ///< W, by least squares
    double residual_mm;                 ///< largest |N L + W - TCD|
};

/// All interpretations of `row` with a residual of at most `tolerance_mm` and with L in
/// `chord_mm`, in ascending order of f + b.
std::vector<Decoding> decodings(const CostRow& row, double tolerance_mm,
                                const Interval& chord_mm);

/// Number of ways to choose one interpretation of each of three rows such that their L
/// agree: (max - min) / mean is at most `spread`.
int one_chord_triples(std::span<const std::vector<Decoding>, 3> readings, double spread);

/// Conditions on an interpretation.
struct DecodingRules {
    double tolerance_mm;  ///< largest residual, see `decodings`
    double chord_spread;  ///< see `one_chord_triples`
    /// Upper bound of L in widths of the part along the pass; the lower is 1.
    double longest_chord;
};

/// Bounds of L in mm for passes along `direction` on the paper's part of 200 by 120 mm.
/// Source: [KimChoi, fig. 2].
Interval chord_bounds(Parameter direction, const DecodingRules& rules);

/// The interpretations of the rows of one direction, one for each tolerance.
/// \param direction index of table_directions.
std::array<std::vector<Decoding>, 3> readings_of(const EconomyTables& tables,
                                                 std::size_t direction,
                                                 const DecodingRules& rules);

/// Counts of rows that have an interpretation although nothing in them is a whole number.
struct NullTest {
    int rows;          ///< rows tried, three a triple
    int rows_read;     ///< rows with an interpretation
    int triples;       ///< triples tried: the rows of one direction for three tolerances
    int triples_read;  ///< triples whose three rows all have interpretations of one L
};

/// Null test of `decodings` on `triples` triples of synthetic rows. The rows have the
/// size of the printed ones, scale with the interval on a plane and have collinear (NCL,
/// TCD) as the printed ones do; their numbers of passes and of points a pass are real
/// numbers.
/// \param printed the cells that set the size of the synthetic rows.
/// \param seed of the generator MT19937. The rows do not depend on the standard library.
NullTest null_test(const EconomyTables& printed, const DecodingRules& rules, int triples,
                   std::uint32_t seed);

}  // namespace endmill
