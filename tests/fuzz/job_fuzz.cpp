// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/job_record.h"
#include "endmill/job/job_file.h"
#include "fuzz_program.h"

// A job that is read has options of its commands only, or the reader throws a documented
// error. What is read of job.json is written in the same words.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view content{reinterpret_cast<const char*>(bytes), size};
    if (const auto record = parse_job_record(content))
        program_must(parse_job_record(job_record_text(*record)).has_value());
    const ProgramOption cutter{"--cutter", OptionValue::Text};
    const ProgramOption machine{"--machine", OptionValue::FileOrWord};
    const ProgramOption arcs{"--arcs", OptionValue::None};
    static const ProgramDescription program{"/bin/true",
                                            "1",
                                            {{"setup", {machine}},
                                             {"plan", {cutter}},
                                             {"trim", {cutter}},
                                             {"feed", {cutter}},
                                             {"verify", {cutter}},
                                             {"post", {machine, arcs}}}};
    try {
        const Job job =
            parse_job(content, "f.json", program, {}, {.max_memory_gib = 0.25});
        program_must(is_fit_for_a_terminal(job.name) && job.rotary_axes <= 2);
        for (const StepRequest& step : job.steps)
            for (const GivenOption& option : step.options)
                program_must(option.name.starts_with("--"));
    } catch (const FormatError& error) {
        program_must(is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}
