// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/surface/surface_jet.h"
#include "support/printed_tables.h"

namespace endmill {

/// A row of the tables: points and travel with three balls.
struct CostRow {
    std::array<int, 3> ncl;
    std::array<double, 3> tcd_mm;
};

/// A reading of a row as N passes of equal chord length L, f points on each pass marched
/// forwards and b on each of the others, joined by links of total length W:
/// NCL = (f + b) floor(N / 2) [+ f if N is odd], TCD = N L + W, with f, b, L and W the
/// same for all three balls.
struct Decoding {
    int points_a_pair;                  ///< f + b
    std::optional<int> points_forward;  ///< f; none if every N is even
    std::array<int, 3> passes;          ///< N, all different
    double chord_mm;                    ///< L, by least squares
    double link_mm;                     ///< W, likewise
    double residual_mm;                 ///< greatest of |N L + W - TCD|
};

/// All readings of `row` whose residual is at most `tolerance_mm` and whose L lies in
/// `chord_mm`, by rising f + b.
std::vector<Decoding> decodings(const CostRow& row, double tolerance_mm,
                                const Interval& chord_mm);

/// Number of ways to choose a reading of each of three rows so that they have one L:
/// (max - min) / mean is at most `spread`.
int one_chord_triples(std::span<const std::vector<Decoding>, 3> readings, double spread);

/// What counts as a reading.
struct DecodingRules {
    double tolerance_mm;   ///< see decodings
    double chord_spread;   ///< see one_chord_triples
    double longest_chord;  ///< in widths of the part along the pass; the shortest is one
};

/// Bounds of L for passes along `direction` of the paper's part, 200 by 120 mm.
/// Source: [KimChoi, fig. 2].
Interval chord_bounds(Parameter direction, const DecodingRules& rules);

/// How often rows without any such structure are read all the same.
struct NullTest {
    int rows;          ///< tried, three a triple
    int rows_read;     ///< with a reading
    int triples;       ///< tried: a direction's rows for three tolerances
    int triples_read;  ///< with readings of all three rows that have one L
};

/// Reads `triples` triples of synthetic rows, which have the print's size, its scaling
/// with the interval on a plane and its collinear (NCL, TCD), but counts of passes and of
/// points that are no whole numbers. \param printed the cells whose size the synthetic
/// ones take. \param seed of the generator MT19937; the same rows on every machine.
NullTest null_test(const EconomyTables& printed, const DecodingRules& rules, int triples,
                   std::uint32_t seed);

}  // namespace endmill
