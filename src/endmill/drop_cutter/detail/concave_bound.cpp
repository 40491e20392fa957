// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/concave_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// How a concave function is bounded from above by few values:
// 1. It is evaluated at equidistant places. If one value exceeds the limit, the answer is
//    no.
// 2. The line through two neighbouring values lies above the function outside the
//    interval between them. Over each interval the lines through the two neighbours on
//    the left and through the two on the right are upper bounds; the lower of both is
//    taken.
// 3. While the largest bound exceeds the limit, the function is evaluated in the middle
//    of that interval.
constexpr int first_values = 5;
// Limit of the values. After so many halvings the bound is close to the limit, or the
// interval is at the end of the function's domain; more values would hardly change the
// answer.
constexpr int most_values = 24;

struct Value {
    double at;
    double height;
};

// The value at `at` of the line through two values, of which `near` is the nearer one;
// infinite if one of them is infinite.
double drawn_out(const Value& far, const Value& near, double at)
{
    if (!std::isfinite(far.height) || !std::isfinite(near.height))
        return infinite;
    const double slope = (near.height - far.height) / (near.at - far.at);
    return near.height + slope * (at - near.at);
}

// An upper bound of the function between values k and k + 1.
double bound_between(const std::vector<Value>& values, std::size_t k)
{
    const Value& low = values[k];
    const Value& high = values[k + 1];
    const bool has_before = k > 0;
    const bool has_after = k + 2 < values.size();
    const auto before = [&](double at) {
        return has_before ? drawn_out(values[k - 1], low, at) : infinite;
    };
    const auto after = [&](double at) {
        return has_after ? drawn_out(values[k + 2], high, at) : infinite;
    };
    // The lower one of the two lines. Its maximum is at an end of the interval, or where
    // the lines cross.
    const auto lower = [&](double at) { return std::min(before(at), after(at)); };
    double greatest = std::max(lower(low.at), lower(high.at));
    const double at_low = before(low.at) - after(low.at);
    const double at_high = before(high.at) - after(high.at);
    if (std::isfinite(at_low) && std::isfinite(at_high) && at_low < 0 && at_high > 0) {
        const double share = at_low / (at_low - at_high);
        greatest = std::max(greatest, lower(low.at + share * (high.at - low.at)));
    }
    return greatest;
}

}  // namespace

bool stays_below(const std::function<double(double)>& function, double limit)
{
    std::vector<Value> values;
    for (int k = 0; k < first_values; ++k) {
        const double at = k / (first_values - 1.0);
        values.push_back({at, function(at)});
        if (values.back().height > limit)
            return false;
    }
    while (values.size() < most_values) {
        std::size_t highest = 0;
        double bound = -infinite;
        for (std::size_t k = 0; k + 1 < values.size(); ++k)
            if (const double here = bound_between(values, k); here > bound) {
                bound = here;
                highest = k;
            }
        if (bound <= limit)
            return true;
        const double at = (values[highest].at + values[highest + 1].at) / 2;
        const double height = function(at);
        if (height > limit)
            return false;
        values.insert(values.begin() + static_cast<std::ptrdiff_t>(highest) + 1,
                      {at, height});
    }
    return false;
}

}  // namespace endmill
