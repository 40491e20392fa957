// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/covered_part.h"

#include "endmill/core/error.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

const std::vector<Surface>* surfaces_of(const Part& part)
{
    const auto* surfaces = std::get_if<std::vector<Surface>>(&part);
    if (!surfaces)
        throw GeometryError{"passes of a strategy are not planned on meshes"};
    return surfaces;
}

std::vector<double> reachable_sides(const std::vector<Surface>& surfaces)
{
    std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    require_reachable(surfaces, Vec3::UnitZ(), sides);
    return sides;
}

}  // namespace

CoveredPart::CoveredPart(const Part& part, const BallCutter& cutter, double tolerance)
    : surfaces_{surfaces_of(part)},
      sides_{reachable_sides(*surfaces_)},
      clear_{*surfaces_, sides_, cutter, Vec3::UnitZ(), tolerance}
{
}

PartSamples CoveredPart::samples(double spacing, std::size_t most_samples) const
{
    return {*surfaces_, sides_, spacing, most_samples};
}

bool CoveredPart::is_clear(const Vec3& from, const Vec3& to, MoveTestState& state) const
{
    return clear_.is_clear({from, to}, state.finer);
}

}  // namespace endmill
