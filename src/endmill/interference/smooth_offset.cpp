// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/smooth_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "endmill/interference/offset_jet.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// A solution lies in the cell where it was sampled, or in one next to it.
constexpr double reach_in_cells = 2.5;
constexpr double turn_reach = 0.2;  // rad, wider than the steps in which arcs are sampled
// Of a cell, from its border: where the patch is looked up that serves the border.
constexpr double inside_share = 1e-3;
// Of a unit normal along an edge that it is turned about: rounding, where it is a corner
// much more.
constexpr double least_lean = 1e-7;

double component(const SurfacePoint& at, Parameter along)
{
    return along == Parameter::U ? at.u : at.v;
}

// The range that a triangle covers of a parameter.
struct Covered {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void take(double value) { low = std::min(low, value), high = std::max(high, value); }
};

// The patch that serves `parameter`; beyond the cell the one that serves its border, as
// there may be a crease.
int patch_near(const Surface& surface, Parameter along, double parameter,
               const Covered& cell)
{
    const double inside = inside_share * (cell.high - cell.low);
    return surface.patch_number(
        along, std::clamp(parameter, cell.low + inside, cell.high - inside));
}

// A line of a surface between its patches or along its border, about which normals turn.
class EdgeLine {
public:
    EdgeLine(const Surface& surface, double side, Parameter along, const SurfacePoint& at)
        : surface_{&surface},
          side_{side},
          along_{along},
          across_{along == Parameter::U ? Parameter::V : Parameter::U},
          line_{component(at, across_)}
    {
    }

    bool holds(const SurfacePoint& at) const { return component(at, across_) == line_; }

    SurfaceJet jet(double e) const
    {
        return along_ == Parameter::U ? surface_->jet(e, line_) : surface_->jet(line_, e);
    }

    // The contact's normal as a turn about the line, in rad; nothing if this is no line
    // between patches, or the normal leans along it, as over a corner.
    std::optional<double> turn(const OffsetContact& contact) const
    {
        if (!std::ranges::binary_search(surface_->breaks(across_), line_))
            return std::nullopt;
        const SurfaceJet at = jet(component(contact.at, along_));
        const SurfaceTangents tangents{at.point, at.du, at.dv};
        if (is_singular(tangents))
            return std::nullopt;
        const Vec3 normal = side_ * unit_normal(tangents);
        const Vec3 tangent = (along_ == Parameter::U ? at.du : at.dv).normalized();
        if (std::abs(contact.normal.dot(tangent)) > least_lean)
            return std::nullopt;
        return std::atan2(contact.normal.dot(tangent.cross(normal)),
                          contact.normal.dot(normal));
    }

private:
    const Surface* surface_;
    double side_;
    Parameter along_;
    Parameter across_;
    double line_;
};

}  // namespace

SmoothOffset::SmoothOffset(const OffsetMesh& offset, std::span<const Surface> surfaces,
                           int grid_lines)
    : offset_{offset},
      surfaces_{surfaces},
      sides_{tool_side_signs(surfaces, Vec3::UnitZ())},
      grid_lines_{grid_lines}
{
}

std::optional<SheetStart> SmoothOffset::start(const CrossedEdge& edge, double share,
                                              std::int32_t third) const
{
    for (const std::int32_t vertex : {edge.below, edge.above, third}) {
        const OffsetContact& contact = offset_.contacts[vertex];
        if (contact.kind != ContactKind::Face)
            return strip_start(edge, share, vertex);
    }
    return face_start(edge, share, third);
}

Eigen::Vector2d SmoothOffset::cell(const Surface& surface) const
{
    return Eigen::Vector2d{surface.range(Parameter::U).length(),
                           surface.range(Parameter::V).length()} /
           (grid_lines_ - 1);
}

// Of vertices on a seam the contact may be that of the other surface: the place is then
// that of the rest.
std::optional<SheetStart> SmoothOffset::face_start(const CrossedEdge& edge, double share,
                                                   std::int32_t third) const
{
    const auto& contacts = offset_.contacts;
    const std::int32_t number = contacts[third].surface == contacts[edge.above].surface
                                    ? contacts[third].surface
                                    : contacts[edge.below].surface;
    Covered u;
    Covered v;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // weighted, and the weight
    const auto take = [&](std::int32_t vertex, double weight) {
        const OffsetContact& contact = contacts[vertex];
        if (contact.surface != number)
            return;
        u.take(contact.at.u);
        v.take(contact.at.v);
        place += weight * Eigen::Vector3d{contact.at.u, contact.at.v, 1};
    };
    take(edge.below, 1 - share);
    take(edge.above, share);
    take(third, place.z() > 0 ? 0 : 1);
    if (!(place.z() > 0))
        return std::nullopt;
    const Surface& surface = surfaces_[static_cast<std::size_t>(number)];
    const double side = sides_[static_cast<std::size_t>(number)];
    const SmoothSheet sheet = [&surface, side, u, v,
                               &cutter = offset_.cutter](const Eigen::Vector2d& at) {
        const int i = patch_near(surface, Parameter::U, at.x(), u);
        const int j = patch_near(surface, Parameter::V, at.y(), v);
        return offset_jet(surface.jet_in_patch(i, j, at.x(), at.y()), side, cutter);
    };
    const Interval range_u = surface.range(Parameter::U);
    const Interval range_v = surface.range(Parameter::V);
    return SheetStart{sheet,
                      place.head<2>() / place.z(),
                      reach_in_cells * cell(surface),
                      {range_u.low, range_v.low},
                      {range_u.high, range_v.high}};
}

std::optional<SheetStart> SmoothOffset::strip_start(const CrossedEdge& edge, double share,
                                                    std::int32_t turned) const
{
    const OffsetContact& contact = offset_.contacts[turned];
    const std::size_t number = static_cast<std::size_t>(contact.surface);
    for (const Parameter along : {Parameter::U, Parameter::V}) {
        const EdgeLine line{surfaces_[number], sides_[number], along, contact.at};
        const auto own_turn = line.turn(contact);
        if (!own_turn)
            continue;
        const auto spot = [&](std::int32_t vertex) -> Eigen::Vector2d {
            const OffsetContact& of = offset_.contacts[vertex];
            const bool is_on_it = of.surface == contact.surface && line.holds(of.at);
            const auto angle = is_on_it ? line.turn(of) : std::nullopt;
            return angle ? Eigen::Vector2d{component(of.at, along), *angle}
                         : Eigen::Vector2d{component(contact.at, along), *own_turn};
        };
        const SmoothSheet sheet = [line, side = sides_[number], along,
                                   &cutter = offset_.cutter](const Eigen::Vector2d& at) {
            return turned_offset_jet(line.jet(at.x()), side, along, at.y(), cutter);
        };
        const Interval range = surfaces_[number].range(along);
        const double cell_along = cell(surfaces_[number])[along == Parameter::U ? 0 : 1];
        return SheetStart{sheet,
                          (1 - share) * spot(edge.below) + share * spot(edge.above),
                          {reach_in_cells * cell_along, turn_reach},
                          {range.low, *own_turn > 0 ? 0 : -std::numbers::pi},
                          {range.high, *own_turn > 0 ? std::numbers::pi : 0}};
    }
    return std::nullopt;
}

}  // namespace endmill
