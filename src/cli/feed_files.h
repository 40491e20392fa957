// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/feed_summary.h"
#include "endmill/files/output_folder.h"

namespace endmill {

/// Writes all files of a feed plan into `folder` and replaces those of an earlier run.
/// \return summary.json
Json write_feed(const FeedResult& result, OutputFolder& folder);

}  // namespace endmill
