// SPDX-License-Identifier: GPL-3.0-or-later
// endmill cite: the papers that the methods follow.

#include "cli/cite.h"

#include <array>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/console.h"
#include "cli/idle_options.h"
#include "endmill/files/output_folder.h"

namespace endmill {
namespace {

struct CiteOptions {
    CommonOptions common;
    bool bibtex = false;
};

struct Paper {
    std::string_view key;      // in paper/references.bib
    std::string_view methods;  // that follow it
};

constexpr std::array papers{
    Paper{
        "KimChoi",
        "economic cutter locations: plan --mode paper, eval (step length, path interval, "
        "scallop height); curvature and largest ball of info and plan"},
    Paper{"JangKimJeong",
          "trimming of offset sections: trim --mode paper, methods 1, 2 and 3"},
    Paper{"KangSuh",
          "five-axis machinability and setup: machine; setup, modes paper and "
          "paper-literal"},
    Paper{
        "ParkMaeng",
        "cutting forces of a ball-end mill, variable feed and speed: feed --mode paper, "
        "coefficients, toollife"},
};

// The value of `field` in the bibliography's entry `key`, without braces.
std::string bibliography_field(std::string_view key, std::string_view field)
{
    const auto entry = references.find(fmt::format("{{{},", key));
    const auto begin =
        references.find('{', references.find(fmt::format("\n  {}", field), entry));
    std::string value{references.substr(begin, references.find('\n', begin) - begin)};
    std::erase_if(value, [](char c) { return c == '{' || c == '}'; });
    if (value.ends_with(','))
        value.pop_back();
    return value;
}

// The authors of a BibTeX field as "A; B and C". The field has "and" between all of them.
std::string author_list(const std::string& authors)
{
    constexpr std::string_view separator = " and ";
    const std::size_t last = authors.rfind(separator);
    if (last == std::string::npos)
        return authors;
    std::string list = authors.substr(0, last);
    for (auto at = list.find(separator); at != std::string::npos;
         at = list.find(separator))
        list.replace(at, separator.size(), "; ");
    return list + authors.substr(last);
}

}  // namespace

std::string cited_work(std::string_view key)
{
    return author_list(bibliography_field(key, "author")) + ": " +
           bibliography_field(key, "title");
}

namespace {

ExitCode run_cite(const CiteOptions& options)
{
    if (options.common.json)
        refuse_idle_options(options.common, std::array{"--bibtex"}, "--json",
                            "one of the two");
    Json summary = Json::array();
    std::string text;
    for (const auto& [key, methods] : papers) {
        const std::string author = bibliography_field(key, "author");
        const std::string title = bibliography_field(key, "title");
        summary.push_back(
            {{"key", key}, {"author", author}, {"title", title}, {"methods", methods}});
        text += fmt::format("[{}] {}: {}\n    {}\n", key, author_list(author), title,
                            methods);
    }
    if (options.bibtex)
        text = references;
    if (!options.common.output.empty()) {
        OutputFolder folder{options.common.output, options.common.full_folder};
        folder.write("references.bib", references);
        folder.publish();
    }
    print_result(options.common, {{"papers", summary}}, text);
    return ExitCode::Yes;
}

}  // namespace

void add_cite_command(CLI::App& program, Action& action)
{
    CLI::App* command =
        program.add_subcommand("cite", "list the papers that the methods follow");
    const auto options = std::make_shared<CiteOptions>();
    command->add_flag("--bibtex", options->bibtex, "print the bibliography as BibTeX");
    add_common_options(*command, options->common);
    command->footer(
        "Prints the list. With --output it also writes DIR/references.bib.\n\n"
        "Example:\n  endmill cite --bibtex");
    command->callback(
        [options, &action] { action = [options] { return run_cite(*options); }; });
}

}  // namespace endmill
