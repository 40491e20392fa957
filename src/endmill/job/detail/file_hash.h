// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace endmill {

/// The SHA-256 of a file, as 64 hexadecimal digits. Measured times do not count: of a
/// summary.json the keys that end in _s or _ms are left out, and its layout does not matter.
/// \throws FormatError E_OPEN if the file cannot be read.
std::string result_sha256(const std::filesystem::path& file);

/// The SHA-256 of the names and the `result_sha256` of all files in a folder and below it.
/// \throws FormatError E_OPEN if the folder or a file cannot be read.
std::string folder_sha256(const std::filesystem::path& folder);

}  // namespace endmill
