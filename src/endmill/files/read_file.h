// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
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

/// The whole content of a regular file, as it stands.
/// \throws FormatError E_OPEN if it is missing, a folder, a device or a pipe (which might
///         never end), or not readable;
///         E_EMPTY if it holds nothing but white space;
///         E_COMPRESSED if it begins as gzip, zip, xz, bzip2 or zstd files do.
/// \throws LimitError if it is larger than the memory limit.
std::string read_file(const std::filesystem::path& path, const ReadLimits& limits = {});

/// The path as messages show it: without control characters.
std::string shown_path(const std::filesystem::path& path);

}  // namespace endmill
