// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/offset/section_curve.h"

namespace endmill {

/// A segment of a section, by the number of its curve and of its first point; or, where a
/// vertex is meant, that point.
struct SegmentNumber {
    std::int32_t curve;
    std::int32_t point;
    friend bool operator==(const SegmentNumber&, const SegmentNumber&) = default;
};

/// What a point of a trimmed curve is.
enum class TrimmedKind : std::uint8_t {
    Vertex,    ///< the vertex `on`, bit for bit
    Crossing,  ///< where the segments `on` and `across` cross
    Link,      ///< on the segment `on`, straight above or below the vertex `across`
    End        ///< on the segment `on`, where what is left was cut off; `across` is `on`
};

/// A point of a trimmed curve and where it comes from.
struct TrimmedPoint {
    SectionPoint at;
    SegmentNumber on;
    SegmentNumber across;
    TrimmedKind kind;
};

/// A connected curve that is left.
struct TrimmedCurve {
    std::vector<TrimmedPoint> points;
    bool is_closed = false;
};

/// Why a method cut points out of a curve.
struct AppliedRule {
    std::int32_t curve;
    std::int32_t first_point;  ///< of those cut out
    std::int32_t last_point;
    std::string_view rule;  ///< a word that lives for ever, such as "E1" or "P4"
};

/// What a method leaves of the curves of one plane.
struct Trimmed {
    std::vector<TrimmedCurve> curves;  ///< by smallest s, then z there
    std::vector<AppliedRule> rules;    ///< in the order in which they were applied
    std::string_view rule;  ///< what cut out all that none of those tells; lives for ever
    int unresolved = 0;     ///< folds found and left, with no crossing and no end rule
};

/// How methods 1, 2 and 3 find folds: as printed, or corrected.
enum class FoldDetection : std::uint8_t { Literal, Guarded };

/// How method 3 goes through the segments of two branches; both give the same answer.
enum class BranchSearch : std::uint8_t { March, Scan };

/// What methods take, each what concerns it.
struct TrimmingOptions {
    FoldDetection detection = FoldDetection::Guarded;  ///< methods 1, 2, 3
    double scan_step = 0;       ///< mm between the lines of method 1; > 0 there
    double scan_threshold = 0;  ///< mm of s at which method 1 sees a crossing; > 0 there
    BranchSearch search = BranchSearch::March;  ///< method 3
    /// Literal detection: whether the signs + - + of dz are a twist, as the paper prints,
    /// and not only - + - +. To see what that sentence does; see literal_folds.h.
    bool three_runs_twist = true;
};

/// A way to cut the loops out of the curves of one plane.
struct TrimmingMethod {
    std::string_view name;   ///< as on the command line
    std::string_view title;  ///< for people
    bool has_detection;      ///< whether it heeds TrimmingOptions::detection
    /// \pre the curves are as SectionCurve says, finite, in the order of their smallest s.
    /// \throws DomainError on an option out of its domain.
    Trimmed (*trim)(std::span<const SectionCurve> curves, const TrimmingOptions& options);
};

/// All methods, in the order in which tables show them. A new method is a line here.
std::span<const TrimmingMethod> trimming_methods();

}  // namespace endmill
