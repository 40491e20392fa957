// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/data_folder.h"

#include <optional>
#include <system_error>

#include "build_facts.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> folder_above(fs::path above, const fs::path& wanted)
{
    std::error_code ignored;
    for (; !above.empty(); above = above.parent_path()) {
        if (fs::is_directory(above / wanted, ignored))
            return above / wanted;
        if (above == above.parent_path())
            break;
    }
    return std::nullopt;
}

}  // namespace

fs::path program_folder()
{
    std::error_code ignored;
    return fs::read_symlink("/proc/self/exe", ignored).parent_path();
}

fs::path data_folder(const std::string& option, const std::string& kind)
{
    const fs::path program = program_folder();
    fs::path installed = (program / installed_data / kind).lexically_normal();
    fs::path wanted = fs::path{"datasets"} / kind;
    std::error_code ignored;
    if (!program.empty() && fs::is_directory(installed, ignored))
        return installed;
    if (const auto built = folder_above(program, wanted))
        return *built;
    if (fs::is_directory(wanted, ignored))
        return wanted;
    throw DomainError{
        option + ": found no folder of " + kind + ", neither " +
        printable(installed.string()) + ", nor " + wanted.string() +
        " in the current folder, in " + printable(program.string()) +
        " or above it; expected one of these folders, or the name of a folder"};
}

}  // namespace endmill
