// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/offset/offset_mesh.h"
#include "endmill/offset/slicer.h"
#include "endmill/surface/surface.h"
#include "endmill/trimming/trimming_methods.h"

namespace endmill {

/// Trims the curves of every plane with `method`, on all threads, and clips the result to
/// the range of s over which the path stays over the part. A plane without a range keeps
/// nothing. Stretches outside the range get the rule `outside the range`. Folds that the
/// method left count as unresolved only if they lie inside the range.
/// \param planes sections of an offset mesh, one for each plane.
/// \param ranges as path_ranges returns them, one for each plane; empty: no clipping.
/// \param method one of trimming_methods().
/// \param options of the method.
/// \param progress if set, is called with the finished share, 0 to 1, by any thread.
/// \return one result for each plane. It does not depend on the number of threads.
/// \throws DomainError as the method does, and if the number of ranges is neither 0 nor
///     the number of planes.
std::vector<Trimmed> trim_planes(std::span<const PlaneSection> planes,
                                 std::span<const std::optional<Interval>> ranges,
                                 const TrimmingMethod& method,
                                 const TrimmingOptions& options,
                                 const std::function<void(double share)>& progress = {});

/// Clips trimmed sections to ranges of s, as trim_planes does.
/// \param planes the sections before trimming.
/// \param ranges one for each plane; empty: no clipping.
/// \param trimmed results of a method, one for each plane; they are changed.
/// \throws DomainError unless there are as many results as planes, and as many ranges or none.
void clip_planes(std::span<const PlaneSection> planes,
                 std::span<const std::optional<Interval>> ranges,
                 std::span<Trimmed> trimmed);

/// Sections without loops, such as those of a drop cutter, in the form of trimmed
/// sections. Every vertex is kept.
/// \return one result for each plane.
std::vector<Trimmed> untrimmed_planes(std::span<const PlaneSection> planes);

/// Trimmed sections whose curves are thinned, see `thinned` in section_curve.h: points are
/// dropped, and the chords that replace them stay within `tolerance`. Everything else is
/// unchanged.
/// \param trimmed one result for each plane.
/// \param tolerance in mm; 0: no point is dropped.
/// \param progress if set, is called with the finished share, 0 to 1, by any thread.
/// \throws DomainError as thinned.
std::vector<Trimmed> thinned_planes(
    std::span<const Trimmed> trimmed, double tolerance,
    const std::function<void(double share)>& progress = {});

/// The extent in z of all curves together, in mm; 0 without a curve.
double section_height(std::span<const PlaneSection> planes);

/// Default threshold of the scan of method 1, as a multiple of its step.
inline constexpr double scan_threshold_in_steps = 4;

/// Options for sections whose cutter is not known. Method 1 scans with a step of a thousandth of
/// their height.
/// \param height of the sections in mm, as section_height; at least 0.
TrimmingOptions default_trimming_options(double height);

/// The points of trimmed sections in space, in the order of planes, curves and points.
/// \param planes  the planes that cut the sections.
/// \param trimmed one result for each plane.
/// \throws DomainError unless there are as many results as planes.
std::vector<Vec3> section_points(const DrivePlanes& planes,
                                 std::span<const Trimmed> trimmed);

/// The origin of trimmed sections.
struct SectionSource {
    std::span<const Surface> surfaces;       ///< the surfaces of the part
    const OffsetMesh& offset;                ///< the offset of these surfaces
    const DrivePlanes& planes;               ///< the planes that sliced the offset
    std::span<const PlaneSection> sections;  ///< one for each plane
    /// If set, it is called with the finished share, 0 to 1, by any thread.
    std::function<void(double share)> progress = {};
};

/// Trimmed curves whose points were moved to where the cutter rests on the smooth part.
struct RefinedPlanes {
    std::vector<Trimmed> planes;  ///< one for each plane; its rules are unchanged
    std::size_t unrefined = 0;    ///< number of points that keep their sampled position
    /// Largest change of z in mm of a moved point. It is the sampling error at this
    /// point.
    double greatest_shift = 0;
};

/// Moves every point of trimmed sections to the height at which the cutter rests on the
/// smooth part over the point's s. The contact may be on a face, a border, a crease or a
/// corner; the highest one counts. A crossing moves along s to where two contacts are
/// equally high. Crossings that the sampling missed are inserted, and vertices between
/// the old and the new position of a crossing are removed.
///
/// Accuracy of a moved point in z: 1e-4 mm for every grid, and 1e-9 mm where N_z > 0.1 at
/// the contact; contacts whose depths differ by less than `rest_gouge` (tolerance.h)
/// count as equally high. Between points the path is straight; its chord error is c l^2 /
/// 8 for a chord of length l on a section of curvature c.
///
/// A point keeps its sampled position in three cases: it lies below the envelope of its
/// section, in a fold that a method left; the offset is vertical there (N_z = 0); or the
/// contact is on an edge or a corner and the offset was made without BoundaryContact.
/// Runs on all threads; the result does not depend on their number.
/// Source: docs/methods/interference.md, section 6.
/// \param source the part, its offset and the sections.
/// \param trimmed one result for each plane.
/// \return the planes with moved curves.
/// \throws DomainError unless there are as many results and planes as sections.
RefinedPlanes refine_planes(const SectionSource& source,
                            std::span<const Trimmed> trimmed);

/// Estimates the sampling error of trimmed sections: the largest change of z in mm that
/// refine_planes would make to a point.
/// \param source the part, its offset and the sections.
/// \param trimmed one result for each plane.
/// \throws DomainError unless there are as many results and planes as sections.
double sampling_error(const SectionSource& source, std::span<const Trimmed> trimmed);

/// The size of a trimming task.
struct TrimmingSize {
    std::size_t surfaces;  ///< number of sampled surfaces; 0 for a mesh part
    /// Samples along each parameter of a surface; for a mesh part, samples in each plane.
    int grid_lines;
    std::size_t planes;                                   ///< number of drive planes
    BoundaryContact boundary = BoundaryContact::Contact;  ///< see OffsetOptions
};

/// Upper estimate in bytes of the memory that the offset, its sections and their files
/// need together. It is right to a factor of two on one surface, with and without folds,
/// for grids of 20 to 9000 lines and 10 to 20 000 planes.
double trimming_bytes(const TrimmingSize& size);

/// Refuses a task before any work if half of trimming_bytes exceeds `memory_gib`.
/// \throws LimitError with the grid, the planes, the estimate and the limit.
void require_trimming_memory(const TrimmingSize& size, double memory_gib);

}  // namespace endmill
