// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/straight_sweep.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// What an earlier run has moved through the stock.
struct EarlierRun {
    Cutter cutter;
    bool stands_at_first;    ///< it has cleared what it fills standing at the first tip
    std::vector<Vec3> tips;  ///< mm, in straight moves from one to the next, along +z
};

/// How a stock of heights came to be: a block, and what was moved through it, in order.
/// Heights tell nothing of what lies between the centres of their cells; this tells all.
struct StockHistory {
    Block block;
    std::vector<EarlierRun> runs;
};

/// A stock that was kept, with its history where that is known.
struct KeptStock {
    HeightStock heights;
    std::optional<StockHistory> history = {};
};

/// The run of a cutter along `path`; its sweeps are those of `path_sweeps`.
EarlierRun run_along(const ToolPath& path, const Cutter& cutter);

/// What all runs have cleared, in order.
std::vector<StraightSweep> history_sweeps(const StockHistory& history);

/// Number of `history_sweeps`.
std::size_t sweep_count(const StockHistory& history);

/// Instead of the number of a point: what leads there is a move of an earlier run.
inline constexpr std::int32_t by_earlier_run = -2;

/// The sweeps of earlier runs and, after them, those of a path.
class JoinedSweeps {
public:
    /// \param history null: there was no earlier run. Throws like `path_sweeps`.
    JoinedSweeps(const StockHistory* history, const ToolPath& path, const Cutter& cutter);

    std::span<const StraightSweep> all() const { return sweeps_; }
    std::span<const StraightSweep> own() const { return all().subspan(earlier_); }
    std::size_t earlier() const { return earlier_; }  ///< how many come first

    /// The point of the path to which a sweep leads: `by_earlier_run` if it is of one; a
    /// number below 0 stays as it is.
    std::int32_t point_of(std::int32_t sweep) const;

private:
    std::vector<StraightSweep> sweeps_;
    std::size_t earlier_;
    std::int32_t first_point_;  // to which the first of the path's own leads
};

}  // namespace endmill
