// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "support/named_cells.h"

namespace endmill {

/// Counts cases in which two readings of an equation differ.
class Tally {
public:
    void add(bool differs)
    {
        ++cases_;
        differing_ += differs ? 1 : 0;
    }

    /// A case with its difference, which counts if it is above `rounding`.
    void add_difference(double difference, double rounding)
    {
        add(difference > rounding);
        largest_ = std::max(largest_, difference);
    }

    /// A case with its ratio, which counts if it is above `most`.
    void add_ratio(double ratio, double most)
    {
        add(ratio > most);
        largest_ = std::max(largest_, ratio);
        sum_ += ratio;
    }

    std::int64_t cases() const { return cases_; }  ///< number of cases so far

    /// cases, differ.
    NamedCells cells() const { return {{"cases", cases_}, {"differ", differing_}}; }

    /// cases, differ, largest_difference_deg.
    NamedCells difference_cells() const
    {
        return joined(cells(), {{"largest_difference_deg", largest_}});
    }

    /// cases, differ, mean_ratio, largest_ratio.
    NamedCells ratio_cells() const
    {
        return joined(cells(), {{"mean_ratio", sum_ / static_cast<double>(cases_)},
                                {"largest_ratio", largest_}});
    }

private:
    std::int64_t cases_ = 0;
    std::int64_t differing_ = 0;
    double largest_ = 0;
    double sum_ = 0;
};

}  // namespace endmill
