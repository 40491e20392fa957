// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/smooth_drop.h"

#include <array>

#include "endmill/core/tolerance.h"
#include "endmill/gouge/detail/surface_gap.h"

namespace endmill {
namespace {

constexpr double pieces_per_radius = 2;
// mm per mm. A smaller rise beyond an edge is a rounding error at a level top.
constexpr double edge_push = 1e-6;
// mm, smallest gain for which the climb continues on a neighbouring patch. It is above
// rounding and far below the required accuracy.
constexpr double least_gain = 1e-13;
// Limits of the patches that one climb crosses and of the climbs of one search. Each
// contact is higher than the one before. A hundredth of these limits is enough in
// practice.
constexpr int most_patches = 1000;
constexpr int most_hills = 1000;
// Share of rest_gouge: the resolution to which the part's depth in the cutter is found.
constexpr double resolution_share = 0.1;

// The patches beyond the edges at which the height would grow.
std::array<PatchNumber, 3> neighbours(const PatchContact& contact)
{
    const auto sign = [](double push) { return (push > 0) - (push < 0); };
    const int i = contact.patch.i + sign(contact.beyond.x());
    const int j = contact.patch.j + sign(contact.beyond.y());
    return {PatchNumber{i, contact.patch.j}, PatchNumber{contact.patch.i, j},
            PatchNumber{i, j}};
}

}  // namespace

SmoothDrop::SmoothDrop(std::span<const Surface> surfaces, const Cutter& cutter)
    : surfaces_{surfaces},
      cutter_{cutter},
      tree_{surfaces, cutter.radius() / pieces_per_radius}
{
}

std::optional<PartContact> SmoothDrop::climb(const PartPlace& start,
                                             const Eigen::Vector2d& axis) const
{
    const Surface& surface = surfaces_[start.surface];
    const auto below = place_below(surface, {start.at.u, start.at.v}, cutter_, axis);
    if (!below)
        return std::nullopt;
    const PatchNumber first{surface.patch_number(Parameter::U, below->x()),
                            surface.patch_number(Parameter::V, below->y())};
    auto found = endmill::climb(surface, first, *below, cutter_, axis);
    if (!found)
        return std::nullopt;
    const auto has = [&](const PatchNumber& patch) {
        return patch != found->patch && patch.i >= 0 && patch.j >= 0 &&
               patch.i < surface.patches(Parameter::U) &&
               patch.j < surface.patches(Parameter::V);
    };
    const auto step_over = [&] {
        for (const PatchNumber& patch : neighbours(*found)) {
            if (!has(patch))
                continue;
            const auto next = endmill::climb(surface, patch, found->at, cutter_, axis);
            if (next && next->height > found->height + least_gain) {
                found = next;
                return true;
            }
        }
        return false;
    };
    for (int patches = 0; patches < most_patches; ++patches)
        if (!step_over())
            break;
    return PartContact{start.surface, *found,
                       found->beyond.cwiseAbs().maxCoeff() <= edge_push};
}

PartContact SmoothDrop::highest(PartContact known, const Eigen::Vector2d& axis,
                                FinerPieces& finer) const
{
    for (int hill = 0; hill < most_hills; ++hill) {
        const CutterCore core{cutter_, {axis.x(), axis.y(), known.on.height}};
        const auto higher =
            gap_below(tree_, core, resolution_share * rest_gouge, -rest_gouge, finer);
        const auto next =
            higher ? climb({higher->surface, higher->at}, axis) : std::nullopt;
        if (!next || !(next->on.height > known.on.height))
            break;
        known = *next;
    }
    return known;
}

}  // namespace endmill
