// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/parallel.h"

#include <atomic>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Keeps the exception of the lowest range. Ranges do not overlap and each stops at its
// first fault, so the result does not depend on how the numbers were divided.
class FirstException {
public:
    // Whether a range that begins there could still replace the exception kept so far.
    bool may_precede(std::size_t begin) const { return begin <= begin_; }

    void keep_current(std::size_t begin)
    {
        const std::lock_guard lock{mutex_};
        if (begin > begin_)
            return;
        begin_ = begin;
        exception_ = std::current_exception();
    }

    void rethrow() const
    {
        if (exception_)
            std::rethrow_exception(exception_);
    }

private:
    std::mutex mutex_;
    std::atomic<std::size_t> begin_ = std::numeric_limits<std::size_t>::max();
    std::exception_ptr exception_;
};

}  // namespace

void parallel_for(std::size_t count,
                  const std::function<void(std::size_t begin, std::size_t end)>& body)
{
    FirstException first;
    tbb::parallel_for(tbb::blocked_range<std::size_t>{0, count}, [&](const auto& range) {
        if (!first.may_precede(range.begin()))
            return;
        try {
            body(range.begin(), range.end());
        } catch (...) {
            first.keep_current(range.begin());
        }
    });
    first.rethrow();
}

void set_thread_count(int count)
{
    require(1 <= count && count <= 1024, "set_thread_count: need 1 <= count <= 1024");
    static std::unique_ptr<tbb::global_control> limit;
    limit.reset();  // TBB applies the smaller one of two limits
    limit = std::make_unique<tbb::global_control>(
        tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
}

}  // namespace endmill
