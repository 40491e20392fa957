// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/view_input.h"

#include <algorithm>
#include <system_error>

#include "cli/console.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/path_file.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path)
{
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

// The entries of a folder by name.
std::vector<fs::path> entries_of(const fs::path& folder)
{
    std::vector<fs::path> entries;
    std::error_code failed;
    for (fs::directory_iterator at{folder, failed}, end; !failed && at != end;
         at.increment(failed))
        entries.push_back(at->path());
    if (failed)
        throw FormatError{"E_OPEN", {shown_path(folder), "", failed.message(), ""}};
    std::ranges::sort(entries);
    return entries;
}

Json json_of(const fs::path& file, const ReadLimits& limits)
{
    Json content = Json::parse(read_file(file, limits), nullptr, false);
    if (!content.is_object())
        throw FormatError{
            "E_JSON", {shown_path(file), "", "no JSON object", "a summary of endmill"}};
    return content;
}

std::string text_in(const Json& summary, const char* key)
{
    const auto found = summary.find(key);
    return found != summary.end() && found->is_string() ? found->get<std::string>() : "";
}

class Finder {
public:
    explicit Finder(const ViewOptions& options) : options_{options} {}

    ViewInput run()
    {
        for (const std::string& source : options_.sources)
            add(source);
        add_named_files();
        if (input_.title.empty())
            input_.title =
                printable(fs::path{options_.sources.front()}.filename().string());
        return std::move(input_);
    }

private:
    void add(const fs::path& source)
    {
        std::error_code ignored;
        if (fs::is_directory(source, ignored)) {
            if (!add_folder(source))
                throw FormatError{"E_FORMAT",
                                  {shown_path(source), "", "a folder without results",
                                   "a folder that a command of endmill wrote"}};
        } else {
            add_file(source);
        }
    }

    // Returns whether the folder, or a folder of a step in it, holds results.
    bool add_folder(const fs::path& folder)
    {
        bool is_something = false;
        const auto take = [&](const char* name, std::string& to) {
            if (!is_file(folder / name))
                return;
            to = (folder / name).string();
            is_something = true;
        };
        take("toolpath.csv", input_.toolpath);
        take("deviation.vtp", input_.deviation);
        take("sections.csv", input_.sections);
        take("trimmed.csv", input_.trimmed);
        take("visibility.bsm", input_.visibility);
        take("engagement.csv", input_.engagement);
        if (is_file(folder / "summary.json")) {
            is_something = true;
            add_summary(folder / "summary.json");
        }
        for (const fs::path& entry : entries_of(folder)) {
            std::error_code ignored;
            if (entry.extension() == ".svg" && is_something)
                input_.pictures.push_back(entry);
            // 01-setup, 02-plan, ... of a job
            const std::string name = entry.filename().string();
            if (fs::is_directory(entry, ignored) && name.size() > 3 && name[2] == '-' &&
                '0' <= name[0] && name[0] <= '9' && '0' <= name[1] && name[1] <= '9')
                is_something = add_folder(entry) || is_something;
        }
        return is_something;
    }

    void add_summary(const fs::path& file)
    {
        Json content = json_of(file, options_.common.limits);
        if (const std::string name = text_in(content, "name"); !name.empty())
            input_.title = printable(name);
        input_.summaries.push_back({file, std::move(content)});
    }

    // A part or a path.
    void add_file(const fs::path& file)
    {
        std::string extension = file.extension().string();
        std::ranges::transform(extension, extension.begin(), [](unsigned char letter) {
            return static_cast<char>(std::tolower(letter));
        });
        if (extension == ".csv" || has_path_extension(file))
            input_.toolpath = file.string();
        else
            input_.part.path = file.string();
        if (!is_file(file))
            throw FormatError{
                "E_OPEN", {shown_path(file), "", "cannot open", "a folder or a file"}};
    }

    // The part and the path that the summaries name, unless they are given.
    void add_named_files()
    {
        for (const ViewSummary& summary : input_.summaries) {
            const fs::path folder = summary.file.parent_path();
            const std::string path = text_in(summary.content, "toolpath");
            if (input_.toolpath.empty() && !path.empty())
                for (const fs::path& place : {fs::path{path}, folder / path})
                    if (is_file(place)) {
                        input_.toolpath = place.string();
                        break;
                    }
            const std::string part = text_in(summary.content, "part");
            if (input_.part.path.empty() && !part.empty()) {
                if (is_file(folder / part))
                    name_part(folder / part, summary.content);
                else
                    warn(options_.common, shown_path(summary.file) + ": the part " +
                                              printable(part) +
                                              " is not there; the page shows none");
            }
        }
        if (!options_.part.path.empty())
            input_.part = options_.part;
    }

    void name_part(const fs::path& file, const Json& summary)
    {
        input_.part.path = file.lexically_normal().string();
        const auto* const axis =
            std::ranges::find(up_axis_names, text_in(summary, "part_up"));
        if (axis != up_axis_names.end())
            input_.part.up = static_cast<UpAxis>(axis - up_axis_names.begin());
        if (text_in(summary, "part_units") == "inch")
            input_.part.units = LengthUnit::Inch;
    }

    const ViewOptions& options_;
    ViewInput input_;
};

}  // namespace

ViewInput find_view_input(const ViewOptions& options)
{
    return Finder{options}.run();
}

}  // namespace endmill
