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

/// Counts finished directions over all threads and reports the count.
class DirectionCount {
public:
    /// \param report receives the count, from one thread at a time; may be empty; must
    ///         outlive the object.
    explicit DirectionCount(const std::function<void(std::size_t)>& report)
        : report_{report}
    {
    }

    /// Adds one direction and reports the count. An exception of the report is passed on.
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

/// Checks that directions have unit length. \throws DomainError if one does not, to 1e-9.
inline void require_unit_directions(std::span<const Vec3> directions)
{
    constexpr double tolerance = 1e-9;  // of the length: vectors read from ten digits
    for (const Vec3& direction : directions)
        require(std::abs(direction.norm() - 1) <= tolerance,
                "visibility: need directions of unit length");
}

}  // namespace endmill
