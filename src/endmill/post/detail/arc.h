// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "endmill/core/vec.h"

namespace endmill {

/// The plane of an arc.
enum class ArcPlane {
    Xy,  ///< G17
    Zx,  ///< G18
    Yz,  ///< G19
};

/// Indices of the coordinates of a plane in a Vec3. First, second and normal are
/// right-handed: an arc that is clockwise seen from +normal turns from the second axis to
/// the first. For G18 the order is therefore Z, X.
struct PlaneAxes {
    int first;   ///< 0, 1 or 2 for x, y or z
    int second;  ///< 0, 1 or 2
    int normal;  ///< 0, 1 or 2
};

/// The axes of `plane`.
PlaneAxes plane_axes(ArcPlane plane);

/// The arc or helix of a G2 or G3. In its plane it runs around `centre`; along the normal
/// it advances in proportion to the angle. If start and end have different distances from
/// the centre, the radius changes in proportion to the angle too.
struct Arc {
    Vec3 start;                     ///< mm
    Vec3 end;                       ///< mm
    Vec3 centre;                    ///< mm; the coordinate along the normal is ignored
    ArcPlane plane = ArcPlane::Xy;  ///< plane of the arc
    bool clockwise = true;  ///< sense, seen from the positive end of the plane's normal
    double turns = 1;       ///< whole number, at least 1: how often the end is reached
};

/// Distances of the start and the end of an arc from its centre, in its plane.
struct ArcRadii {
    double start;  ///< mm
    double end;    ///< mm

    double larger() const { return start > end ? start : end; }  ///< mm
};

/// The radii of `arc`.
ArcRadii arc_radii(const Arc& arc);

/// Angle of `arc` in rad: above 0, at most 2 pi per turn. Ends within 1e-8 mm of each
/// other in the plane make a full circle, so that the rounding of summed increments
/// cannot turn a circle into nothing. Error below 1e-15 rad per turn for the given ends.
/// \pre Both radii of `arc` are positive.
double arc_angle(const Arc& arc);

/// Centre of the arc with the ends of `arc` and a given radius; `arc.centre` is ignored.
/// It follows from the right triangle of an end, the middle of the ends and the centre.
/// \param arc ends, plane and sense.
/// \param radius mm, signed: negative for the arc of more than half a turn.
/// \param tolerance_mm mm, by which half the distance of the ends may exceed |radius|.
///        Within this tolerance the result is the middle of the ends.
/// \return std::nullopt if the ends are farther apart.
/// \pre The ends differ in the plane, and the radius is not 0.
std::optional<Vec3> centre_of_radius(const Arc& arc, double radius, double tolerance_mm);

/// The chords that replace an arc. Their ends lie on the arc at equal angles. Their
/// number is the smallest that keeps the chords within a tolerance of the arc.
class ArcChords {
public:
    /// The number of chords is the angle over 2 acos(1 - t / radius), rounded up, with
    /// the larger radius. A chord spans at most half a turn.
    /// \param arc the arc.
    /// \param tolerance_mm t in mm, above 0: largest distance of a chord from the arc.
    /// \pre Both radii of `arc` are positive.
    /// Source: sagitta of a chord; docs/methods/removal.md, section 5.
    ArcChords(const Arc& arc, double tolerance_mm);

    /// Number of chords: a whole number, at least 1. It may exceed the range of integers.
    double count() const { return count_; }

    /// End of chord `number`, counted from 1. The last end is the end of the arc itself.
    /// The others lie on the arc within 1e-15 of the radius and the centre's coordinates,
    /// and along the arc within 1e-15 of the distance from the start.
    Vec3 end(std::size_t number) const;

private:
    Arc arc_;
    ArcRadii radii_;
    double start_angle_;  // rad in the plane, from its first axis
    double angle_;        // rad, negative if clockwise
    double count_;
};

}  // namespace endmill
