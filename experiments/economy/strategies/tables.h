// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/bound/path_bound.h"
#include "endmill/cutter/cutter.h"
#include "endmill/files/csv.h"
#include "endmill/strategy/strategy.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The cutter and the scallop height of a comparison. The inner tolerance is a fiftieth of
/// the scallop height, at least 0.001 mm, so that the bound means something.
struct ComparedCut {
    BallCutter ball;
    double scallop_height;  ///< mm
};

/// The rows of this experiment, and what they must hold.
class StrategiesTable {
public:
    /// \param most_squares surfaces of a larger area, in squares as wide as a strip on a plane,
    ///        are left out, because they take minutes.
    explicit StrategiesTable(double most_squares);

    /// Adds a row for each strategy on `surface`, and one for the best of them. A strategy
    /// that is refused, or left out, has a row with the reason.
    void add(const std::string& name, const Surface& surface, const ComparedCut& cut);

    /// All rows.
    const CsvTable& result() const { return table_; }

    /// The rows that break a promise, a sentence each: a path shorter than the bound, a path
    /// neither clean nor with a named uncovered place, a best path longer than the better
    /// clean one along parameter lines.
    const std::string& violations() const { return violations_; }

private:
    // What the rows of one surface and cut have in common.
    struct Comparison {
        std::vector<CsvCell> first_cells;  // surface, ball and height
        std::string title;                 // the same as words
        std::optional<PathBound> bound = {};
        /// Shorter cuts by contacts of the paths along parameters, and of those that are clean.
        std::optional<double> along_parameters_mm = {};
        std::optional<double> clean_along_parameters_mm = {};
    };

    void add_left_out(const Comparison& comparison);
    template <typename Plan>
    void add_row(Comparison& comparison, std::string_view strategy, const Plan& plan);
    std::vector<CsvCell> cells_of(Comparison& comparison, std::string_view strategy,
                                  const StrategyPlan& plan);
    void check(const Comparison& comparison, std::string_view strategy,
               const StrategyPlan& plan, double bound_mm);

    CsvTable table_;
    double most_squares_;
    std::string violations_;
};

}  // namespace endmill
