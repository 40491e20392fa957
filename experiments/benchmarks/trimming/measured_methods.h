// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/experiment.h"
#include "support/offset_sections.h"

namespace endmill {

/// What is measured on an offset.
struct MeasuredMethods {
    std::vector<std::string> kinds;  ///< "slicing", or a label of `timed_methods`
    std::vector<double> stated_ms;   ///< reference times, one for each of `kinds`
    double step_mm;                  ///< of method 1
};

/// Adds a row with a measured number, its bar if it has one, and the ratio of both.
void add_measured(CsvTable& result, const std::string& row, double measured,
                  const std::string& unit, const CsvCell& bar = {});

/// Adds the times on one offset, and the ratio of method 3 by march to method 2. The rows
/// begin with `place`. \pre the kinds contain "3 march" and "2".
void add_offset(CsvTable& result, const std::string& place, const SectionPlan& plan,
                const MeasuredMethods& methods);

/// Adds the ratio of the search times of method 1 at a step and at twice this step. The
/// search time is inversely proportional to the step. The row begins with `place`.
void add_search(CsvTable& result, const std::string& place, const SectionPlan& plan);

}  // namespace endmill
