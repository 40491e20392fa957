// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/mesh/detail/point_tree.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A place on one of several surfaces.
struct PartPlace {
    std::size_t surface;
    double u;
    double v;
};

/// The point of a part that is nearest to the centre of a ball.
struct BallFoot {
    PartPlace at;
    Vec3 point;  ///< mm
    Vec3
        normal;  ///< unit, from the point to the centre, or the surface's on the tool's side
                 /// < where they coincide
    double distance;  ///< mm, from the point to the centre; negative behind the part
};

/// Projects centres onto surfaces by Newton's method with descent, kept within the
/// surfaces' borders, from a place that is known or the nearest of many samples (16 by 16
/// a patch, fewer of very many patches).
class ContactSearch {
public:
    /// \param surfaces on whose upper side the tool is unless they say otherwise; they
    ///        must outlive the search. \throws DomainError if there are none.
    explicit ContactSearch(std::span<const Surface> surfaces);

    /// The foot of `centre`, searched from `near` if the one found there is at `distance`
    /// within `tolerance` (mm); else from the nearest sample, and then whichever of both
    /// is nearer to that distance. Its place is good to 1e-9 of the part's size where the
    /// projection is regular.
    BallFoot foot(const Vec3& centre, const std::optional<PartPlace>& near,
                  double distance, double tolerance) const;

    std::size_t surfaces() const { return surfaces_.size(); }  ///< their number

    /// Normal curvature in 1/mm of the part at `place`, along the tangent vector nearest
    /// to `direction`, positive where convex; none where the surface is singular.
    std::optional<double> curvature(const PartPlace& place, const Vec3& direction) const;

private:
    BallFoot foot_from(const Vec3& centre, const PartPlace& start) const;

    std::span<const Surface> surfaces_;
    std::vector<double> sides_;
    std::vector<PartPlace> places_;  // of the samples
    std::vector<Vec3> samples_;
    std::optional<PointTree> tree_;
};

}  // namespace endmill
