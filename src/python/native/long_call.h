// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <optional>
#include <utility>

#include <pybind11/pybind11.h>

/// \file
/// Long calls: other Python threads run meanwhile, Ctrl-C ends the call, and a Python function
/// may follow its progress.

namespace endmill::python {

namespace py = pybind11;

/// The finished share of a long call, which its threads report.
class Progress {
public:
    /// Takes the finished share, 0 to 1, of any thread. Throws if the call shall end.
    void report(double share)
    {
        double seen = share_.load(std::memory_order_relaxed);
        while (share > seen && !share_.compare_exchange_weak(seen, share)) {
        }
        if (is_stopped_.load(std::memory_order_relaxed))
            throw Stopped{};
    }

    double share() const { return share_.load(); }  ///< the greatest share so far
    void stop() { is_stopped_ = true; }             ///< the next report ends the call

private:
    struct Stopped : std::exception {};

    std::atomic<double> share_ = 0;
    std::atomic<bool> is_stopped_ = false;
};

/// Runs `work(progress)` in a thread of its own, without Python's lock. The caller looks for
/// signals and calls `follower` with the finished share, 0 to 1, twenty times a second. If
/// one of them raises an exception, the work ends at its next report, and the exception goes on.
/// \param follower a Python function of one number, or None.
template <typename Work>
auto long_call(const py::object& follower, const Work& work)
{
    constexpr std::chrono::milliseconds interval{50};
    Progress progress;
    auto result = std::async(std::launch::async, [&] { return work(progress); });
    std::optional<py::error_already_set> raised;
    const auto is_done = [&] {
        const py::gil_scoped_release release;
        return result.wait_for(interval) == std::future_status::ready;
    };
    while (!is_done()) {
        if (raised)
            continue;
        try {
            if (PyErr_CheckSignals() != 0)
                throw py::error_already_set();
            if (!follower.is_none())
                follower(progress.share());
        } catch (py::error_already_set& error) {
            raised.emplace(std::move(error));
            progress.stop();
        }
    }
    if (raised)
        throw std::move(*raised);
    return result.get();
}

}  // namespace endmill::python
