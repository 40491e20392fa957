// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/figure-a-1/tables.h"

#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/figures/detail/ball_lines.h"
#include "endmill/process/detail/engaged_region.h"
#include "support/named_cells.h"

namespace endmill {

void add_frame_rows(CsvTable& table, const std::string& name, const EdgeElement& element,
                    const BallFrame& frame)
{
    const auto add = [&](const std::string& row, const Vec3& place, NamedCells cells) {
        cells.insert(cells.begin(),
                     {{"x", place.x()}, {"y", place.y()}, {"z", place.z()}});
        add_named(table, name + ", " + row, cells);
    };
    add("X", frame.turned(Vec3::UnitX()), {});
    add("Y", frame.turned(Vec3::UnitY()), {});
    add("Z", frame.turned(Vec3::UnitZ()), {});
    const Vec3 at = ball_point(element.latitude, element.azimuth);
    add("P", frame.in_room(at), {});
    const Vec3 radial = frame.turned((at - Vec3{0, 0, at.z()}).normalized());
    const Vec3 motion = radial.cross(Vec3::UnitZ());  // clockwise seen from above
    const ForceDirections forces = force_directions(element, frame);
    for (const auto& [direction, row] : {std::pair{forces.tangential, "F_T"},
                                         {forces.radial, "F_R"},
                                         {forces.axial, "F_z"}})
        add(row, direction,
            {{"along_motion", direction.dot(motion)},
             {"outwards", direction.dot(radial)}});
    for (const AzimuthRange& range : engaged_ranges(element.engagement, element.latitude))
        add_named(table, name + ", theta",
                  {{"from_deg", Angle::radians(range.from).degrees()},
                   {"to_deg", Angle::radians(range.to).degrees()},
                   {"at_deg", Angle::radians(element.azimuth).written_degrees()}});
}

}  // namespace endmill
