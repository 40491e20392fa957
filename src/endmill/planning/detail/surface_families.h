// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "endmill/planning/detail/translational_tables.h"

/// \file
/// Families of surfaces of the size of the paper's part, 200 by 120 mm, in 3 by 2 bicubic patches
/// that join with one tangent. Each is described by a list of values.

namespace endmill {

/// A family. A(u) is a curve over x, B(v) one over y.
enum class SurfaceFamily {
    Translational,  ///< A(u) + B(v), control points at equal distances in x and y
    Uneven,         ///< the same with free distances
    Skew,           ///< the same with A leaving the xz plane and B the yz plane
    Symmetric,      ///< the first with A and B symmetric about their middle
    Tens,           ///< the first with heights in multiples of 10 mm
    Swept,          ///< A(u) c(v) + B(v), where c grows linearly from 1
    Ferguson,       ///< points and first derivatives at the corners of patches, no twists
    Net,            ///< free heights of a regular net
    Revolution,     ///< a curve over x turned about an axis along x: a control
    Ruled,          ///< straight lines between two curves over x: a control
};
inline constexpr std::array surface_families{
    SurfaceFamily::Translational, SurfaceFamily::Uneven, SurfaceFamily::Skew,
    SurfaceFamily::Symmetric,     SurfaceFamily::Tens,   SurfaceFamily::Swept,
    SurfaceFamily::Ferguson,      SurfaceFamily::Net,    SurfaceFamily::Revolution,
    SurfaceFamily::Ruled};  ///< all of them

/// Such as "translational".
std::string_view family_name(SurfaceFamily family);

/// The family of that name. \throws DomainError if there is none.
SurfaceFamily family_named(std::string_view name);

/// The ranges of the values: mm for heights and offsets, mm per mm for slopes of a Ferguson
/// surface in units of a third of a patch, shares for c, rad for the angle of Revolution.
std::vector<Interval> value_ranges(SurfaceFamily family);

/// A surface, as two curves if it is translational.
using FamilyMember = std::variant<TranslationalSurface, Surface>;

/// The surface of `values`. \pre there are as many values as ranges.
FamilyMember family_surface(SurfaceFamily family, std::span<const double> values);

/// The same as a surface.
Surface as_surface(const FamilyMember& surface);

/// Computes the 18 runs until `visit` returns false, see visit_runs of a translational surface. Other
/// surfaces are planned by `table_plan`; `passes_real` is then 0, and `policies` must have
/// IntervalArithmetic::Exact and no `points_of_first_pass`.
bool visit_runs(const FamilyMember& surface, const RunPolicies& policies,
                const std::function<bool(const RunPlace&, const TableRun&)>& visit);

}  // namespace endmill
