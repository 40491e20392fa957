// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <pthread.h>

#include "endmill/core/error.h"

// Every call of parallel_for is a job. Its caller works on it, and threads of one pool help.
// Each takes ranges of the numbers from a counter, long ones first. A thread that waits for the
// helpers of its job works on no other job, so that nested calls cannot wait for each other.
// A job lives on the stack of its caller, and nothing is allocated but the threads: where the
// system has none left, the caller works alone.

namespace endmill {
namespace {

using Body = std::function<void(std::size_t begin, std::size_t end)>;

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

// One call of parallel_for.
class Job {
public:
    Job(std::size_t count, const Body& body, std::size_t threads)
        : count_{count},
          body_{body},
          ranges_left_{ranges_per_thread * threads}
    {
    }

    bool has_work() const { return next_.load(std::memory_order_relaxed) < count_; }

    // Processes ranges until none is left.
    void work()
    {
        std::size_t begin = next_;
        while (begin < count_) {
            const std::size_t size =
                std::max<std::size_t>(1, (count_ - begin) / ranges_left_);
            if (!next_.compare_exchange_weak(begin, begin + size))
                continue;
            process(begin, begin + size);
            begin = next_;
        }
    }

    void rethrow() const { first_.rethrow(); }

    // Guarded by the mutex of the pool.
    Job* older = nullptr;
    int helpers = 0;

private:
    // A range is this share of what is left for each thread, so that threads of different
    // speed end together.
    static constexpr std::size_t ranges_per_thread = 4;

    void process(std::size_t begin, std::size_t end)
    {
        if (!first_.may_precede(begin))
            return;
        try {
            body_(begin, end);
        } catch (...) {
            first_.keep_current(begin);
        }
    }

    std::size_t count_;
    const Body& body_;
    std::size_t ranges_left_;
    std::atomic<std::size_t> next_ = 0;
    FirstException first_;
};

// The helping threads. They start with the first job that needs them.
class Pool {
public:
    // The pool of this process.
    static Pool& instance()
    {
        // never destroyed: threads may outlive main
        static Pool* pool = new Pool;
        // A process that forks off has no helpers, and none of the jobs of other threads.
        [[maybe_unused]] static const int is_watched =
            pthread_atfork([] { pool->mutex_.lock(); }, [] { pool->mutex_.unlock(); },
                           [] { pool = new Pool{pool->threads_}; });
        return *pool;
    }

    void set_threads(int count)
    {
        {
            const std::lock_guard lock{mutex_};
            threads_ = count;
        }
        has_job_.notify_all();
    }

    void run(std::size_t count, const Body& body)
    {
        std::unique_lock lock{mutex_};
        Job job{count, body, static_cast<std::size_t>(threads_)};
        const bool has_helpers = count > 1 && threads_ > 1;
        if (has_helpers) {
            start_threads();
            job.older = newest_;
            newest_ = &job;
        }
        lock.unlock();
        if (has_helpers)
            has_job_.notify_all();
        job.work();
        if (has_helpers) {
            lock.lock();
            remove(job);
            has_no_helpers_.wait(lock, [&] { return job.helpers == 0; });
        }
        job.rethrow();
    }

private:
    Pool() = default;
    explicit Pool(int threads) : threads_{threads} {}

    // The caller of a job is one of the threads. Holds the mutex.
    void start_threads()
    {
        try {
            for (; started_ < threads_ - 1; ++started_)
                std::thread{[this, number = started_] { help(number); }}.detach();
        } catch (const std::exception&) {
            threads_ = started_ + 1;  // no more threads to be had
        }
    }

    // The life of helper `number`.
    void help(int number)
    {
        std::unique_lock lock{mutex_};
        for (;;) {
            Job* job = number < threads_ - 1 ? newest_ : nullptr;
            while (job && !job->has_work())
                job = job->older;
            if (!job) {
                has_job_.wait(lock);
                continue;
            }
            ++job->helpers;
            lock.unlock();
            job->work();
            lock.lock();
            if (--job->helpers == 0)
                has_no_helpers_.notify_all();
        }
    }

    // Holds the mutex.
    void remove(const Job& job)
    {
        Job** link = &newest_;
        while (*link != &job)
            link = &(*link)->older;
        *link = job.older;
    }

    std::mutex mutex_;
    std::condition_variable has_job_;
    std::condition_variable has_no_helpers_;
    Job* newest_ = nullptr;
    int threads_ = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    int started_ = 0;
};

// Makes the calls of `finish` in order. The thread that ends the work on a number goes on
// with all numbers that can be finished, unless another thread is about that.
class OrderedCalls {
public:
    OrderedCalls(std::size_t count, const std::function<void(std::size_t i)>& call)
        : is_ready_(count, false),
          call_{call}
    {
    }

    // Notes that the work on number `i` is done.
    void add(std::size_t i)
    {
        std::unique_lock lock{mutex_};
        is_ready_[i] = true;
        if (is_calling_)
            return;
        is_calling_ = true;
        while (next_ < is_ready_.size() && is_ready_[next_] && !exception_) {
            lock.unlock();
            std::exception_ptr exception = thrown_by_next();
            lock.lock();
            exception_ = std::move(exception);
            ++next_;
        }
        is_calling_ = false;
    }

    // The exception of a call. It comes before that of any work in the order of the calls.
    void rethrow() const
    {
        if (exception_)
            std::rethrow_exception(exception_);
    }

private:
    std::exception_ptr thrown_by_next() const
    {
        try {
            call_(next_);
            return nullptr;
        } catch (...) {
            return std::current_exception();
        }
    }

    std::mutex mutex_;
    std::vector<bool> is_ready_;
    const std::function<void(std::size_t i)>& call_;
    std::size_t next_ = 0;  // changed by the calling thread only
    bool is_calling_ = false;
    std::exception_ptr exception_;
};

}  // namespace

void parallel_in_order(std::size_t count, const std::function<void(std::size_t i)>& work,
                       const std::function<void(std::size_t i)>& finish)
{
    OrderedCalls calls{count, finish};
    try {
        parallel_for(count, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                work(i);
                calls.add(i);
            }
        });
    } catch (...) {
        calls.rethrow();
        throw;
    }
    calls.rethrow();
}

void parallel_for(std::size_t count, const Body& body)
{
    Pool::instance().run(count, body);
}

void set_thread_count(int count)
{
    require(1 <= count && count <= 1024, "set_thread_count: need 1 <= count <= 1024");
    Pool::instance().set_threads(count);
}

}  // namespace endmill
