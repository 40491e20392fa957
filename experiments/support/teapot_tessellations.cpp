// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/teapot_tessellations.h"

#include <span>

#include "endmill/files/surface_file.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// Number of patches of the bottom, the last ones of datasets/surfaces/teapot.json; see
// the README there.
constexpr std::size_t bottom_patches = 4;

}  // namespace

TriangleMesh teapot_of_squares(int lines, bool has_bottom)
{
    const auto part = read_surface("datasets/surfaces/teapot.json");
    const std::span<const Surface> all{part.surfaces};
    const auto taken = has_bottom ? all : all.first(all.size() - bottom_patches);
    return sampled_on_grid(taken, tool_side_signs(taken, Vec3::UnitZ()), lines).mesh;
}

}  // namespace endmill
