// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/field_passes.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/tolerance.h"
#include "endmill/orientation/axis_field.h"

namespace endmill {
namespace {

// Share of the inner tolerance by which the tool may be closer to the part between two rows.
constexpr double spare_share = 0.25;

Angle mean(const Angle& a, const Angle& b)
{
    return Angle::radians((a.radians() + b.radians()) / 2);
}

// The greatest angle between axis and normal within the ranges.
Angle greatest_lean(const AxisFieldOptions& options)
{
    const auto most = [](const LeanRange& range) {
        return std::max(std::abs(std::tan(range.from.radians())),
                        std::abs(std::tan(range.to.radians())));
    };
    return Angle::radians(std::atan(std::hypot(most(options.lead), most(options.tilt))));
}

class FieldPasses {
public:
    FieldPasses(const FieldTask& task, std::vector<PassRows>& passes)
        : task_{task},
          field_{task.options.field},
          passes_{passes}
    {
        rules_.reserve(task.parts.size());
        for (const OrientedPart* surface : task.parts)
            rules_.emplace_back(
                RuledTool{.cutter = task.cutter,
                          .body = task.options.tool_body,
                          .scallop_height = task.options.scallop_height,
                          .deepest_gouge = task.options.inner_tolerance,
                          .spare_gap = spare_share * task.options.inner_tolerance,
                          .rear_lead = surface->rear_lead(),
                          .machine = field_.machine,
                          .greatest_lean = greatest_lean(field_)},
                task.clearance, task.cones);
    }

    void choose_axes()
    {
        std::vector<FieldContact> contacts;
        std::vector<RuledContact> ruled;
        std::vector<const AxisRules*> rules;
        double way = 0;
        const PassPose* last = nullptr;
        for (const PassRows& pass : passes_)
            for (const PassPose& row : pass.rows) {
                const bool is_first = &row == &pass.rows.front();
                // a link is longer by the lift
                if (last)
                    way +=
                        contact_way(*last, row) + (is_first ? task_.cutter.radius() : 0);
                last = &row;
                contacts.push_back({row.place.at.contact, row.place.feed, way, is_first,
                                    row.inclination});
                ruled.push_back(surface_of(pass).ruled(row.place, pass.line));
                rules.push_back(&rules_of(pass));
            }
        parallel_for(ruled.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                rules[k]->prepare(ruled[k]);
        });
        const AxisField field = axis_field(
            contacts,
            [&](std::size_t k, const Vec3& axis, const Inclination& inclination) {
                return rules[k]->judge(ruled[k], axis, inclination);
            },
            field_);
        std::size_t next = 0;
        for (PassRows& pass : passes_)
            for (PassPose& row : pass.rows)
                row = posed(surface_of(pass), row, field.axes[next++]);
    }

    // Inserts rows into all passes.
    // \return the least gap.
    double fill()
    {
        const double most = task_.cutter.radius();
        std::vector<double> gaps(passes_.size(), most);
        parallel_for(passes_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                PassRows& pass = passes_[k];
                pass.rows = filled(pass);
                for (const PassPose& row : pass.rows)
                    gaps[k] = rules_of(pass).cutter_gap(row.location, gaps[k]);
            }
        });
        return gaps.empty() ? most : *std::ranges::min_element(gaps);
    }

private:
    const AxisRules& rules_of(const PassRows& pass) const { return rules_[pass.surface]; }
    const OrientedPart& surface_of(const PassRows& pass) const
    {
        return *task_.parts[pass.surface];
    }

    // The pose with an axis. If that is the axis of the wanted pose, the inclination is kept, which
    // else would be rounded.
    static PassPose posed(const OrientedPart& surface, const PassPose& wanted,
                          const Vec3& axis)
    {
        return (axis - wanted.location.axis).norm() <= unit_vector_rounding
                   ? wanted
                   : surface.posed(wanted.place, axis);
    }

    std::vector<PassPose> filled(const PassRows& pass) const
    {
        const OrientedPart::Between between{
            [&](const PassPose& from, const PassPose& to) {
                return pose_between(pass, from, to);
            },
            [&](const ToolMotion& motion) {
                return rules_of(pass).is_clear(motion.location(0.5));
            }};
        return surface_of(pass).with_rows_between(pass.rows, pass.line, between);
    }

    // The pose halfway between two rows: on the great arc, with the mean inclination, or with
    // the allowed candidate nearest to the arc.
    PassPose pose_between(const PassRows& pass, const PassPose& from,
                          const PassPose& to) const
    {
        const OrientedPart& surface = surface_of(pass);
        const PassPlace place = surface.place_between(from, to, pass.line);
        const CutterContact& contact = place.at.contact;
        const PassPose wanted = surface.posed(place, surface.inclination_at(place));
        RuledContact ruled = surface.ruled(place, pass.line);
        rules_of(pass).prepare(ruled);
        const auto is_allowed = [&](const Vec3& axis) {
            const Inclination at = inclination_of(axis, contact.normal, place.feed);
            return axis.dot(contact.normal) > 0 && is_within(field_, at) &&
                   !rules_of(pass).judge(ruled, axis, at).broken;
        };
        const Vec3 arc = axis_on_arc(from.location.axis, to.location.axis, 0.5);
        if (is_allowed(arc))
            return posed(surface, wanted, arc);
        std::vector<Vec3> candidates =
            axis_candidates({contact, place.feed, 0, false, wanted.inclination}, field_);
        std::ranges::stable_sort(candidates, [&](const Vec3& a, const Vec3& b) {
            return a.dot(arc) > b.dot(arc);
        });
        candidates.insert(
            candidates.begin(),
            inclined_axis(contact.normal, place.feed,
                          {mean(from.inclination.lead, to.inclination.lead),
                           mean(from.inclination.tilt, to.inclination.tilt)}));
        const auto found = std::ranges::find_if(candidates, is_allowed);
        if (found == candidates.end())
            throw GeometryError{
                "no tool axis is allowed at " + surface.name_of(place) +
                ", between two rows of a pass; expected wider ranges of lead and tilt "
                "(--lead-range, --tilt-range)"};
        return posed(surface, wanted, *found);
    }

    const FieldTask& task_;
    const AxisFieldOptions& field_;
    std::vector<PassRows>& passes_;
    std::vector<AxisRules> rules_;
};

}  // namespace

double turn_by_field(const FieldTask& task, std::vector<PassRows>& passes)
{
    FieldPasses field{task, passes};
    field.choose_axes();
    return field.fill();
}

}  // namespace endmill
