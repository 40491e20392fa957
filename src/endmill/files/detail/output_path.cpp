// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/output_path.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

#include "endmill/core/error.h"
#include "endmill/files/read_file.h"

namespace endmill {

namespace fs = std::filesystem;

Presence presence(const fs::path& path)
{
    struct stat status {};
    if (::lstat(path.c_str(), &status) == 0)
        return Presence::Present;
    return errno == ENOENT || errno == ENOTDIR ? Presence::Absent : Presence::Unknown;
}

bool lies_inside(const fs::path& folder, const fs::path& name)
{
    std::error_code ignored;
    fs::path path = folder;
    for (const fs::path& part : name.parent_path()) {
        path /= part;
        if (!fs::is_directory(fs::symlink_status(path, ignored)))
            return false;
    }
    return true;
}

bool is_plain_name(const fs::path& name)
{
    return name.is_relative() && name.has_filename() &&
           std::ranges::none_of(
               name, [](const fs::path& part) { return part == "." || part == ".."; });
}

int make_folders(const fs::path& folder, const fs::path& name)
{
    std::error_code ignored;
    fs::path path = folder;
    for (const fs::path& part : name.parent_path()) {
        path /= part;
        if (fs::is_directory(path, ignored) || ::mkdir(path.c_str(), 0777) == 0)
            continue;
        const int error = errno;
        if (error != EEXIST)
            return error;
        if (!fs::is_directory(path, ignored))  // else another run has just created it
            return ENOTDIR;
    }
    return 0;
}

int write_whole(int descriptor, std::string_view content)
{
    while (!content.empty()) {
        const ssize_t count = ::write(descriptor, content.data(), content.size());
        if (count < 0 && errno != EINTR)
            return errno;
        content.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    return 0;
}

void fail_output(const std::string& act, const fs::path& path, int error)
{
    throw OutputError{"cannot " + act + " " + shown_path(path) + ": " +
                      std::generic_category().message(error)};
}

}  // namespace endmill
