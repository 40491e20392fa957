// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace endmill {

/// \file
/// The tolerances that several files share, each with its unit and its reason. A
/// tolerance that only one file uses is defined in that file. None of them is an option:
/// options of the program have defaults of their own.

/// Largest difference from 1 of the length of a vector that was normalised in doubles.
/// Rounding gives about 1e-16; the margin allows for one or two rotations.
inline constexpr double unit_vector_rounding = 1e-12;

/// Largest difference from 1 of the length of a tool axis in a file. Components rounded
/// to four decimals leave up to 8.7e-5.
inline constexpr double axis_length_tolerance = 1e-4;

/// Sine of the angle between a unit normal and the tool axis up to which they count as
/// parallel. It is above the rounding of a normal, about 1e-16, and far below the angles
/// that any sampling of a surface resolves.
inline constexpr double level_normal = 1e-12;

/// Angle in rad between the normals of two patches up to which the surface is smooth (G1)
/// there. Control nets written with six decimals miss G1 by up to 4e-8 rad.
inline constexpr double smooth_angle = 1e-6;

/// Angle in rad by which a rotary axis may pass its limit. It is a thousand times the
/// rounding error of the angles of a direction, and moves a point at 1 km distance by 1
/// um.
inline constexpr double turn_tolerance = 1e-9;

/// Difference in rad up to which two angles of a setup are equal. The rounding error of
/// an angle of a few rad is about 1e-15, and a few angles are added. The resolution of a
/// rotary axis is about 1e-6 rad.
inline constexpr double equal_angles = 1e-9;

/// Width in rad below which an interval of angles is a single angle. Sums of angles in
/// doubles differ by about 1e-15.
inline constexpr double thinnest_angle = 1e-12;

/// Distance of control points up to which they are the same point, as a share of the size
/// of their patch or surface. Equal points differ by rounding only, about 1e-16.
inline constexpr double same_point_share = 1e-12;

/// Length of one partial derivative of a surface, as a share of the other one, up to
/// which it vanishes. The surface has a pole there, or the partial is too short for its
/// direction to be meaningful.
inline constexpr double vanishing_partial_share = 1e-10;

/// Width of an interval of a height grid, as a share of the grid's range, that is too
/// small. A spline over a narrower interval would consist of rounding errors.
inline constexpr double least_grid_interval = 1e-9;

/// Margin of the boxes of a search tree, as a share of the largest coordinate. It exceeds
/// the rounding error of a distance, so that the distance of a box never exceeds the
/// distance of its contents.
inline constexpr double box_margin_share = 1e-12;

/// Rounding error of a distance that a planner allows, as a share of the cutter's radius.
/// With it, a pass planned exactly to a limit satisfies the limit.
inline constexpr double radius_rounding_share = 1e-12;

/// Depth in mm up to which a cutter that just touches the part removes nothing. It
/// absorbs the rounding of coordinates.
inline constexpr double touching_depth = 1e-9;

}  // namespace endmill
