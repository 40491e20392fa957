// SPDX-License-Identifier: GPL-3.0-or-later
// endmill view: a page that shows results in a browser.

#include "cli/view.h"

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/console.h"
#include "cli/data_folder.h"
#include "cli/idle_options.h"
#include "cli/progress.h"
#include "cli/view_content.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/path_file.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

constexpr double bytes_per_mb = 1e6;

// The SHA-256 of a text in base64.
std::string base64_hash(std::string_view text)
{
    const std::string digits = content_sha256(text);
    const auto value = [](char digit) {
        return digit <= '9' ? digit - '0' : digit - 'a' + 10;
    };
    std::string bytes;
    for (std::size_t k = 0; k + 1 < digits.size(); k += 2)
        bytes += static_cast<char>(16 * value(digits[k]) + value(digits[k + 1]));
    return base64(bytes);
}

// The folder with the script of the page, beside the installed program or in the build.
fs::path page_folder()
{
    const fs::path program = program_folder();
    std::error_code ignored;
    for (const fs::path& folder :
         std::array{(program / installed_data / "page").lexically_normal(),
                    program.parent_path() / "page" / "page"})
        if (fs::is_regular_file(folder / "page.js", ignored))
            return folder;
    throw DomainError{
        "view: the script of the page is missing, since endmill was built without npm or "
        "esbuild; expected a build after scripts/setup.sh page (Debian packages npm and "
        "esbuild)"};
}

PageShell page_shell()
{
    const fs::path folder = page_folder();
    PageShell shell;
    shell.html = read_file(folder / "page.html");
    shell.style = read_file(folder / "page.css");
    shell.script = read_file(folder / "page.js");
    shell.style_hash = base64_hash(shell.style);
    shell.script_hash = base64_hash(shell.script);
    return shell;
}

// The page of --output: a file .html or .htm, or page.html in a folder.
fs::path page_file(const ViewOptions& options)
{
    const fs::path output = options.common.output;
    if (output.empty())
        return "page.html";
    const bool is_page = output.extension() == ".html" || output.extension() == ".htm";
    return is_page ? output : output / "page.html";
}

// "part, path and remaining stock"
std::string views_text(const Json& views)
{
    if (views.empty())
        return "the summaries";
    std::string text;
    for (std::size_t k = 0; k < views.size(); ++k) {
        if (k > 0)
            text += k + 1 == views.size() ? " and " : ", ";
        const auto name = views[k].get<std::string>();
        text += name == "deviation" ? "remaining stock" : name;
    }
    return text;
}

ExitCode run_view(const ViewOptions& options)
{
    const fs::path page = page_file(options);
    std::error_code ignored;
    if (fs::exists(page, ignored) && options.common.full_folder == FullFolder::Refuse)
        throw DomainError{"--output " + shown_path(page) +
                          ": the file exists; expected another name, or --force"};
    const Json summary = write_view(options, page);
    print_result(options.common, summary,
                 fmt::format("{}: {:.1f} MB, {}\nwritten to {}\n",
                             summary["name"].get<std::string>(),
                             summary["bytes"].get<double>() / bytes_per_mb,
                             views_text(summary["views"]), shown_path(page)));
    return ExitCode::Yes;
}

}  // namespace

void require_page()
{
    page_folder();
}

Json write_view(const ViewOptions& options, const fs::path& page)
{
    const PageShell shell = page_shell();
    const ViewInput input = find_view_input(options);
    if (input.toolpath.empty())
        refuse_idle_options(options.common, std::array{"--machine", "--tool"},
                            "no path among the sources", "a path or a program");
    ViewContent content = [&] {
        ProgressLine progress{"reading the results", options.common};
        return view_content(input, options, progress);
    }();
    Json views = Json::array();
    for (const char* view :
         {"part", "path", "deviation", "sections", "sphere", "machine"})
        if (content.head.contains(view))
            views.push_back(view);
    if (views.empty())
        warn(options.common,
             "the sources hold nothing that can be drawn; the page shows the "
             "summaries only");
    const std::string text =
        page_html(shell, input.title,
                  content.head.dump(-1, ' ', false, Json::error_handler_t::replace),
                  content.numbers);
    const fs::path parent = page.parent_path().empty() ? "." : page.parent_path();
    OutputFolder folder{parent, FullFolder::Accept};
    for (const std::string& file : {input.part.path, input.toolpath, input.deviation,
                                    input.sections, input.visibility, input.engagement})
        if (!file.empty())
            folder.protect(file);
    for (const TrimmedSections& trimmed : input.trimmed)
        folder.protect(trimmed.file);
    folder.write(page.filename(), text);
    folder.publish();
    return {{"name", input.title},
            {"endmill", program_version},
            {"page", shown_path(page)},
            {"bytes", text.size()},
            {"views", std::move(views)}};
}

void write_html(const fs::path& folder, const CommonOptions& options)
{
    if (!options.html)
        return;
    ViewOptions view;
    view.common = options;
    view.common.given.clear();  // of another command
    view.sources.push_back(folder.string());
    write_view(view, folder / "page.html");
}

void add_view_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "view",
        "write a page that shows part, path and result of the simulation in a browser");
    const auto options = std::make_shared<ViewOptions>();
    command
        ->add_option(
            "SOURCE", options->sources,
            "folders that plan, verify, trim, feed, setup or run wrote; parts; paths")
        ->required()
        ->expected(1, 100);
    command
        ->add_option("--part", options->part.path,
                     "part to show (default: that of the summaries)")
        ->type_name("PART");
    add_mesh_options(*command, options->part);
    add_rotary_options(*command, options->rotary);
    command
        ->add_option("--tool", options->tool,
                     "tool file: cutter and length (default: those of the summaries)")
        ->type_name("FILE");
    add_common_options(*command, options->common);
    command->footer(
        "Writes one file, --output PAGE.html (default ./page.html), which opens from "
        "disk\n"
        "and requests nothing: the part, the path with the tool on a slider, the "
        "remaining\n"
        "stock, sections before and after trimming, the directions that reach each "
        "facet,\n"
        "plots along the path, and the summaries. Large parts and paths are drawn with "
        "fewer\n"
        "triangles and points; the page states what was left out. Without --force a file "
        "that\n"
        "exists is refused.\n\n"
        "Example:\n"
        "  endmill plan datasets/surfaces/saddle.json --cutter ball:15 --scallop 0.5 -o "
        "saddle\n"
        "  endmill verify saddle/toolpath.csv --resolution 0.5 -o checked\n"
        "  endmill view saddle checked -o saddle.html");
    command->callback(
        [options, &action] { action = [options] { return run_view(*options); }; });
}

}  // namespace endmill
