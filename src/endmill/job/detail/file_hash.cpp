// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/file_hash.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include <nlohmann/json.hpp>

#include "endmill/core/error.h"
#include "endmill/files/detail/json_tree.h"
#include "endmill/files/path_file.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;
using Tree = nlohmann::json;

[[noreturn]] void fail_to_read(const fs::path& file)
{
    throw FormatError{"E_OPEN", {shown_path(file), "", "cannot be read", "a file"}};
}

std::string sha256_of_bytes(const fs::path& file)
{
    std::ifstream stream{file, std::ios::binary};
    if (!stream)
        fail_to_read(file);
    ContentSha256 hash;
    std::vector<char> piece(1 << 16);
    while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) ||
           stream.gcount() > 0)
        hash.add({piece.data(), static_cast<std::size_t>(stream.gcount())});
    if (stream.bad())
        fail_to_read(file);
    return hash.word();
}

void remove_times(Tree& tree)
{
    if (tree.is_object())
        for (auto item = tree.begin(); item != tree.end();)
            item = item.key().ends_with("_s") || item.key().ends_with("_ms")
                       ? tree.erase(item)
                       : std::next(item);
    for (Tree& item : tree)
        if (item.is_structured())
            remove_times(item);
}

}  // namespace

std::string result_sha256(const fs::path& file)
{
    std::error_code error;
    if (!fs::is_regular_file(file, error))
        fail_to_read(file);
    if (file.filename() != "summary.json")
        return sha256_of_bytes(file);
    try {
        Tree tree = *json_tree(read_file(file), shown_path(file), {});
        remove_times(tree);
        return content_sha256(tree.dump(-1, ' ', false, Tree::error_handler_t::replace));
    } catch (const Error&) {
        return sha256_of_bytes(file);  // not as the program writes it
    }
}

std::string folder_sha256(const fs::path& folder)
{
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::recursive_directory_iterator at{folder, error}, end; !error && at != end;
         at.increment(error))
        if (!at->is_directory())
            files.push_back(at->path());
    if (error)
        fail_to_read(folder);
    std::ranges::sort(files);
    ContentSha256 hash;
    for (const fs::path& file : files)
        hash.add(fs::relative(file, folder).generic_string() + '\n' +
                 result_sha256(file) + '\n');
    return hash.word();
}

}  // namespace endmill
