// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `figures`.

#include "endmill/figures/axonometric_figure.h"
#include "endmill/figures/deviation_svg.h"
#include "endmill/figures/direction_figures.h"
#include "endmill/figures/feed_svg.h"
#include "endmill/figures/force_figures.h"
#include "endmill/figures/section_svg.h"
#include "endmill/figures/setup_figures.h"
#include "endmill/figures/tool_path_svg.h"
#include "endmill/figures/travel_svg.h"
