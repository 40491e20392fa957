// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "endmill/job/sweep_plan.h"
#include "fuzz_program.h"

namespace endmill {
namespace {

const ProgramDescription& described()
{
    static const ProgramDescription program{"/bin/true",
                                            "1",
                                            {{"numbers",
                                              {{"--scallop", OptionValue::Text},
                                               {"--cutter", OptionValue::Text},
                                               {"--arcs", OptionValue::None},
                                               {"--tool", OptionValue::File}},
                                              false,
                                              false}}};
    return program;
}

// Every case has a value for each parameter, and words without control characters.
void check_case(const SweepPlan& plan, std::uint64_t number)
{
    program_must(plan.values(number).size() == plan.parameters().size());
    const auto words = plan.arguments(number);
    program_must(!words.empty() && words.front() == plan.command());
    for (const std::string& word : words)
        program_must(is_fit_for_a_terminal(word));
}

}  // namespace
}  // namespace endmill

// A plan that is read has sound cases, or the reader throws a documented error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view content{reinterpret_cast<const char*>(bytes), size};
    try {
        const SweepPlan plan = parse_sweep_plan(content, "nowhere/f.json", described(),
                                                {.max_memory_gib = 0.25});
        program_must(plan.count() >= 1);
        program_must(is_fit_for_a_terminal(plan.name() + plan.source()));
        for (std::uint64_t i = 0; i < std::min<std::uint64_t>(plan.count(), 100); ++i)
            check_case(plan, i);
        check_case(plan, plan.count() - 1);
    } catch (const FormatError& error) {
        program_must(is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}
