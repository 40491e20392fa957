// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "endmill/io/read_limits.h"

namespace endmill {

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
