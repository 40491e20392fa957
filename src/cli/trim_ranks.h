// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "cli/trim_sections.h"
#include "endmill/trimming/trimming_methods.h"

namespace endmill {

/// The sections, trimmed by a method and clipped to their ranges, as trim_planes does. The
/// ranks of the program trim a share of the planes of a file each, or, of a single plane, a
/// share of the curves, as far as the method allows (curve_shares). The result does not depend on their number. Rank 0 calls this function; it
/// holds all curves, since it writes them.
/// \param progress if set, is called with the finished share, 0 to 1, by any thread.
/// \throws as trim_planes; the error of a rank that fails.
std::vector<Trimmed> trimmed_sections(
    const TrimInput& input, const TrimmingMethod& method, const TrimmingOptions& options,
    const std::function<void(double share)>& progress = {});

/// What the other ranks do meanwhile: trim the curves that rank 0 sends, until the program
/// ends. They read no file and hold their share of the curves. With a part they do nothing.
void serve_trimming(const TrimOptions& options);

}  // namespace endmill
