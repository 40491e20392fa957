// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "endmill/files/surface_file.h"

namespace endmill::test {

/// The content of a surface file of type "bezier" from which `read_surface` reads the
/// same doubles.
/// \pre `file` has one surface of one bicubic patch without weights.
inline std::string surface_json(const SurfaceFile& file)
{
    const Surface& surface = file.surfaces.front();
    nlohmann::json rows;
    for (int j = 0; j <= 3; ++j)
        for (int i = 0; i <= 3; ++i) {
            const Vec3 point = surface.patch(0, 0).control_point(i, j);
            rows[j].push_back({point.x(), point.y(), point.z()});
        }
    const char* const sides[] = {"up", "du_cross_dv", "dv_cross_du"};
    return nlohmann::json{{"format", "endmill-surface/1"},
                          {"name", file.name},
                          {"source", file.source},
                          {"type", "bezier"},
                          {"tool_side", sides[static_cast<int>(surface.tool_side())]},
                          {"patches_u", 1},
                          {"patches_v", 1},
                          {"control_points", rows}}
        .dump();
}

}  // namespace endmill::test
