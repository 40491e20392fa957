// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/setup_answer.h"
#include "endmill/files/output_folder.h"

namespace endmill {

/// Writes visibility.bsm and cones.csv, and with --write-bsm-csv visibility.csv. If
/// there is a pose, also writes setup.vtp, setup.svg and sphere.svg.
void write_setup_files(const SetupInput& input, const SetupVisibility& visibility,
                       const SetupAnswer& answer, const SetupCommandOptions& options,
                       OutputFolder& folder);

}  // namespace endmill
