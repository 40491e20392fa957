// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_arc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace endmill {
namespace {

constexpr std::array centre_letters{'I', 'J', 'K'};
constexpr std::string_view centre_words = "IJK";

}  // namespace

// A program rounds the ends and the centre of an arc separately, so the radii differ. The
// relative part serves large arcs, whose R or centre is stated with fewer significant
// digits.
double radius_tolerance(double radius_mm)
{
    constexpr double least_mm = 0.01;
    constexpr double part = 0.001;
    return std::max(least_mm, part * radius_mm);
}

// The conditions are negated so that NaN fails them.
void check_radii(const Arc& arc, const TextLines& lines)
{
    const ArcRadii radii = arc_radii(arc);
    if (!(radii.start > 0 && radii.end > 0))
        throw lines.complaint("an arc of radius 0", "a centre away from its ends");
    if (!(std::abs(radii.start - radii.end) <= radius_tolerance(radii.start)))
        throw lines.complaint("radii of " + brief(radii.start) +
                                  " mm at the arc's start and " + brief(radii.end) +
                                  " mm at its end",
                              "a difference of at most 0.01 mm or 0.1 %");
}

// The caller checks the words also of an arc that is left out because its start is
// unknown: whether a program is correct does not depend on where its path begins.
void ArcReader::check_words() const
{
    const bool has_centre = block_.has_any(centre_words);
    if (has_centre && block_.has('R'))
        throw lines_.complaint("an arc with both a centre and R", "either of them");
    if (!has_centre && !block_.has('R'))
        throw lines_.complaint("an arc without centre or R", "I, J, K or R");
    const double turns = block_.has('P') ? block_.value('P') : 1;
    if (!(turns >= 1 && turns == std::floor(turns)))
        throw lines_.complaint("an arc of P" + brief(turns) + " turns",
                               "a whole number from 1");
    if (!has_centre)
        return;
    const PlaneAxes axes = plane_axes(modes_.plane);
    if (block_.has(centre_letters[axes.normal]))
        throw lines_.complaint(std::string{"word "} + centre_letters[axes.normal] +
                                   " across the arc's plane",
                               "a centre in the plane of G17, G18 or G19");
    const bool is_absolute = modes_.centres == DistanceMode::Absolute;
    for (const int axis : {axes.first, axes.second})
        if (is_absolute && !block_.has(centre_letters[axis]))
            throw lines_.complaint(
                std::string{"no "} + centre_letters[axis] + " under G90.1",
                "both words of an absolute centre");
}

Arc ArcReader::arc(const Vec3& start, const Vec3& end) const
{
    Arc arc{.start = start,
            .end = end,
            .centre = start,
            .plane = modes_.plane,
            .clockwise = modes_.motion == GcodeMotion::ClockwiseArc,
            .turns = block_.has('P') ? block_.value('P') : 1};
    arc.centre = block_.has('R') ? centre_of_r(arc) : centre_of_words(arc);
    check_radii(arc, lines_);
    return arc;
}

double ArcReader::length(char letter) const
{
    const double value = block_.value(letter) * modes_.mm_per_unit();
    check_extent(value, max_extent_mm_, lines_);
    return value;
}

// A missing word is an offset of 0 from the start. (Absolute centres need both words.)
Vec3 ArcReader::centre_of_words(const Arc& ends) const
{
    const PlaneAxes axes = plane_axes(ends.plane);
    Vec3 centre = ends.start;
    for (const int axis : {axes.first, axes.second}) {
        const char letter = centre_letters[axis];
        const double value = block_.has(letter) ? length(letter) : 0;
        const double origin =
            modes_.centres == DistanceMode::Absolute ? 0 : ends.start[axis];
        centre[axis] = value + origin;
    }
    return centre;
}

// If the ends coincide, the centre is not determined by R.
Vec3 ArcReader::centre_of_r(const Arc& ends) const
{
    const double radius = length('R');
    const PlaneAxes axes = plane_axes(ends.plane);
    if (ends.start[axes.first] == ends.end[axes.first] &&
        ends.start[axes.second] == ends.end[axes.second])
        throw lines_.complaint("a full circle by R", "its centre: I, J, K");
    const double tolerance = radius_tolerance(std::abs(radius));
    const auto centre =
        radius == 0 ? std::nullopt : centre_of_radius(ends, radius, tolerance);
    if (!centre)
        throw lines_.complaint(
            "a radius R" + brief(block_.value('R')) + " that is too small",
            "at least half the distance of the arc's ends");
    return *centre;
}

}  // namespace endmill
