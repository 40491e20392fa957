// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "endmill/bound/detail/certified_inflow.h"

namespace endmill {

/// A density whose inflow is certainly at most 1 everywhere, up to rounding.
struct CertifiedDensity {
    std::vector<double> at_nodes;  ///< g, 1/mm
    double integral = 0;           ///< lower bound of the integral over the part, mm
    double greatest_disc = 0;      ///< upper bound of the integral over a covered set, mm
    std::size_t boxes = 0;         ///< boxes of contacts that were evaluated
    double greatest_inflow = 0;    ///< greatest upper bound of a box before the division
    double given_up = 0;           ///< share of the integral that was set to 0
};

/// How a density is certified.
struct CertificateOptions {
    double node_spacing;                              ///< mm, of the grid
    double excess = 0.04;                             ///< accepted excess of the inflow
    std::size_t most_boxes = 1'000'000;               ///< evaluations at most, about
    std::function<void(double share)> progress = {};  ///< called with 0 to 1
};

/// Divides a density at its nodes so that the inflow is certainly at most 1.
///
/// The contacts are covered by boxes of parameters. Boxes whose inflow is not below 1 plus the
/// accepted excess are halved, up to a limit. Each node is divided by the greatest bound of the
/// boxes whose boundaries may come near it. Since the inflow is a sum of densities with
/// positive weights, each box then has an inflow of at most 1. Where no bound is found, the
/// density is set to 0 wherever the tool may reach.
/// Source: docs/methods/path-length-bound.md, section 7.
/// \param part its surfaces must outlive the call.
/// \param problem the tool.
/// \param density g at the nodes of a grid with the given spacing.
/// \param options spacing and limits.
/// \throws GeometryError if the density had to be set to 0 on a fifth of the integral.
CertifiedDensity certified_density(const BoundedPart& part, const BoundProblem& problem,
                                   std::span<const double> density,
                                   const CertificateOptions& options);

}  // namespace endmill
