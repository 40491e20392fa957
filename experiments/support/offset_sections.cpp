// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/offset_sections.h"

#include "endmill/trimming/detail/section_views.h"
#include "endmill/trimming/trimmed_planes.h"
#include "support/experiment.h"
#include "support/timed_trimming.h"

namespace endmill {

DrivePlanes planes_over(const SectionPlan& plan, int count)
{
    const std::vector<Surface> part{dataset_surface(plan.surface)};
    const DriveFrame frame{Angle::degrees(plan.direction_deg)};
    return drive_planes(frame, extent_across(part, frame), count);
}

OffsetSections offset_sections(const SectionPlan& plan)
{
    const std::vector<Surface> part{dataset_surface(plan.surface)};
    OffsetOptions options;
    options.grid_lines = plan.grid_lines;
    options.boundary = plan.boundary;
    OffsetSections result{
        offset_mesh(part, plan.cutter, options), planes_over(plan, plan.planes), {}};
    result.sections =
        slice(result.offset.mesh, result.planes, {result.offset.part_triangles});
    return result;
}

std::vector<PlaneLines> untrimmed_lines(const DrivePlanes& planes,
                                        const std::vector<PlaneSection>& sections)
{
    std::vector<PlaneLines> lines;
    for (std::size_t k = 0; k < sections.size(); ++k)
        lines.push_back(lines_in_space(untrimmed(sections[k].curves).curves, planes.frame,
                                       planes.positions[k]));
    return lines;
}

std::vector<PlaneLines> trimmed_lines(const OffsetSections& sections,
                                      const std::string& method,
                                      const TrimmingOptions& options)
{
    return trimmed_lines(sections, trimming_method(method), options);
}

std::vector<PlaneLines> trimmed_lines(const OffsetSections& sections,
                                      const TrimmingMethod& method,
                                      const TrimmingOptions& options)
{
    const DrivePlanes& planes = sections.planes;
    const auto ranges = path_ranges(sections.offset, planes, sections.sections);
    const auto trimmed = trim_planes(sections.sections, ranges, method, options);
    std::vector<PlaneLines> lines;
    for (std::size_t k = 0; k < trimmed.size(); ++k)
        lines.push_back(
            lines_in_space(trimmed[k].curves, planes.frame, planes.positions[k]));
    return lines;
}

PlaneLines every_nth(const std::vector<PlaneLines>& planes, std::size_t n)
{
    PlaneLines chosen;
    for (std::size_t k = 0; k < planes.size(); k += n)
        chosen.insert(chosen.end(), planes[k].begin(), planes[k].end());
    return chosen;
}

}  // namespace endmill
