// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/bound/detail/covered_sets.h"
#include "endmill/bound/detail/density_updates.h"
#include "endmill/bound/detail/inflow.h"

namespace endmill {

/// Maximises the integral of a density g >= 0 under the condition that at no contact and
/// in no direction the inflow exceeds 1, by multiplicative updates.
///
/// 1. Places at half the spacing of the nodes along the surface, on both sides of the
///    borders of patches.
/// 2. g starts at one over the widest strip. Each update multiplies g at a node by m^(-1/2)
///    if m > 1 and else by m^(-1/4), where m is the greatest inflow of all places whose
///    boundary meets the four cells about the node. The best g is kept.
/// 3. The places at a quarter of the spacing, and then three times random ones, are tested.
///    Those that exceed 1 join the places, and the updates go on.
/// 4. Fresh random places are tested, and g is divided by the greatest inflow of all.
///
/// Sums are formed in a fixed order, so that the result does not depend on the number of
/// threads.
/// Source: docs/methods/path-length-bound.md, section 6.
class DensitySearch {
public:
    /// \param part its surfaces must outlive this.
    /// \param problem must outlive this.
    /// \param options spacing, tests and progress.
    DensitySearch(const BoundedPart& part, const BoundProblem& problem,
                  DensitySearchOptions options);

    /// The density.
    FoundDensity run();

    /// The greatest inflow of a density at each of `count` random places, uniform over the
    /// area; 0 where the ball cannot touch.
    /// \param density g at the nodes, 1/mm.
    /// \param count number of places.
    /// \param seed of the places.
    std::vector<double> inflows_at_random(std::span<const double> density,
                                          std::size_t count, std::uint64_t seed) const;

private:
    // What a test of a place gives.
    struct Tested {
        std::vector<StoredFlow> flows;
        double inflow = 0;
        double disc = 0;
        double start = 0;  // one over the widest strip
    };

    Tested tested(const ContactPlace& place, std::span<const double> density,
                  CoveredSets::Want want) const;
    std::vector<ContactPlace> lattice_places(std::span<const DensityCell> cells,
                                             double step) const;
    std::vector<ContactPlace> random_places(std::size_t count, std::uint64_t seed) const;
    void start_from(const std::vector<ContactPlace>& places);
    std::vector<std::size_t> test(const std::vector<ContactPlace>& places);
    void test_at_random(std::uint64_t seed);
    void report(double share) const;

    BoundedPart part_;
    const BoundProblem& problem_;
    DensitySearchOptions options_;
    DensityGrid grid_;
    CoveredSets sets_;
    std::vector<double> density_;
    std::vector<std::vector<StoredFlow>> places_;
};

}  // namespace endmill
