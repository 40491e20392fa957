// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/path/tool_path.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// What one-way passes along u of a ball are to keep.
struct OneWayRequest {
    double radius;        ///< of the ball, mm
    double tolerance;     ///< of chords, mm
    double scallop;       ///< mm
    double return_z = 0;  ///< height at which tips return, mm
};

/// By the planner of Kim and Choi, which trusts its circles.
ToolPath one_way_paper_path(const Surface& part, const OneWayRequest& request);

/// By the planner that bounds what it leaves and cuts.
ToolPath one_way_verified_path(const Surface& part, const OneWayRequest& request);

}  // namespace endmill
