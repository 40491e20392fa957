// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "endmill/core/error.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/program.h"

namespace endmill {

/// Aborts, which the fuzzer reports as a finding, unless `holds`.
inline void program_must(bool holds)
{
    if (!holds)
        std::abort();
}

inline bool is_fit_for_a_terminal(const std::string& text)
{
    return text.find_first_of("\n\x1b") == std::string::npos;
}

/// Aborts unless `program` satisfies the documented guarantees of the readers.
inline void check_program(const Program& program, const GcodeReadOptions& options)
{
    const auto& points = program.path.points;
    program_must(points.size() <= options.most_points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (const double coordinate : points[i].location.tip)
            program_must(std::abs(coordinate) <= options.max_extent_mm);
        program_must(i > 0 || (points[i].pass == 0 && points[i].point == 0));
        program_must(i == 0 || (points[i].pass == points[i - 1].pass
                                    ? points[i].point == points[i - 1].point + 1
                                    : points[i].pass == points[i - 1].pass + 1 &&
                                          points[i].point == 0));
    }
    for (const PathPoint& point : points) {
        const CuttingConditions& said = point.conditions;
        program_must(std::isfinite(said.feed_mm_per_min.value_or(1)));
        program_must(said.feed_mm_per_min.value_or(1) > 0);
        program_must(std::isfinite(said.spindle_rpm.value_or(1)));
        program_must(said.spindle_rpm.value_or(1) > 0);
        program_must(said.tool.value_or(0) >= 0);
    }
    for (const std::string& remark : program.remarks)
        program_must(is_fit_for_a_terminal(remark));
}

/// Parses the bytes by `parse`. The path is valid, or the reader throws a documented
/// error.
template <class Parse>
int fuzz_program(const std::uint8_t* bytes, std::size_t size, const Parse& parse)
{
    const std::string_view text{reinterpret_cast<const char*>(bytes), size};
    const GcodeReadOptions options{.arc_tolerance_mm = 0.01, .most_points = 20000};
    try {
        check_program(parse(text, "f.ngc", options), options);
    } catch (const FormatError& error) {
        program_must(is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}

}  // namespace endmill
