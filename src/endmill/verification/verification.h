// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "endmill/deviation/deviation.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"
#include "endmill/stock/removal.h"
#include "endmill/stock/stock_history.h"
#include "endmill/surface/part.h"
#include "endmill/verification/verification_result.h"
#include "endmill/verification/verification_task.h"

/// \file
/// Verification of a path: `verify_path` removes the material, measures the
/// deviation from the part and gives a verdict. The last four functions turn a path with
/// a fixed tilted axis and its part upright, because removal and measurement need the
/// axis +z.

namespace endmill {

/// Returns the block from which a path is cut if no stock is given.
///
/// With a part it is the part's bounding box, widened sideways by the cutter's radius,
/// from 1 mm below the lowest point of part and cutting tips to 1 mm above the part.
/// Without a part it is the box of the cutting tips, widened in the same way, up to the
/// highest tip. Cutting tips are both ends of cuts and links and the lower end of
/// plunges.
/// Source: docs/methods/removal.md, section 3.
/// \param part may be null.
/// \throws GeometryError if the part is empty, or if there is neither a part nor a
///         cutting tip.
Block default_block(const Part* part, const ToolPath& path, const Cutter& cutter);

/// Measures the deviation after a path that starts from the default block.
/// \param path tips along +z.
/// \throws DomainError for options out of range, GeometryError if an axis is not +z or
///         the part is empty, LimitError if the pitch gives too many cells.
Deviation deviation_in_block(const Part& part, const ToolPath& path, const Cutter& cutter,
                             const DeviationOptions& options);

/// Whether the planner has proved that a path keeps the limits of the deviation.
enum class LimitProof {
    None,         ///< nothing is known
    GougeProved,  ///< no gouge anywhere exceeds the limit
    Proved,       ///< no gouge and no remaining stock anywhere exceeds the limits
};

/// Options of `deviation_of_path`.
struct PathDeviationOptions {
    DeviationLimits limits = {};          ///< cells are refined until these are decided
    LimitProof proof = LimitProof::None;  ///< with a proof fewer cells are refined
    /// If set, it is called with the finished share, 0 to 1.
    std::function<void(double share)> progress = {};
    /// If set, remaining stock is judged only where it returns true, see DeviationOptions.
    /// The rays are those of the upright part.
    std::function<bool(const PartRay& ray)> is_accessible = {};
};

/// Measures the deviation that a path with any fixed axis leaves if it starts from the
/// default block. Part and path are turned upright first, so that places in the result
/// are those of the turned part. The pitch gives about 1e5 first rays on the area of the
/// part. A proof limits the error bounds; cells are then refined only where a greater
/// maximum may lie.
/// \param part    the part.
/// \param path    tips along one axis.
/// \param cutter  the shape that cuts.
/// \param options limits, proof and progress.
/// \throws DomainError for limits out of range, GeometryError if the axis changes or the
///         part is empty.
Deviation deviation_of_path(const Part& part, const ToolPath& path, const Cutter& cutter,
                            const PathDeviationOptions& options);

/// Returns the history of the stock that remains after `task`.
/// \return nothing if the history of the stock before the path is not known, or with five
///         axes.
std::optional<StockHistory> history_of_rest(const VerificationTask& task);

/// Returns the same with five axes.
/// \return nothing if the history of the stock before the path is not known, or with three
///         axes.
std::optional<TurningHistory> turning_history_of_rest(const VerificationTask& task);

/// Removes the material along the path and measures the deviation from the part.
///
/// If the history of the stock is known, the moves of earlier runs are measured together
/// with the moves of the path, by the same rays and bounds, as if all of them were one
/// path. A place that an earlier run made has the sweep number `by_earlier_run`. If only
/// the heights of a stock are known, the depth of a gouge in it counts as far as the
/// heights prove it. If the heights allow a gouge beyond the tolerance but do not prove
/// it, the verdict is `Undecided`.
///
/// A path may change its tool. The moves from a change on are those of the new tool.
///
/// The verdict is `Gouged`, or without a part `Collides`, if a rapid cuts, or if shank or
/// holder is in the stock or in the part. It is `Undecided` if shank or holder may be in the part.
/// With five axes every ray of the part and of the stock has bounds between which the truth
/// lies. The verdict is `Undecided` too if a rapid, shank or holder may be in the material.
/// Source: docs/methods/removal.md, section 3; docs/methods/five-axis-removal.md.
/// \throws GeometryError if the path cuts nothing over the part, with the gap between
///         cutter and part, if an axis is not +z with three axes, or if two neighbouring
///         axes are opposite with five.
/// \throws LimitError if the memory does not suffice, with a resolution that fits.
/// \throws DomainError if path or part is null, an option is out of range, or the changes
///         of the tool do not ascend within the path.
Verification verify_path(const VerificationTask& task);

/// Returns the unit axis that all points of `path` share; +z for a path without points.
/// \return nothing if the axis changes by more than 1e-12.
std::optional<Vec3> fixed_axis(const ToolPath& path);

/// Returns the rotation by the smallest angle that turns `axis` to +z; the identity for
/// +z.
/// \pre `axis` is a unit vector.
Eigen::Matrix3d upright_rotation(const Vec3& axis);

/// Returns the part rotated about the origin. Its tool side rotates with it.
Part turned(const Part& part, const Eigen::Matrix3d& rotation);

/// Returns the path rotated about the origin: tips, axes, contacts and normals.
ToolPath turned(const ToolPath& path, const Eigen::Matrix3d& rotation);

}  // namespace endmill
