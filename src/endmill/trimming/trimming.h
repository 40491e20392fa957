// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/offset/section_curve.h"

/// \file
/// Curves of one drive plane after trimming, and the options of the trimming methods.
///
/// A *cusp* is a point at which a curve reverses its direction in s. A *fold* is a piece
/// of a curve along which s decreases; it usually has a cusp at each end. A *tail* is a
/// fold at an end of the curve. The *branches* of a fold are the pieces before and after
/// it. A *crossing* is a point at which two branches intersect.

namespace endmill {

/// A segment of a section curve: the numbers of the curve and of the segment's first
/// point. For a vertex the pair means the point itself.
struct SegmentNumber {
    std::int32_t curve;  ///< number of the curve
    std::int32_t point;  ///< number of the point in the curve
    friend bool operator==(const SegmentNumber&, const SegmentNumber&) = default;
};

/// The origin of a point of a trimmed curve.
enum class TrimmedKind : std::uint8_t {
    Vertex,    ///< the vertex `on`, with unchanged coordinates
    Crossing,  ///< the crossing of the segments `on` and `across`
    Link,      ///< on the segment `on`, vertically above or below the vertex `across`
    /// An end that clipping to the part made, on the segment `on`; `across` equals `on`.
    End
};

/// A point of a trimmed curve with its origin.
struct TrimmedPoint {
    SectionPoint at;       ///< s and z in mm
    SegmentNumber on;      ///< the vertex, or the segment that carries it
    SegmentNumber across;  ///< see TrimmedKind
    TrimmedKind kind;      ///< its origin
};

/// A connected curve of a trimmed result.
struct TrimmedCurve {
    std::vector<TrimmedPoint> points;  ///< at least two
    bool is_closed = false;            ///< then the last point repeats the first
};

/// The reason why a method cut points out of a curve.
struct AppliedRule {
    std::int32_t curve;        ///< number of the curve
    std::int32_t first_point;  ///< first point that was cut out
    std::int32_t last_point;   ///< last point that was cut out
    std::string_view rule;     ///< a word with static lifetime, such as "E1" or "P4"
};

/// The result of trimming the curves of one plane.
struct Trimmed {
    std::vector<TrimmedCurve> curves;  ///< ordered by smallest s, then by z there
    std::vector<AppliedRule> rules;    ///< in the order in which the method applied them
    /// Default rule of all cuts that `rules` does not list. The text has static lifetime.
    std::string_view rule;
    /// Number of folds that remain: no crossing was found, and no rule for the ends of a
    /// curve (E1, E2, E3) applies. Source: docs/methods/interference.md, section 4.
    int unresolved = 0;
};

/// The rules by which methods 1, 2 and 3 find folds.
enum class FoldDetection : std::uint8_t {
    Literal,  ///< by the signs of dz, as printed in the paper
    Guarded   ///< by corrected rules on the runs along which s grows or falls
};

/// The sign patterns of dz that count as a fold with literal detection.
enum class FoldPatterns : std::uint8_t {
    P3AndP4,  ///< + - + and - + - +, as the paper prints
    P4        ///< - + - + only, to show the effect of the other pattern
};

/// The search of method 3 for the crossing of two branches A and B.
enum class BranchSearch : std::uint8_t {
    March,  ///< one pointer along each branch, in |A| + |B| steps
    Scan,   ///< every pair of segments, in |A| |B| steps; the same crossing as `March`
    /// As `Scan`, but with literal detection B is not only its run of dz: it continues to
    /// the end of the curve, as the paper prints. With guarded detection the same as
    /// `Scan`. Source: [JangKimJeong, section IV.3].
    ScanToEnd
};

/// The options of all methods. Each method uses the options that name it and ignores the
/// others.
struct TrimmingOptions {
    FoldDetection detection = FoldDetection::Guarded;  ///< of methods 1, 2 and 3
    /// Distance of the scan lines of method 1 in mm; it must be above 0.
    double scan_step = 0;
    /// Largest |ds| in mm at which method 1 accepts an intersection; it must be above 0.
    double scan_threshold = 0;
    BranchSearch search = BranchSearch::March;  ///< of method 3
    /// Used by methods 1, 2 and 3 with literal detection.
    FoldPatterns patterns = FoldPatterns::P3AndP4;
};

}  // namespace endmill
