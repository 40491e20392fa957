// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/job_steps.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include <nlohmann/json.hpp>

#include "endmill/core/error.h"
#include "endmill/files/detail/json_tree.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;
using Choice = std::variant<StepCommand, StepNotNeeded>;

constexpr const char* toolpath = "toolpath.csv";
constexpr const char* summary = "summary.json";
constexpr const char* no_path = "there is no path: neither plan nor trim has made one";

// Adds the option of the job, if it has one, unless the step gives it itself.
void add(std::vector<GivenOption>& options, const std::optional<GivenOption>& option)
{
    if (option)
        add_default(options, *option);
}

void add_all(std::vector<GivenOption>& options, std::span<const GivenOption> more)
{
    for (const GivenOption& option : more)
        add_default(options, option);
}

// The path of the plan. Strategy iso plans in both directions and recommends one of them.
fs::path planned_path(const fs::path& results)
{
    const fs::path folder = results / job_step_folder(JobStep::Plan);
    std::error_code ignored;
    if (fs::exists(folder / toolpath, ignored))
        return folder / toolpath;
    const auto read = nlohmann::json::parse(read_file(folder / summary), nullptr, false);
    if (read.is_object())
        if (const auto found = read.find("recommended");
            found != read.end() && found->is_string() && (*found == "u" || *found == "v"))
            return folder / found->get<std::string>() / toolpath;
    throw FormatError{"E_OPEN",
                      {shown_path(folder), "", "no toolpath.csv",
                       "the results of endmill plan, which writes one"}};
}

// The job's steps and what stands in its folder.
class Chain {
public:
    Chain(const Job& job, const ChainState& state) : job_{job}, state_{state} {}

    Choice setup() const;
    Choice plan() const;
    Choice trim() const;
    Choice feed() const;
    Choice verify() const;
    Choice clamp() const;
    Choice post() const;

private:
    fs::path folder_of(JobStep step) const
    {
        return state_.folder / job_step_folder(step);
    }
    bool is_done(JobStep step) const
    {
        return state_.is_done.at(static_cast<std::size_t>(step));
    }
    StepWish wish(JobStep step) const { return job_.request(step).wish; }
    StepCommand begun(JobStep step, fs::path input) const
    {
        return {std::move(input), job_.request(step).options, {}};
    }
    GivenOption summary_of(JobStep step, std::string option) const
    {
        return {std::move(option), (folder_of(step) / summary).string(), true};
    }

    bool plans_five_axes() const;
    bool has_path() const { return is_done(JobStep::Plan) || is_done(JobStep::Trim); }
    fs::path unfed_path() const;
    fs::path path() const;
    void add_part_files(StepCommand& command) const;
    void add_path_files(StepCommand& command) const;

    const Job& job_;
    const ChainState& state_;
};

bool Chain::plans_five_axes() const
{
    return is_given(job_.request(JobStep::Plan).options, "--axis-mode") ||
           plans_from_setups(job_);
}

fs::path Chain::unfed_path() const
{
    if (!is_done(JobStep::Trim))
        return planned_path(state_.folder);
    const fs::path folder = folder_of(JobStep::Trim);
    std::error_code ignored;
    if (fs::exists(folder / toolpath, ignored))
        return folder / toolpath;
    return folder / "envelope" / toolpath;  // of --method all
}

fs::path Chain::path() const
{
    return is_done(JobStep::Feed) ? folder_of(JobStep::Feed) / toolpath : unfed_path();
}

void Chain::add_part_files(StepCommand& command) const
{
    command.beside.push_back(job_.part);
    for (const auto& option : {job_.protect, job_.skip_facets})
        if (option && option->is_file)
            command.beside.emplace_back(*option->value);
}

void Chain::add_path_files(StepCommand& command) const
{
    command.beside.push_back(command.input.parent_path() / summary);
    add_part_files(command);
}

Choice Chain::setup() const
{
    if (wish(JobStep::Setup) == StepWish::Default && job_.rotary_axes == 0)
        return StepNotNeeded{job_.machine ? "the machine has three axes"
                                          : "the job names no machine"};
    StepCommand command = begun(JobStep::Setup, job_.part);
    add_all(command.options, job_.part_options);
    add(command.options, job_.skip_facets);
    add(command.options, job_.machine);
    add(command.options, job_.tool);
    return command;
}

Choice Chain::plan() const
{
    if (wish(JobStep::Plan) == StepWish::Default && wish(JobStep::Trim) == StepWish::Yes)
        return StepNotNeeded{"the path comes from trimmed sections"};
    StepCommand command = begun(JobStep::Plan, job_.part);
    const bool is_field = std::ranges::any_of(command.options, [](const auto& option) {
        return option.name == "--axis-mode" && option.value == "field";
    });
    add_all(command.options, job_.part_options);
    add(command.options, job_.protect);
    add(command.options, job_.skip_facets);
    add(command.options, job_.cutter);
    add_all(command.options, job_.tolerances);
    for (const GivenOption& option : job_.feeds)
        if (option.name == "--feed" && !plans_from_setups(job_))
            add(command.options, option);
    if (is_field) {
        add(command.options, job_.machine);
        add(command.options, job_.tool);
    }
    if (is_done(JobStep::Setup))
        add_default(
            command.options,
            summary_of(JobStep::Setup, plans_from_setups(job_) ? "--setups" : "--setup"));
    return command;
}

Choice Chain::trim() const
{
    if (!trims_gouges(job_))
        return StepNotNeeded{"the job does not ask for it"};
    if (is_done(JobStep::Plan) && !state_.plan_gouges)
        return StepNotNeeded{"the path of the plan needs no repair"};
    StepCommand command = begun(JobStep::Trim, job_.part);
    add_all(command.options, job_.part_options);
    add(command.options, job_.cutter);
    add(command.options, job_.gouge_tolerance);
    if (!is_given(command.options, "--planes") && !is_given(command.options, "--pitch"))
        for (const GivenOption& option : job_.tolerances)
            if (option.name == "--scallop")
                add(command.options, option);
    return command;
}

Choice Chain::feed() const
{
    if (!has_path())
        return StepNotNeeded{no_path};
    if (wish(JobStep::Feed) == StepWish::Default) {
        if (!job_.material)
            return StepNotNeeded{"the job names no material"};
        if (plans_five_axes() || is_done(JobStep::Setup))
            return StepNotNeeded{"feeds are computed for a tool along +z only"};
    }
    StepCommand command = begun(JobStep::Feed, unfed_path());
    add(command.options, job_.material);
    add(command.options, job_.machine);
    add(command.options, job_.tool);
    add(command.options, job_.stock);
    add_path_files(command);
    return command;
}

Choice Chain::verify() const
{
    if (!has_path())
        return StepNotNeeded{no_path};
    StepCommand command = begun(JobStep::Verify, path());
    add(command.options, job_.tool);
    add(command.options, job_.stock);
    add_path_files(command);
    return command;
}

Choice Chain::clamp() const
{
    if (!has_path())
        return StepNotNeeded{no_path};
    if (wish(JobStep::Clamp) == StepWish::Default) {
        if (job_.rotary_axes == 0)
            return StepNotNeeded{"the machine has three axes"};
        if (!plans_from_setups(job_))
            return StepNotNeeded{"the part stands as the setup says"};
    }
    StepCommand command = begun(JobStep::Clamp, path());
    add(command.options, job_.machine);
    add(command.options, job_.tool);
    add_path_files(command);
    return command;
}

Choice Chain::post() const
{
    if (!has_path())
        return StepNotNeeded{no_path};
    const bool has_feed =
        is_done(JobStep::Feed) ||
        std::ranges::find(job_.feeds, "--feed", &GivenOption::name) != job_.feeds.end();
    if (wish(JobStep::Post) == StepWish::Default && !has_feed)
        return StepNotNeeded{"the job states no feed_mm_per_min and no material"};
    StepCommand command = begun(JobStep::Post, path());
    if (job_.rotary_axes > 0) {
        add(command.options, job_.machine);
        add(command.options, job_.tool);
        if (is_done(JobStep::Clamp))
            add_default(command.options, summary_of(JobStep::Clamp, "--setup"));
        else if (is_done(JobStep::Setup))
            add_default(command.options, summary_of(JobStep::Setup, "--setup"));
    }
    add(command.options, job_.control);
    if (!is_done(JobStep::Feed))
        add_all(command.options, job_.feeds);
    add_path_files(command);
    return command;
}

}  // namespace

bool plans_from_setups(const Job& job)
{
    return is_given(job.request(JobStep::Setup).options, "--max-setups");
}

bool trims_gouges(const Job& job)
{
    const auto& options = job.request(JobStep::Plan).options;
    const auto mode = std::ranges::find(options, "--mode", &GivenOption::name);
    const bool plans_as_printed = mode != options.end() && mode->value == "paper";
    return job.request(JobStep::Trim).wish == StepWish::Yes ||
           (job.request(JobStep::Trim).wish == StepWish::Default && plans_as_printed);
}

bool plan_gouges(const fs::path& folder)
{
    const fs::path file = planned_path(folder).parent_path() / summary;
    const auto read = json_tree(read_file(file), shown_path(file), {});
    const auto number = [&](const char* key) {
        const auto found = read->find(key);
        return found != read->end() && found->is_number() ? found->get<double>() : 0;
    };
    return number("max_gouge_mm") > number("inner_tolerance_mm");
}

std::string job_step_folder(JobStep step)
{
    return "0" + std::to_string(static_cast<int>(step) + 1) + "-" +
           std::string{job_step_name(step)};
}

Choice step_command(const Job& job, JobStep step, const ChainState& state)
{
    if (job.request(step).wish == StepWish::No)
        return StepNotNeeded{"the job does not want it"};
    const Chain chain{job, state};
    switch (step) {
        case JobStep::Setup:
            return chain.setup();
        case JobStep::Plan:
            return chain.plan();
        case JobStep::Trim:
            return chain.trim();
        case JobStep::Feed:
            return chain.feed();
        case JobStep::Verify:
            return chain.verify();
        case JobStep::Clamp:
            return chain.clamp();
        case JobStep::Post:
            return chain.post();
    }
    return StepNotNeeded{};
}

}  // namespace endmill
