// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/setup_input.h"
#include "cli/setup_options.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// The visibility of the part, with progress. The ranks of the program compute a share of the
/// directions each, interleaved; the result does not depend on their number. Rank 0 calls
/// this function. It holds the whole map, since the search for setups reads all of it.
/// \throws as part_visibility and keep_reachable; DomainError if another rank read another
///         part; the error of a rank that fails.
PartVisibility divided_visibility(const SetupInput& input,
                                  const SetupCommandOptions& options);

/// What the other ranks do meanwhile: read the part, compute their share and send it to
/// rank 0. They hold the part and their share. Without a map to compute they do nothing.
/// \throws as read_setup_input, part_visibility and keep_reachable.
void send_visibility(const SetupCommandOptions& options);

}  // namespace endmill
