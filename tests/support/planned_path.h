// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "endmill/path/tool_path.h"

namespace endmill::test {

/// The points of `path` with a contact, grouped by pass. Points of lifts have none.
inline std::vector<std::vector<PathPoint>> passes_of(const ToolPath& path)
{
    std::vector<std::vector<PathPoint>> passes;
    for (const PathPoint& point : path.points) {
        if (!point.contact())
            continue;
        if (passes.empty() || passes.back().back().pass != point.pass)
            passes.emplace_back();
        passes.back().push_back(point);
    }
    return passes;
}

/// Swaps the surface parameters u and v of all contacts.
inline void swap_parameters(ToolPath& path)
{
    for (PathPoint& point : path.points)
        if (SurfaceContact* contact = std::get_if<SurfaceContact>(&point.known_contact))
            std::swap(contact->u, contact->v);
}

/// The contact point on the part; `point` must have a contact.
inline const Vec3& contact_point(const PathPoint& point)
{
    return point.contact()->contact.point;
}

/// Whether two paths are equal to the bit.
inline bool are_equal(const ToolPath& one, const ToolPath& other)
{
    const auto same_contact = [](const SurfaceContact& a, const SurfaceContact& b) {
        return a.u == b.u && a.v == b.v && a.contact.point == b.contact.point &&
               a.contact.normal == b.contact.normal;
    };
    if (one.points.size() != other.points.size())
        return false;
    for (std::size_t k = 0; k < one.points.size(); ++k) {
        const PathPoint& a = one.points[k];
        const PathPoint& b = other.points[k];
        if (a.pass != b.pass || a.point != b.point || a.move != b.move ||
            a.location.tip != b.location.tip || a.location.axis != b.location.axis ||
            (a.contact() == nullptr) != (b.contact() == nullptr) ||
            (a.contact() && !same_contact(*a.contact(), *b.contact())))
            return false;
    }
    return true;
}

}  // namespace endmill::test
