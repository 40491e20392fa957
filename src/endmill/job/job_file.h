// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/files/read_file.h"
#include "endmill/job/job_step.h"
#include "endmill/job/program_options.h"

/// \file
/// The file of a job ("endmill-job/1"): a part, the machine and the tool, and what is asked of
/// each step of the chain from part to program.

namespace endmill {

/// Whether a job asks for a step.
enum class StepWish {
    Default,  ///< it does not say: the step runs if the rest of the job needs it
    Yes,      ///< it does
    No,       ///< it does not want it
};

/// What a job says of one step.
struct StepRequest {
    StepWish wish = StepWish::Default;  ///< whether it is to run
    std::vector<GivenOption> options =
        {};                   ///< of its command; they override those of the job
    bool accepts_no = false;  ///< whether the chain goes on if its answer is no
};

/// A job as its file describes it. Names of files are paths from the current folder.
struct Job {
    std::filesystem::path file;                   ///< of the job
    std::string name;                             ///< from the file, or the file's stem
    std::filesystem::path part;                   ///< surface or mesh
    std::vector<GivenOption> part_options = {};   ///< --units, --up
    std::optional<GivenOption> protect = {};      ///< --protect
    std::optional<GivenOption> skip_facets = {};  ///< --skip-facets
    std::optional<GivenOption> machine = {};      ///< --machine
    std::size_t rotary_axes = 0;                  ///< of the machine
    std::optional<GivenOption> tool = {};         ///< --tool
    std::optional<GivenOption> cutter = {};       ///< --cutter; that of the tool
    std::optional<GivenOption> material = {};     ///< --material
    std::optional<GivenOption> control = {};      ///< --control
    std::optional<GivenOption> stock = {};        ///< --stock
    std::vector<GivenOption> tolerances = {};     ///< of `plan`
    std::optional<GivenOption> gouge_tolerance = {};     ///< --tolerance of `trim`
    std::vector<GivenOption> feeds = {};                 ///< --feed, --spindle-rpm
    std::array<StepRequest, job_step_count> steps = {};  ///< in the order of JobStep

    /// What the job says of a step.
    const StepRequest& request(JobStep step) const
    {
        return steps.at(static_cast<std::size_t>(step));
    }
};

/// Whether `run` itself gives the option of this key to a step: the results of other steps,
/// and what would take the place of the part. A job cannot.
bool is_set_by_run(std::string_view key);

/// A value that replaces one of the file.
struct JobSetting {
    std::string key;  ///< with dots, such as "plan.scallop"
    std::string
        value;  ///< a number, true, false or a list of numbers in JSON; else a text
};

/// Parses "KEY=VALUE". \throws DomainError unless there is a key.
JobSetting job_setting(const std::string& text);

/// Reads a job. Required keys: `format`, `part` {`file`, and `units`, `up`, `protect`,
/// `skip_facets`}. Optional keys: `name`, `source`, `machine`, `tool` (a file or a cutter
/// word), `material`, `control`, `stock`, `tolerances` {`chord_mm`, `inner_mm`, `outer_mm`,
/// `scallop_mm`}, `feed_mm_per_min`, `spindle_rpm`, `accept_no` (names of steps), and the
/// names of the steps: true, false, or an object with the options of its command, named as
/// on the command line with _ in place of -.
/// \param program  has the commands of the steps.
/// \param settings replace values of the file, in their order.
/// \throws FormatError as `JsonDocument` and, with the JSON pointer, for an unknown key, a
///         value of another type, or a file that does not exist; E_FORMAT for another format;
///         FormatError as `read_tool` and `read_machine`; also as `read_file`.
/// \throws DomainError for a setting whose key is not a key of an object.
Job read_job(const std::filesystem::path& path, const ProgramDescription& program,
             std::span<const JobSetting> settings = {}, const ReadLimits& limits = {});

/// Parses the content of a job file as `read_job` does.
/// \param path used in messages and for the default name; files are relative to its folder.
Job parse_job(std::string_view content, const std::filesystem::path& path,
              const ProgramDescription& program,
              std::span<const JobSetting> settings = {}, const ReadLimits& limits = {});

}  // namespace endmill
