// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <mutex>
#include <optional>

#include "endmill/deviation/detail/part_cell.h"
#include "endmill/deviation/detail/sampled_pieces.h"
#include "endmill/mesh/triangle_tree.h"

namespace endmill {

/// A way from a place of the part.
struct PartWay {
    Vec3 foot;       ///< mm
    Vec3 direction;  ///< unit, along the normal or against it
    double length;   ///< mm, positive
};

/// The largest ball that touches the part at a foot, as far as it was asked for.
struct FreeBall {
    double length;              ///< its radius, mm
    std::optional<Vec3> other;  ///< place of the part that keeps it from growing, if met
};

/// Answers how far a place is from the part: a mesh itself, or a triangulation of the
/// surfaces, which is made where questions come. Refers to the charts and their
/// part, which must outlive it. May be asked by any number of threads.
class PartDistance {
public:
    /// \param chord_tolerance of the triangulation, in mm.
    PartDistance(const PartCharts& charts, double chord_tolerance);

    /// Distance in mm of `place` from the part, never less than it is, and more by at most
    /// `uncertainty()`. Sooner where `hint` is what the question for a place nearby left
    /// there.
    double operator()(const Vec3& place, std::optional<std::size_t>& hint) const;

    /// Whether no place of the part is nearer than `radius`, to the chord tolerance.
    bool is_clear(const Vec3& centre, double radius) const;

    /// How far one comes on a way while no other place of the part is nearer than its
    /// foot: the radius of the largest ball that touches the part there, at most the way's
    /// length. Not more, but less by at most `uncertainty()` and a little where it is less
    /// than the length. \param hint as above.
    /// Source: J. Ma, S. W. Bae, S. Choi, 3D medial axis point approximation using nearest
    /// neighbors and the normal field, 2012: balls that shrink.
    FreeBall free_ball(const PartWay& way, std::optional<std::size_t>& hint) const;

    /// mm; at most twice the chord tolerance, and 0 of a mesh.
    double uncertainty() const;

    /// Whether the upright line through `place` meets the part, to the chord tolerance.
    bool is_over_or_under(const Vec3& place) const;

private:
    void prepare() const;
    const TriangleTree& whole() const;
    std::optional<NearestPoint> nearest(const Vec3& place,
                                        std::optional<std::size_t>& hint,
                                        double within) const;

    const PartCharts& charts_;
    double chord_tolerance_;
    mutable std::once_flag is_prepared_;
    mutable std::optional<SampledPieces> pieces_;  // of surfaces
    mutable std::optional<SampledPieces> coarse_pieces_;
    mutable double chord_error_ = 0;
    mutable std::once_flag is_whole_made_;
    mutable TriangleMesh sampled_;
    mutable std::optional<TriangleTree> whole_;
};

}  // namespace endmill
