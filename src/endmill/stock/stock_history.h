// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutting_body.h"
#include "endmill/cutter/straight_sweep.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/dexel_stock.h"
#include "endmill/stock/height_stock.h"

/// \file
/// The moves that made a stock. The heights of a stock are known at the centres of its
/// cells only. A block with the moves that cut it describes the stock exactly.

namespace endmill {

/// The moves of an earlier run through the stock.
struct EarlierRun {
    Cutter cutter;  ///< the shape that cut
    /// Whether the cutter plunged at the first tip and removed its volume there.
    bool stands_at_first;
    std::vector<Vec3> tips;  ///< mm, joined by straight moves; the axis is +z
};

/// The origin of a stock: a block and the runs that cut it, in order.
struct StockHistory {
    Block block;                   ///< the material before all runs
    std::vector<EarlierRun> runs;  ///< in the order of cutting
};

/// A stock from an earlier run or a mesh.
struct KeptStock {
    HeightStock heights;                       ///< at the centres of its cells
    std::optional<StockHistory> history = {};  ///< none if it is not known
};

/// The moves of an earlier run whose axis may turn.
struct EarlierTurningRun {
    CuttingBody cutter;  ///< the shape that cut
    /// Whether the cutter removed its volume at the first pose.
    bool stands_at_first;
    std::vector<CutterLocation> poses;  ///< in order; the axes are unit vectors
    /// The machine that interpolates, with a position for each pose; without it the
    /// motions are linear.
    std::optional<MachineMotion> machine = {};
};

/// The origin of a stock of dexels: a block and the runs that cut it, in order.
struct TurningHistory {
    Block block;                          ///< the material before all runs
    std::vector<EarlierTurningRun> runs;  ///< in the order of cutting
};

/// A stock of dexels from an earlier run, with the moves that made it.
struct KeptDexels {
    DexelStock dexels;       ///< over the block of the history
    TurningHistory history;  ///< describes the stock exactly
};

/// Returns the run of a cutter along `path`, from the point `first` up to, not including,
/// the point `end`.
/// \param stands whether the cutter removes its volume at the first of these points.
/// \pre first < end <= number of points; a machine has a position for each point.
EarlierTurningRun turning_run_along(const ToolPath& path, std::size_t first,
                                    std::size_t end, const CuttingBody& cutter,
                                    bool stands);

/// Returns the same history with runs whose axis may turn.
TurningHistory turning_history(const StockHistory& history);

/// Returns the number of motions of all runs; a cutter that stands at its first pose
/// counts as a motion.
std::size_t motion_count(const TurningHistory& history);

/// Returns the volumes that the cutter sweeps on the moves to the points of `path`, in
/// order. The first point has the volume of the cutter at this position. If the cutter
/// comes to it by a rapid or a retract, it has none.
/// \throws GeometryError if the axis of a point is not +z; the message names the point.
std::vector<StraightSweep> path_sweeps(const ToolPath& path, const Cutter& cutter);

/// Returns the run of a cutter along `path`. Its sweeps are those of `path_sweeps`.
EarlierRun run_along(const ToolPath& path, const Cutter& cutter);

/// Returns the sweeps of all runs, in order.
std::vector<StraightSweep> history_sweeps(const StockHistory& history);

/// Returns the number of `history_sweeps`.
std::size_t sweep_count(const StockHistory& history);

/// Replaces the number of a point if the sweep belongs to an earlier run.
inline constexpr std::int32_t by_earlier_run = -2;

/// The sweeps of earlier runs, followed by those of a path.
class JoinedSweeps {
public:
    /// \param history may be null: then there was no earlier run.
    /// \throws GeometryError if the axis of a point is not +z.
    JoinedSweeps(const StockHistory* history, const ToolPath& path, const Cutter& cutter);

    /// The same for a path of several tools.
    /// \param own the sweeps to all points of the path, or to all but its first.
    /// \param points number of points of the path.
    JoinedSweeps(const StockHistory* history, std::span<const StraightSweep> own,
                 std::size_t points);

    std::span<const StraightSweep> all() const { return sweeps_; }  ///< of all runs
    /// The sweeps of the path.
    std::span<const StraightSweep> own() const { return all().subspan(earlier_); }
    /// Number of sweeps of earlier runs.
    std::size_t earlier() const { return earlier_; }

    /// The number of the path point to which a sweep leads, or `by_earlier_run` for a
    /// sweep of an earlier run. A number below 0 means no sweep and is returned
    /// unchanged.
    std::int32_t point_of(std::int32_t sweep) const;

private:
    std::vector<StraightSweep> sweeps_;
    std::size_t earlier_;
    std::int32_t first_point_;  // to which the first sweep of the path leads
};

}  // namespace endmill
