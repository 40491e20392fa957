// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/job_file.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/cutter/cutter.h"
#include "endmill/files/detail/json_format.h"
#include "endmill/files/detail/json_tree.h"
#include "endmill/files/machining_data.h"
#include "endmill/machine/configuration.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;
using Tree = nlohmann::json;

constexpr std::string_view format = "endmill-job/1";

constexpr std::array<std::string_view, 7> set_by_run{
    "setup", "setups", "path", "points", "polyline", "offset", "from_visibility"};

// A key of the job and the option that it becomes.
struct KeyOption {
    std::string_view key;
    std::string_view option;
    NumberRange range = {};  // of the number, unless it is a word
};

constexpr NumberRange positive{.above = 0, .most = 1e9};
constexpr NumberRange from_zero{.above = 0, .most = 1e9, .from = true};

constexpr std::array tolerance_keys{KeyOption{"chord_mm", "--chord-tolerance", positive},
                                    KeyOption{"inner_mm", "--inner-tolerance", from_zero},
                                    KeyOption{"outer_mm", "--outer-tolerance", from_zero},
                                    KeyOption{"scallop_mm", "--scallop", positive}};
constexpr std::array feed_keys{KeyOption{"feed_mm_per_min", "--feed", positive},
                               KeyOption{"spindle_rpm", "--spindle-rpm", positive}};

// The value of a setting: JSON if it is a number, true, false or a list, else a text.
Tree value_of(const JobSetting& setting)
{
    Tree value = Tree::parse(setting.value, nullptr, false);
    if (value.is_discarded() || value.is_object() || value.is_null() || value.is_string())
        return setting.value;
    return value;
}

// Puts a setting into the tree; objects on the way are made if they are missing.
void apply(const JobSetting& setting, Tree& root)
{
    Tree* at = &root;
    std::string_view rest = setting.key;
    while (true) {
        const std::size_t end = std::min(rest.find('.'), rest.size());
        const std::string key{rest.substr(0, end)};
        // `true` for a step stands for an object without options.
        if (at->is_boolean() && at->get<bool>() && at != &root)
            *at = Tree::object();
        if (key.empty() || !(at->is_object() || at->is_null()))
            throw DomainError{"--set " + printable(setting.key, 80) +
                              ": found no such key; expected a key of the job, and after "
                              "a dot a key of its object, such as plan.scallop"};
        at = &(*at)[key];
        if (end == rest.size())
            break;
        rest.remove_prefix(end + 1);
    }
    *at = value_of(setting);
}

std::string with_settings(std::string_view content, const fs::path& path,
                          std::span<const JobSetting> settings, const ReadLimits& limits)
{
    const FormatDocument checked{content, path, limits, format};
    Tree root = *json_tree(content, shown_path(path), limits);
    for (const JobSetting& setting : settings)
        apply(setting, root);
    return root.dump();
}

// Reads the keys of a job.
class JobReader {
public:
    JobReader(const fs::path& path, const ProgramDescription& program,
              const ReadLimits& limits)
        : base_{path.parent_path()},
          program_{program},
          limits_{limits}
    {
        job_.file = path;
    }

    Job read(const JsonValue& root);

private:
    void read_part(const JsonValue& root);
    void read_machine_of(const JsonValue& root);
    void read_tool_of(const JsonValue& root);
    void read_tolerances(const JsonValue& root);
    void read_step(const JsonValue& root, std::size_t step);
    void read_accepted(const JsonValue& root);
    void read_options(const JsonValue& value, const ProgramCommand& command,
                      StepRequest& request);
    std::optional<GivenOption> option_of(const JsonValue& root,
                                         const ProgramOption& option,
                                         std::string_view key);
    ProgramOption option_named(std::string_view command, std::string_view key) const;
    std::optional<GivenOption> file_of(const JsonValue& root, std::string_view key,
                                       std::string_view name, OptionValue takes);
    template <std::size_t Count>
    std::vector<GivenOption> options_of(const JsonValue& root,
                                        const std::array<KeyOption, Count>& keys);

    fs::path base_;
    const ProgramDescription& program_;
    const ReadLimits& limits_;
    Job job_;
};

// Calls `read`; its error gets the place of `value`.
template <typename Read>
auto placing(const JsonValue& value, Read read)
{
    try {
        return read();
    } catch (const DomainError& error) {
        const std::string text = error.what();
        constexpr std::string_view found = "found ";
        constexpr std::string_view expected = "; expected ";
        const std::size_t middle = text.find(expected);
        if (!text.starts_with(found) || middle == std::string::npos)
            throw value.complaint(text, "");
        throw value.complaint(text.substr(found.size(), middle - found.size()),
                              text.substr(middle + expected.size()));
    }
}

std::optional<GivenOption> JobReader::option_of(const JsonValue& root,
                                                const ProgramOption& option,
                                                std::string_view key)
{
    const auto value = root.find_member(key);
    if (!value)
        return std::nullopt;
    if (option.value == OptionValue::File || option.value == OptionValue::FileOrWord)
        value->text();
    return placing(*value,
                   [&] { return given_option(option, value->argument(), base_); });
}

// The option of a command, or, if it has none of this key, one that takes any text.
ProgramOption JobReader::option_named(std::string_view command,
                                      std::string_view key) const
{
    if (const ProgramCommand* const found = program_.find(command))
        if (const ProgramOption* const option = found->find(key))
            return *option;
    return {"--" + std::string{key}, OptionValue::Text};
}

std::optional<GivenOption> JobReader::file_of(const JsonValue& root, std::string_view key,
                                              std::string_view name, OptionValue takes)
{
    return option_of(root, {std::string{name}, takes}, key);
}

template <std::size_t Count>
std::vector<GivenOption> JobReader::options_of(const JsonValue& root,
                                               const std::array<KeyOption, Count>& keys)
{
    std::vector<GivenOption> options;
    for (const KeyOption& key : keys)
        if (find_number(root, key.key, key.range))
            options.push_back({std::string{key.option}, root.member(key.key).argument()});
    return options;
}

void JobReader::read_part(const JsonValue& root)
{
    const JsonValue part = root.member("part");
    constexpr std::array<std::string_view, 5> keys{"file", "units", "up", "protect",
                                                   "skip_facets"};
    part.allow_only(keys);
    part.member("file");
    job_.part = *file_of(part, "file", "PART", OptionValue::File)->value;
    for (const std::string_view key : {"units", "up"})
        if (auto given = option_of(part, option_named("plan", key), key))
            job_.part_options.push_back(*std::move(given));
    job_.protect = file_of(part, "protect", "--protect", OptionValue::File);
    job_.skip_facets = file_of(part, "skip_facets", "--skip-facets", OptionValue::File);
}

void JobReader::read_machine_of(const JsonValue& root)
{
    job_.machine = file_of(root, "machine", "--machine", OptionValue::FileOrWord);
    if (!job_.machine)
        return;
    const std::string& text = *job_.machine->value;
    if (job_.machine->is_file) {
        job_.rotary_axes =
            configuration_from_word(read_machine(text, limits_).configuration)
                .rotary.size();
        return;
    }
    const JsonValue value = root.member("machine");
    if (const auto fault = configuration_fault(text))
        throw value.complaint(
            value.shown() + ", which is no file and no machine word: " + *fault,
            "a machine file, or a word such as W/caxyBz/T");
    job_.rotary_axes = configuration_from_word(text).rotary.size();
}

void JobReader::read_tool_of(const JsonValue& root)
{
    job_.tool = file_of(root, "tool", "--tool", OptionValue::FileOrWord);
    if (!job_.tool)
        return;
    if (job_.tool->is_file) {
        job_.cutter = GivenOption{
            "--cutter", cutter_word(read_tool(*job_.tool->value, limits_).cutter)};
        return;
    }
    const JsonValue value = root.member("tool");
    if (!cutter_from_word(*job_.tool->value))
        throw value.complaint(value.shown() + ", which is no file and no cutter word",
                              "a tool file, or a cutter such as ball:10");
    job_.cutter = GivenOption{"--cutter", job_.tool->value};
    job_.tool.reset();
}

void JobReader::read_tolerances(const JsonValue& root)
{
    const auto value = root.find_member("tolerances");
    if (!value)
        return;
    std::array<std::string_view, tolerance_keys.size()> keys;
    std::ranges::transform(tolerance_keys, keys.begin(), &KeyOption::key);
    value->allow_only(keys);
    job_.tolerances = options_of(*value, tolerance_keys);
    for (const std::string_view key : {"chord_mm", "inner_mm"})
        if (const auto number = value->find_member(key))
            job_.gouge_tolerance = GivenOption{"--tolerance", number->argument()};
}

void JobReader::read_options(const JsonValue& value, const ProgramCommand& command,
                             StepRequest& request)
{
    std::vector<std::string> keys = command.keys();
    std::erase_if(keys, is_set_by_run);
    const std::vector<std::string_view> views{keys.begin(), keys.end()};
    value.allow_only(views);
    for (const std::string& key : keys) {
        const ProgramOption& option = *command.find(key);
        if (auto given = option_of(value, option, key))
            request.options.push_back(*std::move(given));
    }
}

void JobReader::read_step(const JsonValue& root, std::size_t step)
{
    const auto value = root.find_member(job_step_names.at(step));
    if (!value)
        return;
    StepRequest& request = job_.steps.at(step);
    if (value->is_object()) {
        request.wish = StepWish::Yes;
        read_options(*value, *program_.find(job_step_command(static_cast<JobStep>(step))),
                     request);
        return;
    }
    if (!value->is_truth())
        throw value->complaint(value->shown(), "true, false or an object with options");
    request.wish = value->truth() ? StepWish::Yes : StepWish::No;
}

void JobReader::read_accepted(const JsonValue& root)
{
    const auto value = root.find_member("accept_no");
    if (!value)
        return;
    for (std::size_t i = 0; i < value->size(); ++i) {
        const JsonValue item = value->item(i);
        const auto name = std::ranges::find(job_step_names, item.word(job_step_names));
        job_.steps.at(static_cast<std::size_t>(name - job_step_names.begin()))
            .accepts_no = true;
    }
}

Job JobReader::read(const JsonValue& root)
{
    std::vector<std::string_view> keys{
        "format",   "name",    "source", "part",       "machine",         "tool",
        "material", "control", "stock",  "tolerances", "feed_mm_per_min", "spindle_rpm",
        "accept_no"};
    keys.insert(keys.end(), job_step_names.begin(), job_step_names.end());
    root.allow_only(keys);
    job_.name = name_or_stem(root, job_.file);
    remark(root, "source");
    read_part(root);
    read_machine_of(root);
    read_tool_of(root);
    job_.material = file_of(root, "material", "--material", OptionValue::File);
    job_.control = option_of(root, option_named("post", "control"), "control");
    job_.stock = file_of(root, "stock", "--stock", OptionValue::FileOrWord);
    read_tolerances(root);
    job_.feeds = options_of(root, feed_keys);
    for (std::size_t step = 0; step < job_step_count; ++step)
        read_step(root, step);
    read_accepted(root);
    return std::move(job_);
}

}  // namespace

bool is_set_by_run(std::string_view key)
{
    return std::ranges::find(set_by_run, key) != set_by_run.end();
}

JobSetting job_setting(const std::string& text)
{
    const std::size_t middle = text.find('=');
    if (middle == std::string::npos || middle == 0)
        throw DomainError{"--set: found " + printable(text, 80) +
                          "; expected KEY=VALUE, such as plan.scallop=0.1"};
    return {text.substr(0, middle), text.substr(middle + 1)};
}

Job read_job(const fs::path& path, const ProgramDescription& program,
             std::span<const JobSetting> settings, const ReadLimits& limits)
{
    return parse_job(read_file(path, limits), path, program, settings, limits);
}

Job parse_job(std::string_view content, const fs::path& path,
              const ProgramDescription& program, std::span<const JobSetting> settings,
              const ReadLimits& limits)
{
    const std::string changed = settings.empty()
                                    ? std::string{content}
                                    : with_settings(content, path, settings, limits);
    const FormatDocument document{changed, path, limits, format};
    return JobReader{path, program, limits}.read(document.root());
}

}  // namespace endmill
