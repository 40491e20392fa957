// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "endmill/deviation/detail/bounded_ray.h"
#include "endmill/deviation/detail/cell_bounds.h"
#include "endmill/deviation/detail/part_distance.h"
#include "endmill/deviation/detail/tile_measure.h"
#include "endmill/deviation/deviation.h"
#include "endmill/stock/detail/tool_pieces.h"

namespace endmill {

/// Input of a measurement with a turning axis, shared by all tiles.
struct TurningMeasured {
    const PartCharts& charts;         ///< of the part
    const ToolPieces& pieces;         ///< all motions
    const InitialRay& initial_ray;    ///< material before the first motion
    const DeviationOptions& options;  ///< limits and resolution
    const PartDistance& distance;     ///< from the part
    /// Whether all axes are +z, so that upright outer walls are not judged.
    bool is_upright;
    double corner_radius;  ///< least corner radius of all cutters, mm
};

/// A cell of the part with the bounded ray at its middle.
struct BoundedCell {
    MeasuredCell cell;  ///< its thickness is the upper bound
    BoundedRay ray;     ///< both bounds, up to the largest empty ball

    /// The thickness that counts at its middle, mm: the middle of the bounds.
    double value() const
    {
        const double middle = (ray.low + ray.high) / 2;
        return cell.is_judged() ? middle : std::min(middle, 0.0);
    }
};

/// The measurement of one tile for motions with a turning axis: bounded rays at the
/// middles of its cells, and bounds between them.
class TurningTile {
public:
    /// Cuts the rays of the tile. `tile` and everything in `measured` must outlive the
    /// object.
    TurningTile(const TurningMeasured& measured, const PartTile& tile);

    /// The cells of the tile whose middle has a normal.
    std::span<const BoundedCell> cells() const { return cells_; }

    /// The numbers of these cells in the tile.
    std::span<const int> numbers() const { return numbers_; }

    /// Lower bound of the distance in mm between the tile's middle and all cutters, less
    /// the radius of the tile; infinity without cutters.
    double gap() const { return gap_; }

    /// Returns the extremes of the cells, with bounds between their middles. The greatest
    /// thickness is the greatest lower bound, the deepest place the least upper bound, so
    /// both are certain.
    Extremes extremes() const;

    /// Returns the extremes after cells whose bounds exceed the thresholds have been
    /// measured more accurately and halved.
    Extremes refined(const RefinementThresholds& thresholds) const;

private:
    // All pieces that may reach some rays.
    struct NearPieces {
        RayDisc rays;
        std::vector<std::uint32_t> pieces;  // numbers

        // Whether a ray of this length is one of them.
        bool is_for(const PartRay& ray, double length) const
        {
            return length <= rays.length &&
                   (ray.point - rays.centre).norm() <= rays.reach;
        }
    };
    using Near = std::shared_ptr<const NearPieces>;

    // A cell of the refinement.
    struct Refined {
        BoundedCell bounded;
        Near near;
        bool at_border;  // needs planes, as do its quarters
        bool is_strip;   // counts in the bounds only
    };
    struct Bounds {
        double most;   // mm
        double least;  // mm
    };

    double sharpness(int level) const;
    void lay_out_rays();
    void cut_rays();
    void set_judged(MeasuredCell& cell) const;
    void limit(BoundedCell& bounded) const;
    RayDisc disc_of(const BoundedCell& bounded) const;
    Near near_pieces() const;
    Near nearer(const BoundedCell& bounded, const NearPieces& of) const;
    BoundedCell measured(const PartCell& cell, const PartRay& ray, const NearPieces& near,
                         int level) const;
    void take_ray(BoundedCell& bounded, const BoundedRay& ray) const;
    Bounds bounds(const BoundedCell& bounded, const NearPieces& near, bool by_planes,
                  const RefinementThresholds& thresholds, int level) const;
    bool needs_planes(const BoundedCell& bounded) const;
    double most_left(const BoundedCell& bounded) const;
    double most_left_by_pieces(const BoundedCell& bounded,
                               std::span<const ToolPiece* const> pieces) const;
    std::vector<const ToolPiece*> lowest_pieces(const BoundedCell& bounded,
                                                const NearPieces& near) const;
    double least_left(const BoundedCell& bounded, const NearPieces& near, bool by_planes,
                      double enough, double sharpness) const;
    bool has_no_foot(const MeasuredCell& cell, double away) const;
    void add_quarters(const Refined& of, int level, std::vector<Refined>& next) const;
    void take(Extremes& found, const BoundedCell& bounded) const;
    void add_leaf(Extremes& found, const Refined& leaf, const Bounds& bounds) const;

    TurningMeasured measured_;
    const PartTile& tile_;
    PartCharts::CurvatureBounds curvature_;
    bool touches_side_;
    bool is_wall_ = false;
    std::vector<BoundedCell> cells_;
    std::vector<int> numbers_;
    Vec3 centre_ = Vec3::Zero();
    double radius_ = 0;  // of a ball around the rays' points, mm
    double gap_;
    mutable Near near_;  // of the tile, made on first use
};

}  // namespace endmill
