// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/path/tool_path.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Request for one-way passes of a ball along u.
struct OneWayRequest {
    double radius;        ///< of the ball, mm
    double tolerance;     ///< chord tolerance, mm
    double scallop;       ///< scallop height, mm
    double return_z = 0;  ///< height of the tip on its return, mm
};

/// Plans by the method of Kim and Choi, which assumes circular sections.
ToolPath one_way_paper_path(const Surface& part, const OneWayRequest& request);

/// Plans by verified planning, which bounds gouge and remaining material.
ToolPath one_way_verified_path(const Surface& part, const OneWayRequest& request);

}  // namespace endmill
