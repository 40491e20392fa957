// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "endmill/planning/detail/economy_tables.h"

namespace endmill {

/// A table with the size and the scaling of `printed` in which nothing is a whole number of
/// passes or points, for null tests:
///
///     NCL = a delta^b R^c (1 + e), rounded,      TCD = s(delta) NCL + W + f,
///
/// with a, b and c by least squares from the nine printed NCL of a direction, e normal with the standard
/// deviation of their residuals, W uniform from 100 to 500 mm with up to 10 mm more or less per row, s
/// the power law of the slopes that the printed rows have with this W, and f uniform within 0.5 mm. TCD
/// is rounded to 0.1 mm as in print.
/// Source: experiments/economic-cl-data/lost-surface/criterion.md, null A.
/// \param printed cells that set size and scaling.
/// \param seed    of MT19937; the cells do not depend on the standard library.
EconomyTables structureless_tables(const EconomyTables& printed, std::uint32_t seed);

}  // namespace endmill
