// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include "endmill/job/program_options.h"

namespace endmill {

/// What the commands of `program` accept, for jobs and sweeps. The options that concern the
/// run and not its result, such as --output and --threads, are left out.
ProgramDescription description_of(const CLI::App& program);

}  // namespace endmill
