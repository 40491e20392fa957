// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/offset/slicer.h"
#include "endmill/trimming/trimming.h"

/// \file
/// Errors of trimmed curves, measured without the trimming methods.
///
/// Implemented in `trimming_quality.cpp` and `curve_differences.cpp`.

namespace endmill {

/// The errors of a trimmed result with respect to the upper envelope of the curves that
/// were trimmed.
struct TrimmingQuality {
    double step_back_mm = 0;  ///< longest step back in s between neighbouring points
    /// Largest depth of a point below the envelope, measured normal to the point's
    /// segment: (envelope(s) - z) |ds| / length, at both ends and at the midpoint of every
    /// segment. At a step of the envelope, its one-sided limit from inside the segment is
    /// used. A segment that begins at the foot of a step therefore has depth 0 there.
    double gouge_mm = 0;
    /// Uncovered length in s, as a share (0 to 1) of the length in s that the open curves
    /// cover together between their ends. Only tails run outside these intervals, and a
    /// method may cut tails off.
    double uncovered = 0;
};

/// Step back in mm that rounding causes on sections of a part, with coordinates of some
/// 100 mm.
inline constexpr double step_back_on_parts_mm = 1e-10;

/// The errors up to which a result counts as right.
struct TrimmingTolerance {
    double step_back_mm = 1e-12;  ///< rounding of coordinates of about 10 mm
    double gouge_mm = 0;          ///< see TrimmingQuality
    double uncovered = 0;         ///< a share between 0 and 1
};

/// Measures the errors of `trimmed` from the segments of `curves` alone. It shares no
/// code with the trimming methods, the exact ones included. For each segment of the
/// result it visits the segments over its ends and its midpoint, which takes about n log
/// n steps for n segments unless many of them are long.
/// \param curves of one plane. \pre they satisfy the rules of SectionCurve and are
///     finite.
/// \param trimmed the result of a method for these curves.
TrimmingQuality trimming_quality(std::span<const SectionCurve> curves,
                                 const Trimmed& trimmed);

/// Depth in mm of the interference that each plane's curves have before trimming: their
/// largest depth below their own upper envelope, as TrimmingQuality::gouge_mm measures it;
/// 0 without a loop. Computed on all threads; does not depend on their number.
/// \pre the curves satisfy the rules of SectionCurve and are finite.
std::vector<double> interference_depths(std::span<const PlaneSection> planes);

/// Whether all errors of `quality` are within `tolerance`.
bool is_right(const TrimmingQuality& quality, const TrimmingTolerance& tolerance);

/// Comparison of the trimmed sections of several planes with their upper envelopes.
struct EnvelopeComparison {
    std::size_t wrong = 0;    ///< sections that step back or lie too far below
    double max_gouge_mm = 0;  ///< largest TrimmingQuality::gouge_mm of all sections
};

/// Compares trimmed sections with the upper envelopes of their curves, on all threads. A
/// section is wrong if it lies deeper than `tolerance` below its envelope, or steps back
/// by more than the rounding of coordinates. The result does not depend on the number of
/// threads.
/// \param planes    the sections before trimming, one for each plane.
/// \param trimmed   one result for each plane.
/// \param tolerance in mm.
/// \throws DomainError unless there are as many results as planes.
EnvelopeComparison compare_with_envelope(std::span<const PlaneSection> planes,
                                         std::span<const Trimmed> trimmed,
                                         double tolerance);

/// How the trimmed curves of one plane differ from the exact result for the same curves.
struct CurveDifference {
    /// Largest distance between the two results: of a vertex, or of the midpoint of a
    /// segment, of either result from the other one. If one of them has no curve, it is
    /// the diagonal of the other one's bounding box.
    double distance_mm = 0;
    SectionPoint place{0, 0};  ///< s and z in mm of the point with this distance
    double below_mm = 0;       ///< TrimmingQuality::gouge_mm: depth below the envelope
    double step_back_mm = 0;   ///< TrimmingQuality::step_back_mm
    /// Length in s that the exact result covers and this one does not, between the ends
    /// of the open curves. Only tails run outside, and a method may cut tails off.
    double lost_mm = 0;
};

/// Compares the results of a method with those of an exact one, on all threads. Points
/// that both results contain are not measured, so that the work depends on the length of
/// the differences. The result does not depend on the number of threads.
/// \param planes  the sections before trimming, one for each plane.
/// \param exact   one result for each plane, such as that of the method `envelope`.
/// \param trimmed one result for each plane.
/// \return one difference for each plane.
/// \throws DomainError unless there are as many results of both kinds as planes.
std::vector<CurveDifference> differences_from_exact(std::span<const PlaneSection> planes,
                                                    std::span<const Trimmed> exact,
                                                    std::span<const Trimmed> trimmed);

/// Whether a result is right by the exact one: it does not step back by more than
/// rounding, lies at most `tolerance` below the envelope, and loses at most `tolerance`
/// of the path.
/// \param tolerance in mm.
bool is_right(const CurveDifference& difference, double tolerance);

}  // namespace endmill
