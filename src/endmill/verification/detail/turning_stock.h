// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/stock/detail/tool_pieces.h"
#include "endmill/stock/dexel_stock.h"
#include "endmill/stock/stock_history.h"
#include "endmill/verification/verification_task.h"

namespace endmill {

/// The stock of a task before its path, for a path whose axis may turn.
///
/// A block, or a stock with its history, is exact: rays of the part start with the
/// material of the block and are cut by the motions of earlier runs. Of other heights only
/// the centres of the cells are known.
class TurningStock {
public:
    /// \throws DomainError unless 0 < resolution.
    /// \throws GeometryError as `earlier_motions`.
    /// \throws LimitError if dexels do not fit into the memory of the task.
    explicit TurningStock(const VerificationTask& task);

    const Block& box() const { return box_; }  ///< holds all material
    double pitch() const { return pitch_; }    ///< mm, of the dexels

    /// The history of the stock; nothing if only heights are known.
    const std::optional<TurningHistory>& history() const { return history_; }

    /// The motions of earlier runs; none if the history is not known. This object must
    /// outlive them.
    /// \param point the number of a path point that all of them get, not negative.
    std::vector<ToolPiece> earlier_motions(std::int32_t point) const;

    /// Number of motions of earlier runs; nothing without earlier runs.
    std::optional<std::size_t> earlier_moves() const;

    /// The heights, if they are all that is known of the stock; else null.
    const HeightStock* heights_only() const;

    /// Returns the material on a ray of the part before all motions, those of earlier runs
    /// included. The task must outlive it.
    InitialRay initial_ray() const;

    /// Returns the dexels before the path. Heights with a history are made again from its
    /// block and its motions, so that the dexels are exact.
    DexelStock dexels() const;

private:
    const KeptStock* heights_ = nullptr;
    const KeptDexels* kept_ = nullptr;
    std::optional<TurningHistory> history_;
    Block box_;
    double pitch_;
};

}  // namespace endmill
