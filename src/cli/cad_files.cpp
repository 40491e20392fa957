// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cad_files.h"

#include <algorithm>
#include <limits>

#include <unistd.h>

#include "build_facts.h"
#include "cli/arguments.h"
#include "cli/data_folder.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

// The folder of kept answers: beside the output folder.
fs::path cache_folder(const CommonOptions& options)
{
    constexpr const char* name = ".endmill-cad";
    if (options.output.empty())
        return name;  // all default output folders are in the current one
    fs::path output = fs::path{options.output}.lexically_normal();
    if (!output.has_filename())
        output = output.parent_path();
    return output.parent_path() / name;
}

}  // namespace

fs::path cad_program()
{
    const fs::path program = program_folder() / "endmill-cad";
    return access(program.c_str(), X_OK) == 0 ? program : fs::path{};
}

CadPart cad_part_for(const std::string& path, bool keep, const CommonOptions& options)
{
    return import_cad_with_cache(cad_program(), path,
                                 keep ? cache_folder(options) : fs::path{},
                                 std::string{program_version}, options.limits);
}

void add_face_option(CLI::App& command, std::vector<int>& faces, const std::string& help)
{
    const auto take = [&faces](const std::vector<std::string>& words) {
        faces.clear();
        for (const std::string& word : words)
            for (std::size_t begin = 0; begin <= word.size();) {
                const std::size_t end = std::min(word.find(',', begin), word.size());
                faces.push_back(whole_number_argument("--face",
                                                      word.substr(begin, end - begin), 1,
                                                      std::numeric_limits<int>::max()));
                begin = end + 1;
            }
        std::ranges::sort(faces);
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    };
    command.add_option_function<std::vector<std::string>>("--face", take, help)
        ->type_name("N,...");
}

}  // namespace endmill
