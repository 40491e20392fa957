// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "cli/trim_options.h"

namespace endmill {

/// The parts of the work on a surface, in their order. Those from `Trimming` on are repeated
/// for each method.
enum class TrimStage {
    Slicing,
    WritingSections,
    Trimming,
    Sampling,
    Loops,
    Clearance,
    Linking,
    WritingCurves,
    WritingPath,
};

/// The work that follows a stage, as a multiple of its own, for an estimate of the time left.
/// It is rough: the parts are compared on one surface with folds.
/// \param stage   the stage.
/// \param options name the methods that run.
/// \param method  the method that the stage is part of; empty before `Trimming`.
double work_after(TrimStage stage, const TrimOptions& options,
                  std::string_view method = {});

}  // namespace endmill
