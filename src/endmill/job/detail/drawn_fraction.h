// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace endmill {

/// A number of [0, 1) that is drawn for a parameter of a case: the first 53 bits of the
/// SHA-256 of the text "SEED/KEY/CASE" divided by 2^53, such as of "7/scallop/12". It depends
/// on nothing else, so that every machine draws the same and cases may be drawn in any order.
double drawn_fraction(std::uint64_t seed, std::string_view key, std::uint64_t number);

/// The geometric mean between two positive numbers, low^(1 - share) high^share. It is
/// computed by square roots and products, which all machines round alike.
/// Relative error below 1e-13.
/// \pre 0 < low <= high, high / low is finite, 0 <= share < 1.
double geometric_between(double low, double high, double share);

}  // namespace endmill
