// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/strategy/detail/coverage.h"
#include "endmill/strategy/detail/level_lines.h"

namespace endmill {

/// Where the contacts of a section lie.
enum class SectionContacts {
    OnSurface,  ///< on the surface
    OnNet,      ///< between samples, without parameters, which is quicker
};

/// Lays passes in parallel upright planes, front by front.
///
/// The offset of a point is t = -x sin a + y cos a. Each pass is the section of the part
/// with the plane of an offset. The next offset is the largest at which every place on the
/// front of what is covered, and every place where a part of the surface begins, is covered
/// by the ball at some contact of the section.
/// Source: docs/methods/planar-passes.md, section 1.
class SectionMarch {
public:
    /// \param coverage  what is covered so far; passes are added to it.
    /// \param direction of the passes, from +x towards +y.
    /// \param slack     samples with a gap of at most this many mm count as covered.
    /// \param contacts  where they lie.
    SectionMarch(Coverage& coverage, Angle direction, double slack,
                 SectionContacts contacts);

    /// Lays passes along the level lines of any values instead.
    /// \param offsets of the samples, mm; equal at one place. Their gradient is about 1.
    SectionMarch(Coverage& coverage, std::vector<double> offsets, double slack);

    /// The passes from the lowest offset to the highest. What they leave uncovered in
    /// spite of all is not covered by any further pass of the direction.
    std::vector<LaidPass> passes();

private:
    // A place that the next pass must cover, and its offset at most.
    struct Demand {
        SampleEdge place;
        double farthest;  // a lower bound
    };

    // Demands, and the offset from which further ones do not matter.
    struct Demands {
        std::vector<Demand> open;
        double limit;
    };

    void sort_samples();
    bool is_uncovered(std::int32_t i) const { return coverage_->gaps()[i] > slack_; }
    double offset_of(const Vec3& point) const
    {
        return point.y() * cosine_ - point.x() * sine_;
    }
    Vec3 raised(const SampleEdge& place) const;
    SampleEdge front_place(std::int32_t covered, std::int32_t uncovered) const;
    void walk_reach(const SampleEdge& place, double limit);
    bool climbs_to(const SampleEdge& place, double limit) const;
    double nearly_farthest(const SampleEdge& place, double limit);
    double farthest(const Demand& demand);
    std::int32_t nearest_covered(std::int32_t uncovered) const;
    bool is_beginning(std::int32_t uncovered) const;
    bool add_demand(const SampleEdge& place, Demands& demands);
    void add_demands_at(std::int32_t uncovered, Demands& demands);
    std::vector<Demand> demands();
    double next_offset();
    double centred_last(double offset);
    std::vector<LaidPass> sections(double offset) const;
    PassContact contact_on(const SampleEdge& place, double offset) const;
    LaidPass pass_on(const LevelLine& line, double offset) const;
    void lay(double offset);
    bool is_complete() const;

    Coverage* coverage_;
    const PartSamples* samples_;
    double slack_;
    SectionContacts contacts_;
    bool is_planar_;                   // whether the sections are plane
    double sine_ = 0;                  // of the direction of plane sections
    double cosine_ = 0;                // of it
    double strip_;                     // greatest width of a strip on a plane, mm
    std::vector<double> offsets_;      // of the samples, mm
    std::vector<std::int32_t> order_;  // samples by offset
    std::size_t first_ = 0;            // in order_; all before it are covered or lost
    std::vector<bool> is_border_;      // samples on the border
    std::vector<bool> is_lost_;        // samples that no further pass covers
    double last_ = -std::numeric_limits<double>::infinity();  // offset of the last pass
    SampleWalk walk_;
    std::vector<double> beyond_;        // of the samples of the last walk
    std::vector<std::int32_t> inside_;  // samples whose ball reaches the place
    std::vector<std::int32_t> around_;  // samples beside them
    std::vector<LaidPass> passes_;
};

/// Lengths of passes.
struct PassLengths {
    double contact_mm = 0;  ///< of the contacts
    double tip_mm = 0;      ///< of the tips
};

/// The lengths of passes, by straight lines between contacts.
PassLengths pass_lengths(std::span<const LaidPass> passes, double radius);

}  // namespace endmill
