// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "endmill/strategy/detail/coverage.h"
#include "endmill/strategy/detail/level_lines.h"

namespace endmill {

/// Lays passes of equal scallop height, front by front.
///
/// The front is the border of what is covered. The reach of a sample is how far the
/// nearest front point, raised by the scallop height, lies beyond a ball in contact with
/// the sample; it is negative where the ball reaches some front point. The next pass runs
/// where the reach is 0 ahead of the front: as far away as possible, with its ball still
/// reaching the front. Passes are level lines, so a front that branches, merges or runs
/// around a hole needs no special case, and no pass crosses itself.
///
/// In a notch of the front the ball on that line may not reach the front. What is left
/// uncovered there is an island between front and pass. The line is bent towards it,
/// and islands that remain get a pass along their middle.
/// Source: docs/methods/iso-scallop.md, section 2.
class FrontMarch {
public:
    /// \param coverage what is covered so far; passes are added to it.
    /// \param slack    samples with a gap of at most this many mm count as covered.
    /// \param rounds   in which a pass is bent towards islands.
    FrontMarch(Coverage& coverage, double slack, int rounds);

    /// Lays passes until everything is covered that fronts can reach.
    /// \param front places from which the first pass keeps the distance of a front; if
    ///        empty, the border of what is covered.
    void run(std::vector<SampleEdge> front = {});

    /// Lays a pass on the given lines, with what lies above `slack` in the gaps.
    void lay(std::span<const LevelLine> lines);

    std::size_t uncovered_samples() const;  ///< number of samples that are not covered

    /// Whether every sample is covered.
    bool is_complete() const { return uncovered_samples() == 0; }

    /// The lowest number of an uncovered sample.
    /// \pre not is_complete()
    std::int32_t first_uncovered() const;

    std::span<const LevelLine> passes() const { return passes_; }  ///< so far

private:
    // A component of uncovered samples that the front surrounds.
    struct Island {
        std::vector<std::int32_t> samples;
        double beside_pass = 0;  // share of the samples around that the last pass covered
        bool is_open = false;    // whether a sample is beyond the reach of the front
    };

    std::vector<SampleEdge> current_front();
    bool step(std::span<const SampleEdge> front);
    void measure_reach(std::span<const SampleEdge> front);
    void forget_reach();
    std::vector<LevelLine> trial_passes(std::span<const double> bend);
    std::vector<LevelLine> try_passes(std::span<const double> bend);
    std::vector<std::int32_t> strip_triangles() const;
    double missed_by(std::span<const Island> left) const;
    std::vector<Island> islands();
    static bool is_notch(const Island& island);
    void want(std::int32_t i, double bend);
    void want_bends(std::span<const Island> islands, std::span<const SampleEdge> front);
    void spread_wanted();
    bool bend_towards(std::span<const Island> islands, std::span<const SampleEdge> front,
                      std::vector<double>& bend);
    std::vector<LevelLine> bent_passes(std::span<const SampleEdge> front);
    bool accept(std::vector<LevelLine> passes);
    LevelLine middle_pass(const Island& island) const;
    double reach_at(const SampleEdge& place) const;
    double bent_reach_at(const SampleEdge& place) const;
    Island island_around(std::int32_t start);
    LevelLine thinned(const LevelLine& line) const;
    void reach_from(std::int32_t front, const SampleEdge& place);
    bool is_uncovered(std::int32_t i) const { return coverage_->gaps()[i] > slack_; }

    Coverage* coverage_;
    const PartSamples* samples_;
    double slack_;
    int rounds_;
    SampleWalk walk_;
    SampleWalk inner_walk_;
    std::vector<double> reach_;  // of each sample, mm; R where no front is near
    std::vector<std::int32_t> nearest_front_;  // number of the front point of the reach
    std::vector<Vec3> front_raised_;           // raised points of the front
    std::vector<std::int32_t> measured_;       // samples with a reach
    std::vector<double> wanted_;               // bend at each sample, mm; 0 between calls
    std::vector<std::int32_t> wanting_;        // samples with a bend
    // bends that are still to be spread, with their samples
    std::priority_queue<std::pair<double, std::int32_t>> spreading_;
    std::vector<MissedPlace> missed_places_;   // of the last trial
    std::vector<bool> is_new_;                 // false between calls
    std::vector<bool> is_seen_;                // false between calls
    std::vector<double> bent_;                 // reach with bend
    std::vector<double> bend_of_;              // bend of each sample, mm
    std::vector<std::int32_t> front_samples_;  // covered, with a neighbour that is not
    std::vector<LevelLine> passes_;
};

}  // namespace endmill
