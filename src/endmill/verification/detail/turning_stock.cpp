// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/turning_stock.h"

#include <cmath>

#include "endmill/core/error.h"
#include "endmill/stock/detail/dexel_removal.h"
#include "endmill/verification/detail/stock_ray.h"
#include "endmill/verification/detail/turning_motions.h"

namespace endmill {
namespace {

template <typename Kept>
const Kept* kept_in(const VerificationTask& task)
{
    const auto* kept = std::get_if<const Kept*>(&task.stock);
    require(!kept || *kept, "verify_path: need a stock");
    return kept ? *kept : nullptr;
}

Sphere sphere_around(const Block& box)
{
    return {(box.low + box.high) / 2, (box.high - box.low).norm()};
}

}  // namespace

TurningStock::TurningStock(const VerificationTask& task)
    : heights_{kept_in<KeptStock>(task)},
      kept_{kept_in<KeptDexels>(task)},
      pitch_{kept_ ? kept_->dexels.pitch() : task.resolution}
{
    require(std::isfinite(task.resolution) && task.resolution > 0,
            "verify_path: need 0 < resolution");
    if (kept_)
        history_ = kept_->history;
    else if (heights_ && heights_->history)
        history_ = turning_history(*heights_->history);
    else if (!heights_)
        history_ = TurningHistory{std::get<Block>(task.stock), {}};
    box_ = history_ ? history_->block : material_box(heights_->heights);
    require_dexel_memory(box_, pitch_, task.max_memory_gib, task.extra_bytes_per_cell);
}

std::vector<ToolPiece> TurningStock::earlier_motions(std::int32_t point) const
{
    return history_ ? endmill::earlier_motions(*history_, point)
                    : std::vector<ToolPiece>{};
}

std::optional<std::size_t> TurningStock::earlier_moves() const
{
    return history_ && (heights_ || kept_) ? std::optional{motion_count(*history_)}
                                           : std::nullopt;
}

const HeightStock* TurningStock::heights_only() const
{
    return history_ ? nullptr : &heights_->heights;
}

InitialRay TurningStock::initial_ray() const
{
    if (const HeightStock* heights = heights_only())
        return [heights](const PartRay& ray) { return ray_in_stock(*heights, ray); };
    return [block = box_](const PartRay& ray) { return ray_in_block(block, ray); };
}

DexelStock TurningStock::dexels() const
{
    if (kept_)
        return kept_->dexels;
    if (heights_only())
        return dexels_of_heights(heights_->heights, pitch_);
    DexelStock stock{box_, pitch_};
    // What earlier moves removed is not asked for: all of them count as one move.
    std::vector<ToolPiece> earlier = earlier_motions(0);
    if (earlier.empty())
        return stock;
    const Sphere region = sphere_around(box_);
    const ToolPieces cutters{std::move(earlier), region};
    remove_from_dexels(stock, {cutters, ToolPieces{{}, region}, 1});
    return stock;
}

}  // namespace endmill
