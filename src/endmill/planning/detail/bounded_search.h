// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "endmill/surface/surface_jet.h"

namespace endmill {

/// The function to minimise. It may return any number above `give_up` as soon as its value is
/// certain to exceed it, and infinity where it is not defined.
using BoundedLoss = std::function<double(std::span<const double> values, double give_up)>;

/// Settings of a search.
struct BoundedSearch {
    int evaluations = 10'000;  ///< of the loss, those that give up included
    std::uint32_t seed = 1;    ///< of MT19937
    int population = 0;  ///< number of candidates; 0: four for each value, at least 20
    double enough = 0;   ///< the search ends at this loss
    /// Members of the first population, within the ranges; the others are random, each in a part of the
    /// box about its middle.
    std::vector<std::vector<double>> start = {};
};

/// The best values that a search found.
struct FoundValues {
    std::vector<double> values;  ///< within the ranges
    double loss = std::numeric_limits<double>::infinity();
    int evaluations = 0;  ///< made
};

/// Minimises `loss` over a box by differential evolution (DE/current-to-pbest/1 with random factors),
/// which needs no derivatives and no continuity: counts of points jump. A trial is compared with one
/// member of the population only, so that a loss that sums up parts may give up early. In the last
/// quarter of the evaluations, trials are normal steps about the best member, with a size per value
/// that adapts (1/5 rule).
///
/// The result depends on the arguments only.
/// \param ranges of the values; at least one, each with low <= high.
/// \param loss   see there; called from one thread.
/// \param search see there.
FoundValues minimise(std::span<const Interval> ranges, const BoundedLoss& loss,
                     const BoundedSearch& search);

/// The part of `ranges` about `values` whose sides are `share` of theirs.
std::vector<Interval> box_about(std::span<const double> values,
                                std::span<const Interval> ranges, double share);

}  // namespace endmill
