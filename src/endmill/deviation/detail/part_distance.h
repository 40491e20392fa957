// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "endmill/deviation/detail/once.h"
#include "endmill/deviation/detail/surface_tree.h"
#include "endmill/deviation/part_charts.h"
#include "endmill/mesh/triangle_tree.h"

namespace endmill {

/// A straight way from a place of the part along its normal or against it.
struct PartWay {
    Vec3 foot;       ///< start on the part, mm
    Vec3 direction;  ///< unit
    double length;   ///< mm, positive
};

/// The largest ball, up to a given radius, that touches the part at a foot and contains
/// no place of it.
struct FreeBall {
    double length;  ///< radius, mm
    /// Place of the part that limits the ball, mm; none if none does.
    std::optional<Vec3> other;
};

/// Distances from the part: from a mesh itself, or from a triangulation of the surfaces
/// that is made only near the places of queries. It refers to the charts and their part,
/// which must outlive it. Queries may run on any number of threads.
class PartDistance {
public:
    /// \param charts of the part.
    /// \param chord_tolerance greatest distance of the triangulation from the surfaces,
    ///        mm.
    PartDistance(const PartCharts& charts, double chord_tolerance);

    /// Returns an upper bound of the distance in mm between `place` and the part. It is
    /// too large by at most `uncertainty()`.
    /// \param hint in and out: the piece of the part that is nearest. The value of a
    ///        query nearby makes the query faster and does not change its result.
    double operator()(const Vec3& place, std::optional<std::size_t>& hint) const;

    /// Whether no place of the part is nearer than `radius` mm, within the chord
    /// tolerance.
    bool is_clear(const Vec3& centre, double radius) const;

    /// Returns the largest ball that touches the part at the foot of a way, with its
    /// centre on the way, and contains no other place of the part. Up to its radius the
    /// foot is the nearest place of the part. A radius below the way's length is too
    /// small by at most `uncertainty()` plus rounding, and never too large.
    /// This is the shrinking-ball algorithm of [MaBaeChoi].
    /// \param hint as above.
    FreeBall free_ball(const PartWay& way, std::optional<std::size_t>& hint) const;

    /// Error bound of the distances in mm: at most twice the chord tolerance, 0 for a
    /// mesh.
    double uncertainty() const;

    /// Whether the vertical line through `place` meets the part, within the chord
    /// tolerance.
    bool is_over_or_under(const Vec3& place) const;

private:
    void prepare() const;
    const TriangleTree& whole() const;
    std::optional<NearestPoint> nearest(const Vec3& place,
                                        std::optional<std::size_t>& hint,
                                        double within) const;

    const PartCharts& charts_;
    double chord_tolerance_;
    mutable Once prepare_once_;
    mutable std::optional<SurfaceTree> surface_tree_;  // fine triangulation of surfaces
    mutable std::optional<SurfaceTree> coarse_tree_;
    mutable double chord_error_ = 0;
    mutable Once make_whole_once_;
    mutable TriangleMesh sampled_;
    mutable std::optional<TriangleTree> whole_;
};

}  // namespace endmill
