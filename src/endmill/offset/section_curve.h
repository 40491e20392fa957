// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

namespace endmill {

/// A point of a section: s along the feed and z, in mm, of the cutter's reference point.
using SectionPoint = Eigen::Vector2d;

/// One connected curve of the section of an offset by a drive plane, folds and loops kept.
/// An open one runs from its end of smaller s, the tool on its left. A closed one keeps its
/// direction, begins where s is smallest (of equal ones where z is) and ends with that
/// point once more. No two consecutive points are equal, and there are two at least.
struct SectionCurve {
    std::vector<SectionPoint> points;
    bool is_closed = false;
};

}  // namespace endmill
