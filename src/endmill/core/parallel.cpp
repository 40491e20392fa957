// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/parallel.h"

#include <memory>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "endmill/core/error.h"

namespace endmill {

void parallel_for(std::size_t count,
                  const std::function<void(std::size_t begin, std::size_t end)>& body)
{
    tbb::parallel_for(tbb::blocked_range<std::size_t>{0, count},
                      [&](const auto& range) { body(range.begin(), range.end()); });
}

void set_thread_count(int count)
{
    require(1 <= count && count <= 1024, "set_thread_count: need 1 <= count <= 1024");
    static std::unique_ptr<tbb::global_control> limit;
    limit.reset();  // two limits at once would leave the smaller one in force
    limit = std::make_unique<tbb::global_control>(
        tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
}

}  // namespace endmill
