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

/// Which coordinates of a Vec3 are those of a plane, so that first, second and normal are
/// right-handed: an arc that is clockwise seen from +normal turns from second to first.
/// G18 is therefore Z, X, and not X, Z.
struct PlaneAxes {
    int first;   ///< 0, 1 or 2 for x, y or z
    int second;  ///< the same
    int normal;  ///< the same
};

/// The axes of `plane`.
PlaneAxes plane_axes(ArcPlane plane);

/// An arc, or a helix: what G2 and G3 mean. In the plane it goes around `centre`, along
/// the normal evenly with the angle. If start and end lie at different distances from
/// the centre, the radius changes evenly with the angle.
struct Arc {
    Vec3 start;   ///< mm
    Vec3 end;     ///< mm
    Vec3 centre;  ///< mm; the coordinate along the normal does not matter
    ArcPlane plane = ArcPlane::Xy;
    bool clockwise = true;  ///< seen from the positive end of the plane's normal
    double turns = 1;       ///< whole number: so many times is the end reached
};

/// Distances of an arc's start and end from its centre, in the plane, in mm.
struct ArcRadii {
    double start;  ///< mm
    double end;    ///< mm

    double larger() const { return start > end ? start : end; }  ///< mm
};

/// The radii of `arc`.
ArcRadii arc_radii(const Arc& arc);

/// The angle that `arc` passes, in rad: above 0, up to 2 pi a turn. Start and end within
/// 1e-8 mm of each other, in the plane, are a full circle: the rounding of sums of
/// incremental words must not make it vanish. Within 1e-15 rad a turn for the given ends.
/// \pre both radii of `arc` are positive.
double arc_angle(const Arc& arc);

/// The centre of the arc with the given ends, in place of whatever `arc.centre` is.
/// \param radius in mm, signed: negative for the arc of more than half a turn.
/// \return none if the ends are farther apart than twice the radius by more than
///         `tolerance_mm`; up to there it is half a circle of the radius that fits.
/// \pre the ends differ in the plane, radius != 0
/// Source: the triangle of both ends and the centre.
std::optional<Vec3> centre_of_radius(const Arc& arc, double radius, double tolerance_mm);

/// The chords that stand for an arc: ends on the arc, evenly spread over its angle, as
/// few as keep within a distance of it.
class ArcChords {
public:
    /// \param tolerance_mm t > 0: the number of chords is the angle over
    ///        2 acos(1 - t / radius), rounded up, for the larger radius.
    ///        A chord spans at most half a turn.
    /// Source: the sagitta of a chord; spec of the removal, section 5.
    /// \pre both radii of `arc` are positive.
    ArcChords(const Arc& arc, double tolerance_mm);

    double count() const { return count_; }  ///< whole number, at least 1, maybe huge

    /// The end of chord `number`, from 1; that of the last is the arc's end itself. The
    /// others are on the arc within 1e-15 of the radius and the centre's coordinates, and
    /// along it within 1e-15 of the way from the start.
    Vec3 end(std::size_t number) const;

private:
    Arc arc_;
    ArcRadii radii_;
    double start_angle_;  // in the plane, from its first axis
    double angle_;        // negative if clockwise
    double count_;
};

}  // namespace endmill
