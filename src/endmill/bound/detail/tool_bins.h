// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/bound/detail/tool_reach.h"

namespace endmill {

/// Items at points, sorted by their places in the xy plane, so that those near an upright
/// tool are found without looking at all.
/// \tparam Item has `point`, in mm, and `size`: how far from the point it extends, mm.
template <typename Item>
class ToolBins {
public:
    /// \param items in any order.
    /// \param reach of the tool, mm.
    ToolBins(std::vector<Item> items, double reach) : items_{std::move(items)}
    {
        Eigen::AlignedBox3d box;
        for (const Item& item : items_) {
            box.extend(item.point);
            greatest_size_ = std::max(greatest_size_, item.size);
        }
        if (items_.empty())
            box.extend(Vec3::Zero());
        low_ = box.min();
        const Vec3 size = box.sizes();
        const double beside =
            std::sqrt(size.x() * size.y() / std::max<double>(1, items_.size()));
        width_ = std::max(std::clamp(2 * beside, reach / 16, reach / 3),
                          std::sqrt(size.x() * size.y() / most_bins));
        width_ = std::max(width_, std::max(size.x(), size.y()) / most_bins);
        columns_ = static_cast<int>(size.x() / width_) + 1;
        rows_ = static_cast<int>(size.y() / width_) + 1;
        const auto bin_of = [&](const Item& item) {
            return static_cast<std::size_t>(row(item.point.y())) * columns_ +
                   column(item.point.x());
        };
        std::ranges::stable_sort(items_, {}, bin_of);
        first_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
        for (const Item& item : items_)
            ++first_[bin_of(item) + 1];
        for (std::size_t k = 1; k < first_.size(); ++k)
            first_[k] += first_[k - 1];
        enclose();
    }

    const std::vector<Item>& items() const { return items_; }  ///< bin by bin
    double greatest_size() const { return greatest_size_; }    ///< of an item, mm

    /// Calls visit(number, from_nearest) for the items whose points are within `far` of the
    /// tool, until it returns false. `from_nearest` is that of ToolReach.
    template <typename Visit>
    void visit_near(const ToolReach& tool, double far, const Visit& visit) const
    {
        const Vec3& c = tool.centre();
        for (int row_at = row(c.y() - far); row_at <= row(c.y() + far); ++row_at) {
            const std::size_t before = static_cast<std::size_t>(row_at) * columns_;
            const std::uint32_t begin = first_[before + column(c.x() - far)];
            const std::uint32_t end = first_[before + column(c.x() + far) + 1];
            for (std::uint32_t k = begin; k < end; ++k) {
                const Vec3 away = tool.from_nearest(items_[k].point);
                if (away.squaredNorm() <= far * far && !visit(k, away))
                    return;
            }
        }
    }

    /// Calls visit(number) for the items that the boundary of the tool's reach may meet: those
    /// whose distance from it is at most their size.
    template <typename Visit>
    void visit_boundary(const ToolReach& tool, const Visit& visit) const
    {
        const Vec3& c = tool.centre();
        const double far = tool.reach() + greatest_size_;
        for (int row_at = row(c.y() - far); row_at <= row(c.y() + far); ++row_at) {
            const std::size_t before = static_cast<std::size_t>(row_at) * columns_;
            const std::size_t last = before + column(c.x() + far);
            for (std::size_t bin = before + column(c.x() - far); bin <= last; ++bin) {
                const bool has_boundary =
                    std::abs(tool.excess(spheres_[bin].centre)) <= spheres_[bin].radius;
                if (!has_boundary)
                    continue;
                for (std::uint32_t k = first_[bin]; k < first_[bin + 1]; ++k)
                    if (std::abs(tool.excess(items_[k].point)) <= items_[k].size)
                        visit(k);
            }
        }
    }

private:
    // A sphere around the items of a bin; without items its radius is below 0.
    struct Sphere {
        Vec3 centre = Vec3::Zero();
        double radius = -1;
    };

    static constexpr double most_bins = 1 << 20;

    int column(double x) const
    {
        return static_cast<int>(std::clamp((x - low_.x()) / width_, 0.0, columns_ - 1.0));
    }

    int row(double y) const
    {
        return static_cast<int>(std::clamp((y - low_.y()) / width_, 0.0, rows_ - 1.0));
    }

    void enclose()
    {
        spheres_.resize(first_.size() - 1);
        for (std::size_t bin = 0; bin < spheres_.size(); ++bin) {
            Eigen::AlignedBox3d box;
            for (std::uint32_t k = first_[bin]; k < first_[bin + 1]; ++k)
                box.extend(items_[k].point);
            if (box.isEmpty())
                continue;
            Sphere& sphere = spheres_[bin];
            sphere.centre = box.center();
            for (std::uint32_t k = first_[bin]; k < first_[bin + 1]; ++k)
                sphere.radius =
                    std::max(sphere.radius,
                             (items_[k].point - sphere.centre).norm() + items_[k].size);
        }
    }

    std::vector<Item> items_;
    std::vector<std::uint32_t> first_;  // first item of each bin, row by row
    std::vector<Sphere> spheres_;       // of each bin
    double width_ = 1;                  // of a bin, mm
    Vec3 low_ = Vec3::Zero();
    int columns_ = 1;
    int rows_ = 1;
    double greatest_size_ = 0;
};

}  // namespace endmill
