// SPDX-License-Identifier: GPL-3.0-or-later
#include "interference/conclusion-1/offset_data.h"

#include <algorithm>

#include "endmill/core/error.h"
#include "endmill/drop_cutter/detail/plane_gaps.h"
#include "endmill/files/surface_file.h"
#include "endmill/offset/detail/offset_grid.h"
#include "endmill/surface/tool_side.h"
#include "support/offset_sections.h"
#include "support/printed_search.h"

namespace endmill {
namespace {

// Sampling of the offset.
struct Sampling {
    int grid_lines;
    int planes;
};

std::ptrdiff_t contacts_without_normal(const std::vector<Surface>& part, int grid_lines)
{
    const auto sides = tool_side_signs(part, Vec3::UnitZ());
    std::ptrdiff_t count = 0;
    for (const OffsetGrid& grid : offset_grids(part, sides, grid_lines)) {
        const Surface& surface = part[static_cast<std::size_t>(grid.surface)];
        for (std::int32_t j = 0; j < grid.rows(); ++j)
            for (std::int32_t i = 0; i < grid.columns(); ++i)
                count += is_singular(tangents_at(grid, surface, i, j)) ? 1 : 0;
    }
    return count;
}

// The offset without contacts of the border, as in the paper, and its sections.
OffsetSections paper_sections(const std::vector<Surface>& part, const Cutter& cutter,
                              const Sampling& sampling)
{
    OffsetOptions options;
    options.grid_lines = sampling.grid_lines;
    options.boundary = BoundaryContact::None;
    const DriveFrame along_x{Angle::degrees(0)};
    OffsetSections result{
        offset_mesh(part, cutter, options),
        drive_planes(along_x, extent_across(part, along_x), sampling.planes),
        {}};
    result.sections =
        slice(result.offset.mesh, result.planes, {result.offset.part_triangles});
    return result;
}

std::optional<OffsetData> offset_data(const std::vector<Surface>& part,
                                      const Cutter& cutter, const Sampling& sampling)
{
    try {
        const OffsetSections sections = paper_sections(part, cutter, sampling);
        const auto gouge = [&](const std::vector<PlaneLines>& lines) {
            return std::max(0.0, -plane_gaps(part, cutter, lines, 0).least);
        };
        return OffsetData{
            gouge(trimmed_lines(sections, printed_method_3(), printed_options)),
            gouge(trimmed_lines(sections, "envelope", {}))};
    } catch (const GeometryError&) {
        return std::nullopt;
    }
}

}  // namespace

std::vector<OffsetCase> offset_cases(Experiment& run)
{
    const double radius = run.number("radius_mm");
    const auto words = run.texts("cutters");
    const auto corners = run.numbers("corner_radii_mm");
    const Sampling sampling{static_cast<int>(run.number("grid_lines")),
                            static_cast<int>(run.number("planes"))};
    const double allowed = run.number("allowed_gouge_mm");
    std::vector<OffsetCase> cases;
    for (const std::string& name : run.texts("surfaces")) {
        const auto part = read_surface("datasets/surfaces/" + name + ".json").surfaces;
        const std::ptrdiff_t without = contacts_without_normal(part, sampling.grid_lines);
        for (std::size_t k = 0; k < words.size(); ++k)
            cases.push_back({name, words[k], without, allowed,
                             offset_data(part, {radius, corners.at(k)}, sampling)});
    }
    return cases;
}

}  // namespace endmill
