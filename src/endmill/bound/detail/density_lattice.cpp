// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/density_lattice.h"

#include <algorithm>
#include <cmath>

namespace endmill {
namespace {

// Share of corner k of a cell at a place.
double share_of(const LatticePlace& place, std::size_t k)
{
    const auto along = [](bool is_high, double share) {
        return is_high ? share : 1 - share;
    };
    return along((k & 1U) != 0, place.x) * along((k & 2U) != 0, place.y) *
           along((k & 4U) != 0, place.z);
}

void sort_unique(std::vector<std::array<std::int64_t, 3>>& keys)
{
    std::ranges::sort(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

}  // namespace

DensityLattice::DensityLattice(std::span<const Eigen::AlignedBox3d> boxes, double spacing)
    : spacing_{spacing}
{
    Eigen::AlignedBox3d all;
    for (const Eigen::AlignedBox3d& box : boxes)
        all.extend(box);
    if (all.isEmpty())
        return;
    low_ = all.min();
    std::vector<Key> of_cells;
    for (const Eigen::AlignedBox3d& box : boxes) {
        const Key low = key_of(box.min());
        const Key high = key_of(box.max());
        for (std::int64_t k = low[2]; k <= high[2]; ++k)
            for (std::int64_t j = low[1]; j <= high[1]; ++j)
                for (std::int64_t i = low[0]; i <= high[0]; ++i)
                    of_cells.push_back({i, j, k});
    }
    sort_unique(of_cells);
    keys_.reserve(8 * of_cells.size());
    for (const Key& cell : of_cells)
        for (std::int64_t k = 0; k < 8; ++k)
            keys_.push_back(
                {cell[0] + (k & 1), cell[1] + (k >> 1 & 1), cell[2] + (k >> 2)});
    sort_unique(keys_);
    corners_.resize(keys_.size());
    weights_.resize(keys_.size());
    for (const Key& cell : of_cells) {
        const std::uint32_t node = *node_of(cell);
        cells_.push_back({node});
        for (std::int64_t k = 0; k < 8; ++k)
            corners_[node][k] =
                *node_of({cell[0] + (k & 1), cell[1] + (k >> 1 & 1), cell[2] + (k >> 2)});
    }
}

DensityLattice::Key DensityLattice::key_of(const Vec3& point) const
{
    const Vec3 steps = (point - low_) / spacing_;
    Key key{};
    for (int axis = 0; axis < 3; ++axis)
        key[axis] = static_cast<std::int64_t>(std::floor(steps[axis]));
    return key;
}

std::optional<std::uint32_t> DensityLattice::node_of(const Key& key) const
{
    const auto found = std::ranges::lower_bound(keys_, key);
    if (found == keys_.end() || *found != key)
        return std::nullopt;
    return static_cast<std::uint32_t>(found - keys_.begin());
}

std::optional<LatticePlace> DensityLattice::place(const Vec3& point) const
{
    const Key key = key_of(point);
    const auto node = node_of(key);
    if (!node || corners_[*node][1] == 0)
        return std::nullopt;
    const Vec3 share =
        (point - low_) / spacing_ - Vec3(double(key[0]), double(key[1]), double(key[2]));
    return LatticePlace{*node, static_cast<float>(share.x()),
                        static_cast<float>(share.y()), static_cast<float>(share.z())};
}

void DensityLattice::add_area(const Vec3& point, double area)
{
    const auto at = place(point);
    for (std::size_t k = 0; k < 8; ++k)
        weights_[corners_[at->node][k]] += area * share_of(*at, k);
}

double DensityLattice::value(std::span<const double> at_nodes,
                             const LatticePlace& place) const
{
    double sum = 0;
    const std::array<std::uint32_t, 8>& corner = corners_[place.node];
    for (std::size_t k = 0; k < 8; ++k)
        sum += share_of(place, k) * at_nodes[corner[k]];
    return sum;
}

}  // namespace endmill
