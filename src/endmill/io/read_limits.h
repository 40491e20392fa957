// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace endmill {

/// What a reader accepts before it gives up.
struct ReadLimits {
    double max_extent_mm = 1e6;  ///< largest magnitude of a coordinate, in mm
    double max_memory_gib = 8;   ///< memory for reading one file, in GiB
};

/// Checks an estimate of the memory that reading `file` takes, before it is taken.
/// \param bytes the estimate.
/// \throws LimitError if it exceeds the limit; the message names both in GiB.
void require_memory(const std::string& file, double bytes, const ReadLimits& limits);

}  // namespace endmill
