// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/view_frame.h"
#include "cli/view_input.h"

namespace endmill {

/// The sections of a page: the methods of trimming; for each plane that occurs its number, its
/// curves before and, for each method, after trimming, and its position across the feed if the summary beside the file states the direction.
/// \throws FormatError, LimitError as read_csv; FormatError E_CSV for a plane without a number,
///         E_EMPTY if there is no curve; LimitError for too many points.
Json sections_view(const ViewInput& input, const ReadLimits& limits, ViewFrame& frame);

}  // namespace endmill
