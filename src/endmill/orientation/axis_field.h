// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/machine/kinematics.h"
#include "endmill/orientation/inclination.h"

/// \file
/// The axis field: an axis for each contact of a path, out of those that are allowed there,
/// so that the tool turns little.

namespace endmill {

/// The rules that a tool axis must keep, in the order in which they are tested.
enum class AxisRule {
    Range,       ///< lead and tilt within their ranges
    Curvature,   ///< no gouge beside the contact
    Strip,       ///< the strip is as wide as the passes need
    RearLead,    ///< the heel of the cutter is off the part
    Machine,     ///< the machine reaches the direction
    Visibility,  ///< the direction lies in the visibility cone
    Cutter,      ///< the gap between cutter and part
    Shank,       ///< the gap between part and shank or holder
};

/// The name of a rule in messages, such as "the gap of the cutter".
std::string_view axis_rule_name(AxisRule rule);

/// An axis at a contact after all tests.
struct JudgedAxis {
    std::optional<AxisRule> broken =
        {};                 ///< the first broken rule; nothing: it is allowed
    double lost_width = 0;  ///< share of the strip's width that it costs, 0 to 1
};

/// Tests an axis at a contact, by its number. It is called by several threads at once, and
/// its result depends on its arguments only. The ranges of lead and tilt are tested before.
using AxisJudge = std::function<JudgedAxis(std::size_t contact, const Vec3& axis,
                                           const Inclination& inclination)>;

/// A contact at which an axis is chosen.
struct FieldContact {
    CutterContact contact;     ///< point and unit normal
    Vec3 feed;                 ///< unit, tangent to the part
    double way_mm = 0;         ///< along the path from its start; it never decreases
    bool starts_pass = false;  ///< the tool is off the part before this contact
    Inclination wanted = {};   ///< the inclination with the widest strip
};

/// An interval of leads or tilts.
struct LeanRange {
    Angle from = Angle::degrees(-30);  ///< above -89 degrees
    Angle to = Angle::degrees(30);     ///< below 89 degrees, at least `from`
};

/// How a field is chosen.
struct AxisFieldOptions {
    LeanRange lead = {};  ///< leads of all axes
    LeanRange tilt = {};  ///< tilts of all axes
    /// Turn of the normal after which a layer follows.
    Angle layer_turn = Angle::degrees(2);
    /// Greatest turn of the axis between two layers of a pass.
    Angle greatest_turn = Angle::degrees(15);
    /// Cost in degrees of travel of a degree beside the wanted inclination, squared.
    double lean_weight = 2e-3;
    /// Cost in degrees of travel of a strip that loses its whole width.
    double width_weight = 5;
    int smoothing_rounds = 20;  ///< greatest number, at least 0
    /// If set, travel is that of the rotary axes of this machine.
    const PartOnMachine* machine = nullptr;
};

/// A field and what it costs.
struct AxisField {
    std::vector<Vec3> axes;  ///< unit, one for each contact; all are allowed
    std::size_t layers = 0;  ///< layers of the shortest path
    double path_cost = 0;    ///< degrees; cost of the shortest path through the layers
    double rough_bend = 0;  ///< sum of squared turns over way, before smoothing; rad^2/mm
    double smooth_bend = 0;  ///< the same after smoothing; never above `rough_bend`
    int rounds = 0;          ///< rounds of smoothing
};

/// The lead and tilt of an axis at a contact.
/// \pre the angle between axis and normal is below 90 degrees.
Inclination inclination_of(const Vec3& axis, const Vec3& normal, const Vec3& feed);

/// Whether lead and tilt are within their ranges, apart from rounding.
bool is_within(const AxisFieldOptions& options, const Inclination& inclination);

/// The candidates at a contact: directions of a grid that is fixed in space, about 81 within
/// the ranges, and the wanted inclination if it is within them. If a range is narrower than a
/// degree, they are 9 by 9 inclinations of the contact's own frame instead.
/// Source: docs/methods/five-axis-planning.md, section 5.
std::vector<Vec3> axis_candidates(const FieldContact& contact,
                                  const AxisFieldOptions& options);

/// Chooses an axis for each contact.
///
/// Layers are contacts after each turn of the normal, the ends of passes, and contacts at
/// which the axis on the great arc between two layers would not be allowed. The states of a
/// layer are its allowed candidates, with a machine each in both solutions. The shortest path
/// through all layers minimizes
///
///     sum of turns + lean_weight (lean - wanted)^2 + width_weight lost_width
///
/// over paths whose turns within passes are at most `greatest_turn`. Between layers the axis
/// moves on the great arc, in proportion to the way. Then rows of even and of odd numbers move
/// in turn towards the weighted mean of their neighbours, as far as they are allowed to.
///
/// The result does not depend on the number of threads.
/// Source: docs/methods/five-axis-planning.md, section 5.
/// \throws GeometryError if no candidate is allowed at a contact, with its place and the rule
///         that removed the last one; if no path has turns within the limit, with the place.
/// \throws DomainError for ranges or weights out of their domain, or contacts whose normal and
///         feed are not unit vectors at right angles.
AxisField axis_field(std::span<const FieldContact> contacts, const AxisJudge& judge,
                     const AxisFieldOptions& options);

}  // namespace endmill
