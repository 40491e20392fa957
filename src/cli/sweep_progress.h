// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "cli/command.h"
#include "endmill/job/sweep.h"

namespace endmill {

/// The progress of a sweep on standard error: a ProgressLine, or with --json-progress one JSON
/// object a line, at most five a second and one at the end.
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
                                                  const CommonOptions& options,
                                                  bool as_json);

}  // namespace endmill
