// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

/// \file
/// Reading of whole files, and the limits that every reader of this module obeys.

namespace endmill {

/// Limits of a reader. A file that exceeds one is refused.
struct ReadLimits {
    double max_extent_mm = 1e6;  ///< largest absolute value of a coordinate, in mm
    double max_memory_gib = 8;   ///< memory for reading one file, in GiB
};

/// Checks an estimate of the memory that a reader is about to allocate.
/// \param file  name of the file for the message.
/// \param bytes estimated memory in bytes.
/// \throws LimitError if `bytes` exceeds the limit; the message states both in GiB.
void require_memory(const std::string& file, double bytes, const ReadLimits& limits);

/// The whole content of a regular file, byte for byte.
/// \throws FormatError E_OPEN if the file is missing, is a folder, a device or a pipe
///         (which might never end), or cannot be read; E_EMPTY if it holds only white
///         space; E_COMPRESSED if it begins like a gzip, zip, xz, bzip2 or zstd file.
/// \throws LimitError if it is larger than the memory limit.
std::string read_file(const std::filesystem::path& path, const ReadLimits& limits = {});

/// The path as messages show it, without control characters.
std::string shown_path(const std::filesystem::path& path);

}  // namespace endmill
