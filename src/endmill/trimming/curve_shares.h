// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/trimming/trimming.h"
#include "endmill/trimming/trimming_methods.h"

/// \file
/// The curves of one plane, divided among processes that trim them.

namespace endmill {

/// Curves of a plane that follow one another.
struct CurveShare {
    std::size_t first;  ///< number of the first curve
    std::size_t count;  ///< of curves
};

/// Divides the curves of a plane into shares that can be trimmed one by one: the joined
/// results are those of all curves together. The shares have about equally many points, as far
/// as the method allows.
///
/// If the method couples no curves and all are open, a share ends behind any curve. Otherwise
/// it ends only where the curves so far lie at smaller s than all later ones, and it has an
/// open curve, since the method `winding` treats a plane without open curves in another way.
/// \param curves in the order of their smallest s. \param coupling of the method.
/// \param most number of shares, at least 1.
/// \return 1 to `most` shares that together have all curves in their order; none without a
///         curve.
/// \throws DomainError unless `most` is at least 1.
std::vector<CurveShare> curve_shares(std::span<const SectionCurve> curves,
                                     CurveCoupling coupling, std::size_t most);

/// Joins the results of shares to the result for the plane.
/// \param shares of curve_shares. \param results one for each share, with the numbers of
///        curves counted from the first one of the share.
/// \throws DomainError unless there are as many results as shares.
Trimmed joined(std::span<const CurveShare> shares, std::vector<Trimmed> results);

}  // namespace endmill
