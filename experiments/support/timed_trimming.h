// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "endmill/offset/slicer.h"
#include "endmill/trimming/trimming_methods.h"

namespace endmill {

/// The method in `trimming_methods` with this name. \throws DomainError if there is none.
const TrimmingMethod& trimming_method(std::string_view name);

/// Options of literal detection. \param step of the scan lines of method 1, mm; its
/// threshold is four steps.
TrimmingOptions literal_trimming(double step);

/// A trimming method with the options for its timing.
struct TimedMethod {
    std::string label;
    const TrimmingMethod* method;
    TrimmingOptions options;
};

/// All trimming methods; method 3 both by march and by scan. \param options of all
/// methods.
std::vector<TimedMethod> timed_methods(const TrimmingOptions& options);

/// The entry of `timed_methods` with this label. \throws DomainError if there is none.
TimedMethod timed_method(const std::string& label, const TrimmingOptions& options);

/// CPU time in s to trim all sections on one thread, the best within `budget_s` (see
/// cpu_time.h).
double trimming_s(const std::vector<PlaneSection>& sections, const TimedMethod& timed,
                  double budget_s);

}  // namespace endmill
