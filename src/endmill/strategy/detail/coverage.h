// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/strategy/detail/part_samples.h"
#include "endmill/strategy/detail/reach.h"

namespace endmill {

/// Walks over the neighbourhoods of samples without visiting a sample twice in a walk.
class SampleWalk {
public:
    explicit SampleWalk(const PartSamples& samples)
        : samples_{&samples},
          mark_(samples.size(), 0)
    {
    }

    /// Calls `visit(i)` for the samples of `seeds`, and for the neighbours of each sample
    /// for which it returned true.
    template <typename Visit>
    void from(std::span<const std::int32_t> seeds, Visit&& visit)
    {
        begin();
        for (const std::int32_t seed : seeds)
            enter(seed);
        for (std::size_t next = 0; next < queue_.size(); ++next)
            if (const std::int32_t i = queue_[next]; visit(i))
                for (const std::int32_t neighbour : samples_->neighbours(i))
                    enter(neighbour);
    }

private:
    void begin()
    {
        queue_.clear();
        if (++walk_ == 0) {
            std::fill(mark_.begin(), mark_.end(), 0);
            walk_ = 1;
        }
    }

    void enter(std::int32_t i)
    {
        if (mark_[i] == walk_)
            return;
        mark_[i] = walk_;
        queue_.push_back(i);
    }

    const PartSamples* samples_;
    std::vector<std::uint32_t> mark_;
    std::uint32_t walk_ = 0;
    std::vector<std::int32_t> queue_;
};

/// A place in a triangle that no move covers.
struct MissedPlace {
    std::int32_t triangle;          ///< number of the triangle
    std::array<double, 3> weights;  ///< of its corners; their sum is 1
    double gap;                     ///< mm
};

/// The number of the corner beside a place.
std::int32_t sample_beside(const PartSamples& samples, const MissedPlace& place);
/// The contact at a place, on the part.
PassContact contact_at(const PartSamples& samples, const MissedPlace& place);

/// What the moves of a path have covered so far. The gap of a sample is the amount by
/// which the sample, raised along its normal by the scallop height, lies beyond the reach
/// of the nearest move; see beyond_reach. A sample is covered if its gap is not positive.
/// Source: docs/methods/iso-scallop.md, section 1.
class Coverage {
public:
    /// \param samples of the part, with the tool axis along +z; must outlive this object.
    /// \param cutter  the ball.
    /// \param height  scallop height h in mm.
    Coverage(const PartSamples& samples, const BallCutter& cutter, double height);

    /// Adds the straight moves of a pass, and remembers the gaps that they change.
    /// \param pass     contacts in order.
    /// \param is_closed whether a move leads from the last contact back to the first.
    void add(std::span<const PassContact> pass, bool is_closed);

    /// Adds the straight moves between places on the net.
    void add(std::span<const SampleEdge> pass, bool is_closed);

    /// Takes back the moves that were added since the last `accept` or `withdraw`.
    void withdraw();
    /// Keeps the moves that were added since.
    void accept()
    {
        changes_.clear();
        accepted_moves_ = moves_.size();
    }
    /// The samples whose gap has come down to `slack` mm or below since the last `accept` or
    /// `withdraw`.
    std::vector<std::int32_t> newly_covered(double slack) const;

    /// Measures the gaps of these places too, from the next `add` on. Between samples they
    /// tell what the samples miss.
    void watch(std::span<const SampleEdge> places);
    /// The gaps of the watched places by the moves since `watch` or `withdraw`, mm; R where
    /// no move is near.
    std::span<const double> watched_gaps() const { return watched_gaps_; }

    /// Places between the samples of a triangle that are not covered, where its samples are.
    /// A triangle is covered if one move covers its corners: what a move covers is convex.
    /// Otherwise the triangle is divided into four. The curvature of the surface within the
    /// last parts is neglected. Places between samples are those of near_place.
    /// \param triangles numbers of triangles.
    /// \param slack     a gap of at most this many mm counts as covered.
    /// \param halvings  of the sides of a triangle.
    std::vector<MissedPlace> missed(std::span<const std::int32_t> triangles, double slack,
                                    int halvings = 4) const;

    std::span<const double> gaps() const { return gaps_; }  ///< of all samples, mm
    const PartSamples& samples() const { return *samples_; }
    const BallCutter& cutter() const { return cutter_; }
    double height() const { return height_; }  ///< mm

    /// The point that a ball must reach to cover sample i, mm.
    const Vec3& raised(std::size_t i) const { return raised_[i]; }

    /// The same point at a place between samples, to the accuracy of near_place.
    Vec3 raised(const SampleEdge& place) const
    {
        const CutterContact at = samples_->near_place(place);
        return at.point + height_ * at.normal;
    }

    /// The gap of a place between samples by their nearest moves, mm. It is not below the gap
    /// by all moves; R without a move.
    double gap_at(const SampleEdge& place) const;

    /// Centre of the ball at sample i, mm.
    const Vec3& centre(std::size_t i) const { return centres_[i]; }

private:
    // A watched place; places at one sample are linked.
    struct Watched {
        Vec3 raised;
        std::int32_t next;  // at the same sample, or -1
    };

    // The state of a sample before a change.
    struct Change {
        std::int32_t sample;
        double gap;
        std::int32_t move;
    };

    // An end of a move.
    struct MoveEnd {
        Vec3 centre;
        std::int32_t near;
    };

    MoveEnd end_at(const PassContact& contact) const;
    MoveEnd end_at(const SampleEdge& place) const;
    template <typename Place>
    void add_moves(std::span<const Place> pass, bool is_closed);
    void add_move(const MoveEnd& from, const MoveEnd& to);

    const PartSamples* samples_;
    BallCutter cutter_;
    double height_;
    std::vector<Vec3> raised_;
    std::vector<Vec3> centres_;
    std::vector<double> gaps_;
    std::vector<UprightSweep> moves_;
    std::size_t accepted_moves_ = 0;
    std::vector<std::int32_t> nearest_move_;  // of each sample, or -1
    std::vector<Change> changes_;
    SampleWalk walk_;
    std::vector<Watched> watched_;
    std::vector<double> watched_gaps_;
    std::vector<std::int32_t> first_watched_;  // at each sample, or -1
    std::vector<std::int32_t> watching_;       // samples with watched places
};

}  // namespace endmill
