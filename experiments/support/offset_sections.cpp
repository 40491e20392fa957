// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/offset_sections.h"

#include "support/experiment.h"

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

}  // namespace endmill
