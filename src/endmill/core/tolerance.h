// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace endmill {

/// \file
/// The tolerances that several files share, each with its unit and its reason. A
/// tolerance that only one file uses is defined in that file. None of them is an option:
/// options of the program have defaults of their own.

/// Largest difference from 1 of the length of a vector that was normalised in doubles,
/// and largest difference of two such vectors that count as equal. Rounding gives about
/// 1e-16; the margin allows for one or two rotations.
inline constexpr double unit_vector_rounding = 1e-12;

/// Length of the difference between a tool axis and +z, about the tilt in rad, up to
/// which material is removed along a path. Such a tilt moves a point 1 m above the tip by
/// 1e-6 mm, far below all other errors of the removal.
inline constexpr double removal_axis_tolerance = 1e-9;

/// Length of the difference between a tool axis and +z, about the tilt in rad, up to
/// which the cutting model accepts a path. It allows for components that a file rounds to
/// six decimals, and changes the slopes of the cuts by 1e-6 rad only.
inline constexpr double cutting_axis_tolerance = 1e-6;

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

/// Depth in mm up to which two bodies only touch: a cutter removes nothing, and shank and
/// holder do not collide with the stock. It absorbs the rounding of coordinates.
inline constexpr double touching_depth = 1e-9;

/// Slack in mm that is added to both limits of the deviation before a verdict. Otherwise a
/// path that is planned exactly to a limit would stay undecided.
/// Source: docs/methods/removal.md, section 3.
inline constexpr double verdict_slack = 0.001;

/// Depth in mm up to which a contact of shank or holder with the part is treated as
/// rounding. It covers the distance between the part and the triangles that approximate
/// it.
inline constexpr double part_contact_slack = 0.001;

/// Error in mm that rounding may cause in the height of a tip on a triangle: a fifth of
/// the accuracy of 1e-9 mm that the drop cutter promises.
inline constexpr double tip_accuracy = 2e-10;

/// Depth in mm by which the part may enter the cutter at a contact that counts as the
/// highest. It is far below the required accuracy of the height, 1e-4 mm, also at a
/// contact on a slope of 80 degrees.
inline constexpr double rest_gouge = 2e-6;

/// Distance, in widths of a patch, within which a point is moved to the end of its pass,
/// and a pass to the border. Without it, an interval that divides the width exactly would
/// need one more pass because of rounding.
/// Source: docs/methods/economic-cl-data.md, section 6.
inline constexpr double end_width = 1e-6;

/// Accuracy of the search for the smallest rectangle of poses: its area exceeds the least
/// area by at most this share of it, or of a square degree for smaller areas. It is far
/// below the effect of a cell's width of 0.1 rad.
inline constexpr double branch_accuracy = 1e-7;

/// Cosine of the angle between the normal of a facet and a direction that must be
/// exceeded for the facet to be accessible. A facet that is seen from its edge, closer to
/// 90 degrees than 1e-6 rad, is not accessible; the paper excludes 90 degrees.
inline constexpr double least_facing_cosine = 1e-6;

}  // namespace endmill
