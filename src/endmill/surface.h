// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `surface`.

#include "endmill/surface/bezier_patch.h"
#include "endmill/surface/continuity.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/largest_cutter.h"
#include "endmill/surface/nurbs.h"
#include "endmill/surface/part.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/surface.h"
#include "endmill/surface/surface_jet.h"
#include "endmill/surface/tool_side.h"
