// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/job_record.h"

#include <algorithm>
#include <cstdint>

#include <nlohmann/json.hpp>

#include "endmill/core/error.h"
#include "endmill/files/detail/strict_json.h"
#include "endmill/files/path_file.h"
#include "endmill/files/read_file.h"
#include "endmill/job/detail/job_steps.h"

namespace endmill {
namespace {

using Tree = nlohmann::ordered_json;

constexpr std::string_view format = "endmill-job-state/1";

Tree tree_of(const StepRecord& record, JobStep step)
{
    Tree tree{{"state", word_of(record.state)}};
    if (!record.reason.empty())
        tree["reason"] = record.reason;
    if (record.command.empty())
        return tree;
    tree["folder"] = job_step_folder(step);
    tree["exit"] = record.exit;
    tree["wall_s"] = record.wall_s;
    tree["command"] = record.command;
    tree["inputs"] = Tree::array();
    for (const InputHash& input : record.inputs)
        tree["inputs"].push_back({{"file", input.file}, {"sha256", input.sha256}});
    tree["sha256"] = record.sha256;
    tree["results_sha256"] = record.results_sha256;
    tree["warnings"] = record.warnings;
    return tree;
}

std::vector<std::string> texts_of(const JsonValue& list)
{
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < list.size(); ++i)
        texts.push_back(list.item(i).text());
    return texts;
}

StepRecord record_of(const JsonValue& value)
{
    StepRecord record;
    const auto word = value.member("state").word(step_state_words);
    record.state = static_cast<StepState>(std::ranges::find(step_state_words, word) -
                                          step_state_words.begin());
    if (const auto reason = value.find_member("reason"))
        record.reason = reason->text();
    if (!value.find_member("command"))
        return record;
    constexpr std::int64_t most_exit = 255;
    record.exit = static_cast<int>(value.member("exit").whole_number(0, most_exit));
    record.wall_s = value.member("wall_s").number();
    record.command = texts_of(value.member("command"));
    const JsonValue inputs = value.member("inputs");
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const JsonValue input = inputs.item(i);
        record.inputs.push_back(
            {input.member("file").text(), input.member("sha256").text()});
    }
    record.sha256 = value.member("sha256").text();
    record.results_sha256 = value.member("results_sha256").text();
    record.warnings = texts_of(value.member("warnings"));
    return record;
}

}  // namespace

std::string step_sha256(const std::string& version,
                        const std::vector<std::string>& command,
                        const std::vector<InputHash>& inputs)
{
    Tree all{{"version", version}, {"command", command}};
    for (const InputHash& input : inputs)
        all["inputs"].push_back({input.file, input.sha256});
    return content_sha256(all.dump(-1, ' ', false, Tree::error_handler_t::replace));
}

std::string job_record_text(const JobRecord& record)
{
    Tree tree{{"format", format},
              {"job", record.name},
              {"version", record.version},
              {"finished", record.is_finished}};
    if (record.is_finished)
        tree["exit"] = record.exit;
    for (std::size_t i = 0; i < job_step_count; ++i)
        tree["steps"][std::string{job_step_names.at(i)}] =
            tree_of(record.steps.at(i), static_cast<JobStep>(i));
    return tree.dump(2, ' ', false, Tree::error_handler_t::replace) + "\n";
}

std::optional<JobRecord> parse_job_record(std::string_view content)
{
    try {
        const JsonDocument document{content, "job.json"};
        const JsonValue root = document.root();
        if (root.member("format").text() != format)
            return std::nullopt;
        JobRecord record{root.member("job").text(), root.member("version").text(),
                         root.member("finished").truth()};
        const JsonValue steps = root.member("steps");
        for (std::size_t i = 0; i < job_step_count; ++i)
            if (const auto step = steps.find_member(job_step_names.at(i)))
                record.steps.at(i) = record_of(*step);
        return record;
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::optional<JobRecord> read_job_record(const std::filesystem::path& folder)
{
    try {
        return parse_job_record(read_file(folder / "job.json"));
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace endmill
