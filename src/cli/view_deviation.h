// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/view_frame.h"
#include "cli/view_input.h"
#include "endmill/files/vtk.h"

namespace endmill {

/// The remaining stock of a page: points, limits and the worst places. Limits and places are
/// those of the summary beside the file.
Json deviation_view(const DeviationPoints& deviation, const ViewInput& input,
                    ViewFrame& frame);

}  // namespace endmill
