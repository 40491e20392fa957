// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <mutex>
#include <span>

#include "endmill/core/error.h"
#include "endmill/core/vec.h"

namespace endmill {

/// Counts the directions that are done on all threads, for who wants to know.
class DirectionCount {
public:
    /// `report`, which may be empty, must outlive it.
    explicit DirectionCount(const std::function<void(std::size_t)>& report)
        : report_{report}
    {
    }

    /// Reports one more; throws what the report throws.
    void one_more()
    {
        if (!report_)
            return;
        const std::lock_guard lock{mutex_};
        report_(++done_);
    }

private:
    const std::function<void(std::size_t)>& report_;
    std::mutex mutex_;
    std::size_t done_ = 0;
};

/// \throws DomainError unless all are unit to 1e-9.
inline void require_unit_directions(std::span<const Vec3> directions)
{
    constexpr double off = 1e-9;  // what a reader of ten digits makes of a unit vector
    for (const Vec3& direction : directions)
        require(std::abs(direction.norm() - 1) <= off,
                "visibility: directions need the length 1");
}

}  // namespace endmill
