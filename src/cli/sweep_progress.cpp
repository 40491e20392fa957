// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_progress.h"

#include <chrono>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "cli/progress.h"

namespace endmill {
namespace {

class Line final : public SweepProgressView {
public:
    Line(const std::string& work, const CommonOptions& options) : line_{work, options} {}

    void show(const SweepProgress& state) override
    {
        line_.show(fmt::format("{} of {} cases, {} failed", state.done, state.cases,
                               state.failed),
                   share_of_this_run(state));
    }

private:
    // The time left follows from the cases of this run.
    static double share_of_this_run(const SweepProgress& state)
    {
        return static_cast<double>(state.done - state.before) /
               static_cast<double>(state.cases - state.before);
    }

    ProgressLine line_;
};

class JsonLines final : public SweepProgressView {
public:
    void show(const SweepProgress& state) override
    {
        constexpr std::chrono::milliseconds interval{200};
        const auto now = Clock::now();
        if (state.done < state.cases && now < next_)
            return;
        next_ = now + interval;
        const double elapsed = std::chrono::duration<double>(now - start_).count();
        const auto done = static_cast<double>(state.done - state.before);
        const auto rest = static_cast<double>(state.cases - state.done);
        Json line{{"done", state.done},
                  {"cases", state.cases},
                  {"failed", state.failed},
                  {"elapsed_s", rounded(elapsed)},
                  {"left_s", nullptr}};
        if (done > 0)
            line["left_s"] = rounded(elapsed * rest / done);
        std::fprintf(stderr, "%s\n", line.dump().c_str());
    }

private:
    using Clock = std::chrono::steady_clock;

    static double rounded(double seconds) { return std::round(10 * seconds) / 10; }

    Clock::time_point start_ = Clock::now();
    Clock::time_point next_ = start_;
};

}  // namespace

std::unique_ptr<SweepProgressView> sweep_progress(const std::string& work,
                                                  const CommonOptions& options,
                                                  bool as_json)
{
    if (as_json)
        return std::make_unique<JsonLines>();
    return std::make_unique<Line>(work, options);
}

}  // namespace endmill
