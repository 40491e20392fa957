// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/stock/detail/dexel_cut.h"
#include "endmill/stock/detail/dexel_gaps.h"
#include "endmill/stock/detail/fixed_axis_ball.h"
#include "endmill/stock/detail/piece_chords.h"
#include "endmill/stock/dexel_stock.h"

namespace endmill {

/// Rays of a field along the sides of a tile.
inline constexpr int dexel_tile_side = 8;

/// A tile of 8 by 8 rays of a field, fewer at its border, while moves cut them.
class DexelTile {
public:
    /// \param axis of the field. \param column, row the first ray.
    DexelTile(const DexelStock& stock, int axis, int column, int row);

    /// A segment with a radius that contains all rays.
    const Vec3& middle() const { return rays_.middle; }  ///< mm, lower end
    Vec3 end() const { return rays_.middle + rays_.length * rays_.direction; }  ///< mm
    double radius() const { return rays_.radius; }                              ///< mm

    /// Greatest lengths of material in a body that does not cut, in units.
    struct BodyDepth {
        std::int64_t depth = 0;       ///< for certain
        std::int64_t most_depth = 0;  ///< possible
    };

    /// Returns the lengths of the material in a body.
    BodyDepth depth_in(const ToolPiece& body);

    /// Removes what a piece sweeps.
    DexelCut cut(const ToolPiece& piece);

    /// Whether a fixed-axis ball may reach material of the rays.
    bool is_reached(const FixedAxisBallOnField& ball) const
    {
        return !gaps_.contains(ball.whole_bound()) &&
               !gaps_.contains(ball.bound(around_));
    }

    /// The same for a piece that is a fixed-axis ball.
    DexelCut cut(const ToolPiece& piece, const FixedAxisBallOnField& ball);

    /// Moves the material into the dexels of a field.
    void move_to(std::vector<Dexel>& dexels);

private:
    const std::vector<RayChord>& chords_of(const ToolPiece& piece);
    std::size_t first_ray(std::size_t row) const { return row * columns_; }
    std::span<const EightWholeChords> chords_above(const FixedAxisBallOnField& ball);
    DexelCut cut_grazing(const ToolPiece& piece, std::size_t row,
                         const EightWholeChords& chords);

    const DexelField& field_;
    int column_;
    int row_;
    std::size_t columns_;
    std::size_t rows_;
    DexelRays rays_;
    DexelGaps gaps_;
    bool has_gaps_ = false;              // whether they may differ from the dexels
    alignas(64) Eight column_places_{};  // mm, in the part; the last is repeated
    alignas(64) Eight row_places_{};
    FixedAxisBallOnField::Rectangle around_;
    std::array<EightWholeChords, dexel_tile_side> row_chords_{};
    std::vector<RayChord> chords_;
    std::optional<RayStretch> material_ = {};  // of all rays, if it is known
};

}  // namespace endmill
