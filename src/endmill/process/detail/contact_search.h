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
struct FootPlace {
    std::size_t surface;  ///< index of the surface
    double u;             ///< parameter
    double v;             ///< parameter
};

/// Foot point of a ball centre: the point of a part that is nearest to the centre.
struct BallFoot {
    FootPlace at;  ///< place of the foot
    Vec3 point;    ///< mm
    /// Unit vector from the foot to the centre. Where both coincide it is the normal of
    /// the surface on the tool's side.
    Vec3 normal;
    double distance;  ///< mm, from the foot to the centre; negative behind the part
};

/// Orthogonal projection of ball centres on surfaces. The search starts at a known place,
/// or at the nearest of many samples (16 by 16 per patch, fewer for very many patches).
/// It runs Newton's method on half the squared distance, with step halving, inside the
/// borders of one surface.
class ContactSearch {
public:
    /// \param surfaces the part; must outlive the search. The tool is on the upper side
    ///        of a surface unless the surface states otherwise.
    /// \throws DomainError if there is no surface.
    explicit ContactSearch(std::span<const Surface> surfaces);

    /// The foot of `centre`. The search starts from `near` if given. If the foot found
    /// there is not at `distance` within `tolerance`, it starts again from the nearest
    /// sample, and the foot whose distance is closer to the expected one is returned.
    /// \param centre mm.
    /// \param near start of the search.
    /// \param distance mm, expected distance of the foot.
    /// \param tolerance mm.
    /// Accurate to 1e-9 of the size of the part where the projection is regular.
    BallFoot foot(const Vec3& centre, const std::optional<FootPlace>& near,
                  double distance, double tolerance) const;

    std::size_t surfaces() const { return surfaces_.size(); }  ///< number of surfaces

    /// Normal curvature in 1/mm of the part at `place`, along the tangent vector nearest
    /// to `direction`; positive where the part is convex. std::nullopt where the surface
    /// is singular.
    std::optional<double> curvature(const FootPlace& place, const Vec3& direction) const;

private:
    BallFoot foot_from(const Vec3& centre, const FootPlace& start) const;

    std::span<const Surface> surfaces_;
    std::vector<double> sides_;      // sign of the normal on the tool's side, per surface
    std::vector<FootPlace> places_;  // places of the samples
    std::vector<Vec3> samples_;      // points of the samples, mm
    std::optional<PointTree> tree_;  // over the samples
};

}  // namespace endmill
