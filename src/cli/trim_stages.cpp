// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trim_stages.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>

#include "endmill/trimming/trimming_methods.h"

namespace endmill {
namespace {

// Processor time of each stage in us for a point of the sections: valley.json with a ball of
// 20 mm and 6000 planes.
constexpr std::array us_a_point{0.15, 0.8, 0.1, 1.6, 0.05, 4.5, 0.25, 0.6, 0.3};
constexpr auto first_of_a_method = static_cast<std::size_t>(TrimStage::Trimming);

double sum(std::span<const double> stages)
{
    return std::accumulate(stages.begin(), stages.end(), 0.0);
}

// The methods that run after `method`; all of them if it is empty.
std::size_t methods_after(std::string_view method, const TrimOptions& options)
{
    const auto methods = trimming_methods();
    if (method_name(options) != "all")
        return method.empty() ? 1 : 0;
    if (method.empty())
        return methods.size();
    return static_cast<std::size_t>(
        methods.end() - std::ranges::find(methods, method, &TrimmingMethod::name) - 1);
}

}  // namespace

double work_after(TrimStage stage, const TrimOptions& options, std::string_view method)
{
    const auto number = static_cast<std::size_t>(stage);
    const std::span<const double> all{us_a_point};
    const std::span<const double> stages_of_a_method = all.subspan(first_of_a_method);
    const std::span<const double> rest =
        number < first_of_a_method
            ? all.subspan(number + 1, first_of_a_method - number - 1)
            : all.subspan(number + 1);
    const auto repeated = static_cast<double>(methods_after(method, options));
    return (sum(rest) + repeated * sum(stages_of_a_method)) / all[number];
}

}  // namespace endmill
