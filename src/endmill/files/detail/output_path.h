// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// \file
/// Names of output files, the folders on their paths, and their content.

namespace endmill {

/// Whether there is a file or folder.
enum class Presence { Absent, Present, Unknown };

/// Whether there is a file or folder of this name; a symbolic link counts as one.
Presence presence(const std::filesystem::path& path);

/// Whether there certainly is one.
inline bool is_there(const std::filesystem::path& path)
{
    return presence(path) == Presence::Present;
}

/// Whether `name` lies in `folder` itself: no folder on its path is a symbolic link.
bool lies_inside(const std::filesystem::path& folder, const std::filesystem::path& name);

/// Whether `name` is relative and names a file without leaving its folder.
bool is_plain_name(const std::filesystem::path& name);

/// Creates the folders of `name` below `folder`. \return 0, or the error number.
int make_folders(const std::filesystem::path& folder, const std::filesystem::path& name);

/// Writes all of `content` to a descriptor. \return 0, or the error number.
int write_whole(int descriptor, std::string_view content);

/// Throws an OutputError "cannot ACT PATH: REASON" with the reason of the operating system.
[[noreturn]] void fail_output(const std::string& act, const std::filesystem::path& path,
                              int error);

}  // namespace endmill
