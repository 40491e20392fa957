// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "cli/command.h"
#include "endmill/job/sweep.h"

namespace endmill {

/// The progress of a sweep on standard error: a ProgressLine, or with --json-progress a line
/// with a JSON object at most five times a second and at the end: its key `progress` has the
/// keys `done`, `cases`, `failed`, `elapsed_s` and `left_s`.
class SweepProgressView {
public:
    SweepProgressView() = default;                         ///< for derived classes
    virtual ~SweepProgressView() = default;                ///< ends the progress
    SweepProgressView(const SweepProgressView&) = delete;  ///< one view, one owner
    SweepProgressView& operator=(const SweepProgressView&) = delete;  ///< not assignable

    virtual void show(const SweepProgress& state) = 0;  ///< one thread at a time calls it
};

/// The view that the options ask for.
std::unique_ptr<SweepProgressView> sweep_progress(const std::string& work,
                                                  const CommonOptions& options);

}  // namespace endmill
