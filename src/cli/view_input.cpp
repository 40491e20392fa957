// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/view_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "cli/console.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/path_file.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

constexpr int deepest_nesting = 64;  // of JSON, as docs/file-formats.md states

// Files that are shown only together with the others of their folder.
constexpr std::array result_names{"summary.json", "deviation.vtp",  "sections.csv",
                                  "trimmed.csv",  "visibility.bsm", "engagement.csv"};

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

// The parser of nlohmann does not limit the depth, and its values are written recursively.
Json json_of(const fs::path& file, const ReadLimits& limits)
{
    const auto fault = [&](const std::string& found) {
        return FormatError{"E_JSON",
                           {shown_path(file), "", found, "a summary of endmill"}};
    };
    const auto check_depth = [&](int outer, Json::parse_event_t event, const Json&) {
        const bool opens = event == Json::parse_event_t::object_start ||
                           event == Json::parse_event_t::array_start;
        if (opens && outer >= deepest_nesting)
            throw fault(fmt::format("nested more than {} deep", deepest_nesting));
        return true;
    };
    Json content = Json::parse(read_file(file, limits), check_depth, false);
    if (!content.is_object())
        throw fault("no JSON object");
    return content;
}

// Whether engagement.csv is that of `verify`, which has intervals of rings and no loads.
bool is_of_simulation(const fs::path& file)
{
    std::ifstream stream{file};
    std::string header;
    std::getline(stream, header);
    return header.starts_with("point,latitude_deg");
}

// 01-setup, 02-plan, ... of a job. A link might lead back to the folder itself.
bool is_step(const fs::path& entry)
{
    std::error_code ignored;
    const std::string name = entry.filename().string();
    const auto is_digit = [](char letter) { return '0' <= letter && letter <= '9'; };
    return name.size() > 3 && name[2] == '-' && is_digit(name[0]) && is_digit(name[1]) &&
           fs::symlink_status(entry, ignored).type() == fs::file_type::directory;
}

// Where a file may be that a summary names. Some commands name it from the folder of the summary,
// others from the folder in which they ran, which often holds the folder of the summary.
std::vector<fs::path> places_of(const ViewSummary& summary, const fs::path& name)
{
    const fs::path folder = summary.file.parent_path();
    return {folder / name, folder / ".." / name, name};
}

// The part that a summary names; an empty path if it names none.
PartOptions part_in(const ViewSummary& summary)
{
    PartOptions part;
    const std::string name = text_in(summary.content, "part");
    if (name.empty())
        return part;
    const std::vector<fs::path> places = places_of(summary, name);
    const auto found = std::ranges::find_if(places, is_file);
    part.path =
        (found == places.end() ? places.front() : *found).lexically_normal().string();
    const auto* const axis =
        std::ranges::find(up_axis_names, text_in(summary.content, "part_up"));
    if (axis != up_axis_names.end())
        part.up = static_cast<UpAxis>(axis - up_axis_names.begin());
    if (text_in(summary.content, "part_units") == "inch")
        part.units = LengthUnit::Inch;
    return part;
}

class Finder {
public:
    explicit Finder(const ViewOptions& options) : options_{options} {}

    ViewInput run()
    {
        for (const std::string& source : options_.sources)
            add(source);
        add_named_path();
        compare_judged_path();
        add_named_part();
        if (input_.title.empty())
            input_.title =
                printable(fs::path{options_.sources.front()}.filename().string());
        return std::move(input_);
    }

private:
    void add(const fs::path& source)
    {
        std::error_code ignored;
        if (!fs::is_directory(source, ignored)) {
            add_file(source);
            return;
        }
        bool is_something = add_folder(source);
        for (const fs::path& entry : entries_of(source))
            if (is_step(entry))
                is_something = add_folder(entry) || is_something;
        if (!is_something)
            throw FormatError{"E_FORMAT",
                              {shown_path(source), "", "a folder without results",
                               "a folder that a command of endmill wrote"}};
    }

    // Returns whether the folder holds results, itself or in the folder that its summary prefers.
    bool add_folder(const fs::path& folder)
    {
        const std::string preferred = preferred_folder(folder);
        const bool is_inside = !preferred.empty() && add_results(folder / preferred);
        return add_results(folder) || is_inside;
    }

    // The folder of the recommended direction of `plan`, or of the exact method of `trim`; empty
    // if the summary names none.
    std::string preferred_folder(const fs::path& folder) const
    {
        const fs::path file = folder / "summary.json";
        if (!is_file(file))
            return "";
        const Json summary = json_of(file, options_.common.limits);
        std::string name = text_in(summary, "recommended");
        if (const auto of = summary.find("comparison");
            name.empty() && of != summary.end() && of->is_object())
            name = text_in(*of, "exact_method");
        else if (name.empty() && summary.contains("methods"))
            name = "envelope";
        std::error_code ignored;
        const bool is_name =
            fs::path{name}.filename() == name && name != "." && name != "..";
        return is_name && fs::is_directory(folder / name, ignored) ? name : "";
    }

    // Returns whether the folder itself holds results.
    bool add_results(const fs::path& folder)
    {
        bool is_something = false;
        const auto take = [&](const fs::path& file, std::string& to) {
            if (!is_file(file))
                return false;
            to = file.string();
            is_something = true;
            return true;
        };
        const std::vector<fs::path> entries = entries_of(folder);
        if (!take(folder / "toolpath.csv", input_.toolpath))
            for (const fs::path& entry : entries)
                if (has_path_extension(entry) && take(entry, input_.toolpath))
                    break;
        take(folder / "deviation.vtp", input_.deviation);
        take(folder / "sections.csv", input_.sections);
        if (auto trimmed = trimmed_in(folder); !trimmed.empty()) {
            is_something = true;
            input_.trimmed = std::move(trimmed);
        }
        take(folder / "visibility.bsm", input_.visibility);
        if (!is_of_simulation(folder / "engagement.csv"))
            take(folder / "engagement.csv", input_.engagement);
        if (is_file(folder / "summary.json")) {
            is_something = true;
            add_summary(folder / "summary.json");
        }
        for (const fs::path& entry : entries)
            if (entry.extension() == ".svg" && is_something)
                input_.pictures.push_back(entry);
        return is_something;
    }

    // The trimmed sections of a folder, or of a folder for each method beside the sections.
    static std::vector<TrimmedSections> trimmed_in(const fs::path& folder)
    {
        constexpr const char* name = "trimmed.csv";
        if (is_file(folder / name))
            return {{"", (folder / name).string()}};
        std::vector<TrimmedSections> methods;
        if (is_file(folder / "sections.csv"))
            for (const fs::path& entry : entries_of(folder))
                if (is_file(entry / name))
                    methods.push_back(
                        {printable(entry.filename().string()), (entry / name).string()});
        return methods;
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
        if (!is_file(file))
            throw FormatError{
                "E_OPEN", {shown_path(file), "", "cannot open", "a folder or a file"}};
        if (std::ranges::find(result_names, file.filename()) != result_names.end()) {
            const fs::path folder = file.parent_path();
            throw FormatError{
                "E_FORMAT",
                {shown_path(file), "", "a single file of results",
                 "its folder, " + (folder.empty() ? "." : shown_path(folder))}};
        }
        std::string extension = file.extension().string();
        std::ranges::transform(extension, extension.begin(), [](unsigned char letter) {
            return static_cast<char>(std::tolower(letter));
        });
        if (extension == ".csv" || has_path_extension(file)) {
            input_.toolpath = file.string();
        } else {
            input_.part = options_.part;
            input_.part.path = file.string();
        }
    }

    // The path that the last summary names, unless a source holds one.
    void add_named_path()
    {
        if (!input_.toolpath.empty())
            return;
        for (auto at = input_.summaries.rbegin(); at != input_.summaries.rend(); ++at) {
            const ViewSummary& summary = *at;
            const fs::path path = text_in(summary.content, "toolpath");
            if (path.empty())
                continue;
            for (const fs::path& place : places_of(summary, path))
                if (is_file(place) && is_recorded(place, summary)) {
                    input_.toolpath = place.lexically_normal().string();
                    return;
                }
        }
    }

    // Whether a file has the checksum of the path in a summary, if that has one.
    bool is_recorded(const fs::path& place, const ViewSummary& summary) const
    {
        const std::string recorded = text_in(summary.content, "toolpath_sha256");
        if (recorded.empty() ||
            recorded == content_sha256(read_file(place, options_.common.limits)))
            return true;
        warn(options_.common, shown_path(place) + ": not the path of " +
                                  shown_path(summary.file) +
                                  " (toolpath_sha256); it is not shown");
        return false;
    }

    // Whether the remaining stock is that of the path, or of the one from which it was made.
    void compare_judged_path()
    {
        const ViewSummary* const verified = summary_beside(input_, input_.deviation);
        const std::string judged =
            verified ? text_in(verified->content, "toolpath_sha256") : "";
        if (judged.empty() || input_.toolpath.empty() ||
            judged == content_sha256(read_file(input_.toolpath, options_.common.limits)))
            return;
        const ViewSummary* const beside = summary_beside(input_, input_.toolpath);
        if (beside && text_in(beside->content, "source_sha256") == judged)
            return;
        input_.deviation_note =
            "The remaining stock is that of another path: " + shown_path(verified->file) +
            " judges " + printable(text_in(verified->content, "toolpath")) + ", not " +
            shown_path(input_.toolpath) + " as it is now.";
        warn(options_.common, input_.deviation_note);
    }

    // The summaries that may name the part: first that of the path, then those of the other
    // results, then all from the last.
    std::vector<const ViewSummary*> summaries_by_rank() const
    {
        std::vector<const ViewSummary*> ranked;
        const auto add = [&](const ViewSummary* summary) {
            if (summary && std::ranges::find(ranked, summary) == ranked.end())
                ranked.push_back(summary);
        };
        for (const std::string& file :
             {input_.toolpath, input_.deviation, input_.visibility})
            add(summary_beside(input_, file));
        for (auto at = input_.summaries.rbegin(); at != input_.summaries.rend(); ++at)
            add(&*at);
        return ranked;
    }

    void add_named_part()
    {
        if (!options_.part.path.empty())
            input_.part = options_.part;
        const ViewSummary* source = nullptr;
        for (const ViewSummary* const summary : summaries_by_rank()) {
            PartOptions part = part_in(*summary);
            if (part.path.empty())
                continue;
            if (input_.part.path.empty() && is_file(part.path)) {
                input_.part = std::move(part);
                source = summary;
            } else if (input_.part.path.empty()) {
                warn(options_.common, shown_path(summary->file) + ": the part " +
                                          shown_path(part.path) +
                                          " is not there; the page does not show it");
            } else if (source && !is_same(part.path, input_.part.path)) {
                warn(options_.common, shown_path(summary->file) + ": names the part " +
                                          shown_path(part.path) + "; the page shows " +
                                          shown_path(input_.part.path) + ", that of " +
                                          shown_path(source->file));
                return;
            }
        }
    }

    static bool is_same(const fs::path& first, const fs::path& second)
    {
        std::error_code ignored;
        return first == second || fs::equivalent(first, second, ignored);
    }

    const ViewOptions& options_;
    ViewInput input_;
};

}  // namespace

std::string text_in(const Json& summary, const char* key)
{
    const auto found = summary.find(key);
    return found != summary.end() && found->is_string() ? found->get<std::string>() : "";
}

const ViewSummary* summary_of_reader(const ViewInput& input, const ReadLimits& limits)
{
    std::string shown;
    for (auto at = input.summaries.rbegin(); at != input.summaries.rend(); ++at) {
        const std::string read = text_in(at->content, "toolpath_sha256");
        if (read.empty() || text_in(at->content, "toolpath").empty())
            continue;
        if (shown.empty())
            shown = content_sha256(read_file(input.toolpath, limits));
        if (read == shown)
            return &*at;
    }
    return nullptr;
}

ViewInput find_view_input(const ViewOptions& options)
{
    return Finder{options}.run();
}

const ViewSummary* summary_beside(const ViewInput& input, const std::string& file)
{
    const auto folder_of = [](const fs::path& path) {
        return fs::absolute(path).lexically_normal().parent_path();
    };
    for (const ViewSummary& summary : input.summaries)
        if (!file.empty() && folder_of(summary.file) == folder_of(file))
            return &summary;
    return nullptr;
}

}  // namespace endmill
