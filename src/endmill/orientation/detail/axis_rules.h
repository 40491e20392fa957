// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "endmill/cutter/cutting_body.h"
#include "endmill/cutter/tool.h"
#include "endmill/orientation/axis_field.h"
#include "endmill/orientation/detail/contact_cones.h"
#include "endmill/orientation/detail/tool_clearance.h"

namespace endmill {

/// A contact as the rules of its axis need it.
struct RuledContact {
    CutterContact contact;       ///< point and unit normal
    ContactCurvature curvature;  ///< of the part, along the feed and across
    double needed_strip_mm = 0;  ///< least width of the strip
    double wanted_strip_mm = 0;  ///< that of the wanted inclination, positive
    /// From AxisRules::prepare; it makes tests of several axes faster.
    std::optional<ToolClearance::Front> front = {};
    /// From AxisRules::prepare; nothing if the part hides no direction near an axis within the
    /// greatest lean, or without visibility cones.
    std::optional<ContactCones::Hidden> hidden = {};
};

/// What a tool axis must keep, apart from the contact.
struct RuledTool {
    Cutter cutter;
    std::vector<ToolCylinder> body = {};  ///< shank and holder
    double scallop_height = 0.05;         ///< mm, that a strip keeps
    double deepest_gouge = 0;             ///< mm
    /// mm, how much closer to the part than at a row the tool may be between two rows.
    double spare_gap = 0;
    Angle rear_lead = Angle::radians(0);       ///< least lead of a cutter that is no ball
    const PartOnMachine* machine = nullptr;    ///< that reaches the direction, if set
    Angle greatest_lean = Angle::degrees(89);  ///< of all axes against the normal
};

/// The rules of the axes of one tool and one part. Tests may run on several threads.
class AxisRules {
public:
    /// \param clearance of the part; it must outlive the rules.
    /// \param cones     of the part, likewise; null: visibility is no rule.
    AxisRules(const RuledTool& tool, const ToolClearance& clearance,
              const ContactCones* cones = nullptr);

    /// Finds the front of the part at a contact, and its hidden cells.
    void prepare(RuledContact& at) const;

    /// The first rule that an axis at a contact breaks, if any. Visibility is tested at prepared
    /// contacts only.
    JudgedAxis judge(const RuledContact& at, const Vec3& axis,
                     const Inclination& inclination) const;

    /// Whether cutter, shank and holder are clear of the part at a location between two rows.
    bool is_clear(const CutterLocation& location) const;

    /// The gap between cutter and part in mm, at most `enough`.
    double cutter_gap(const CutterLocation& location, double enough) const;

private:
    bool is_reached(const Vec3& axis) const;
    double least_gap() const { return tool_.spare_gap - tool_.deepest_gouge; }
    bool is_cutter_clear(const RuledContact& at, const ToolFrame& frame) const;
    bool is_body_clear(const ToolFrame& frame, double least) const;

    RuledTool tool_;
    const ToolClearance& clearance_;
    const ContactCones* cones_;
    CuttingBody cutter_;
    std::vector<CuttingBody> body_;
};

}  // namespace endmill
