// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "endmill/strategy/detail/lay_by_strategy.h"
#include "endmill/strategy/strategy_options.h"

namespace endmill {

/// A path that has not been judged, and the length by which it is compared.
struct Candidate {
    Strategy strategy;
    CoveringPath covering;
    double travel;  ///< mm
};

/// Compares strategies by estimates on few samples, and lays the promising ones. The rules
/// are those of plan_by_best_strategy.
class StrategyComparison {
public:
    /// All must outlive this object.
    StrategyComparison(const Part& part, const BallCutter& cutter,
                       const StrategyOptions& options);

    /// Compares all strategies, and lays those that may give the shortest path.
    /// \throws the reason for which Strategy::Planar was refused, if none makes a path.
    void run();

    /// Lays the most promising of the strategies that have only been estimated; nothing if
    /// there is none left.
    std::optional<Candidate> next();

    /// The paths, the shortest one first.
    std::vector<Candidate>& candidates() { return candidates_; }
    /// Every strategy and its result.
    std::vector<TriedStrategy>& tried() { return tried_; }
    /// The same of one strategy.
    TriedStrategy& tried(Strategy strategy);

private:
    struct Estimated {
        Strategy strategy;
        Trials trials;
        // of Strategy::Planar, as long as it has only been estimated
        std::unique_ptr<DirectionSearch> search = {};

        double travel() const { return trials.travel.value_or(0); }
    };

    void attempt(Strategy strategy, const std::function<void()>& step);
    void refuse(Strategy strategy, std::string message);
    StrategyOptions next_share();
    void cover();
    double squares(double height) const;
    bool is_large() const;
    void add(Strategy strategy, CoveringPath covering);
    void try_one(Strategy strategy);
    void require_few_squares() const;
    double estimated_along(Strategy strategy, StrategyOptions options) const;
    double least_travel() const;
    bool is_possible(const Estimated& one) const;
    static void search_directions(Estimated& one);
    void search_further();
    bool is_promising(const Estimated& one) const;
    void lay(Estimated& one);
    void lay(Estimated& one, const StrategyOptions& options);

    const Part& part_;
    BallCutter cutter_;
    const StrategyOptions& options_;
    std::optional<CoveredPart> covered_;
    double area_ = 0;  // mm^2
    std::vector<Estimated> estimated_;
    std::vector<Candidate> candidates_;
    std::vector<TriedStrategy> tried_;
    std::exception_ptr failure_;  // of Strategy::Planar, else the first
    std::size_t steps_ = 0;
};

}  // namespace endmill
