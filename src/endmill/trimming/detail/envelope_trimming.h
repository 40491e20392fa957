// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/trimming/trimming.h"

namespace endmill {

/// Method `envelope`: the upper envelope of all segments of all curves of a plane,
/// vertical segments included, over [min s, max s] of all their points. No path of a tool
/// that comes from above can be lower without a gouge of the sampled offset. Jumps become
/// vertical links. The result breaks where no curve lies over an open interval. A
/// vertical segment that stands alone over its s becomes a curve of its own, directed
/// upwards. Where segments coincide, the one with the smallest number counts as the
/// carrier.
///
/// Exact for all finite coordinates: every decision is that of the exact geometry of the
/// given points, and each coordinate of a crossing or a link is the double nearest to the
/// exact value. About 50 ns per segment.
/// Source: docs/methods/interference.md, section 6; exactness: section 7.
/// \param curves the section curves of one plane.
/// \param options ignored.
/// \throws DomainError if a coordinate is not finite.
/// \throws LimitError if the curves have 2^31 - 1 points or more.
Trimmed envelope_trimming(std::span<const SectionCurve> curves,
                          const TrimmingOptions& options = {});

/// The upper envelope of section curves as a function of s.
class EnvelopeHeight {
public:
    /// \throws DomainError and LimitError as envelope_trimming does.
    explicit EnvelopeHeight(std::span<const SectionCurve> curves);

    /// z in mm at `s`; at a vertical step its upper end; nothing where no curve lies.
    std::optional<double> at(double s) const;

private:
    struct Point {
        SectionPoint at;
        bool is_joined;  ///< with the point before it
    };

    std::vector<Point> points_;  // ordered by s
};

}  // namespace endmill
