// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/offset/offset_mesh.h"
#include "endmill/planning/linking.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/tool_side.h"
#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/trimmed_planes.h"
#include "support/timed_trimming.h"

namespace endmill {

/// The work of `endmill trim` on a part in memory, by its default method and with the
/// contacts of the border, without measurements (clearance, sampling error) and files.
class WholeTrim {
public:
    WholeTrim(std::span<const Surface> part, int grid_lines, int planes)
        : part_{part},
          grid_lines_{grid_lines},
          planes_{planes}
    {
    }

    /// Trims once. \return number of moves of the path.
    std::size_t moves(const Cutter& cutter) const
    {
        require_reachable(part_, Vec3::UnitZ(), tool_side_signs(part_, Vec3::UnitZ()));
        const DriveFrame frame{Angle::degrees(0)};
        const DrivePlanes planes =
            drive_planes(frame, extent_across(part_, frame), planes_);
        const OffsetMesh offset =
            offset_mesh(part_, cutter, OffsetOptions{.grid_lines = grid_lines_});
        const auto sections = slice(offset.mesh, planes, {offset.part_triangles});
        const auto trimmed = trim_planes(sections, path_ranges(offset, planes, sections),
                                         trimming_method("envelope"), {});
        std::vector<std::vector<CutOut>> loops;
        std::vector<PlaneCurves> curves;
        for (std::size_t k = 0; k < trimmed.size(); ++k) {
            loops.push_back(cut_out(sections[k].curves, trimmed[k],
                                    [](const SegmentNumber&) { return false; }));
            curves.push_back({planes.positions[k], trimmed[k].curves});
        }
        LinkOptions link;
        link.safe_height = extent(part_, Vec3::UnitZ()).high + clear_above;
        return link_sections(curves, frame, cutter, link).points.size() + loops.size();
    }

private:
    static constexpr double clear_above = 5;  // mm, as in the program

    std::span<const Surface> part_;
    int grid_lines_;
    int planes_;
};

}  // namespace endmill
