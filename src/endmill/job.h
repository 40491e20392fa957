// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `job`.

#include "endmill/job/child_process.h"
#include "endmill/job/folder_lock.h"
#include "endmill/job/program_options.h"
#include "endmill/job/ranks.h"
#include "endmill/job/sweep.h"
#include "endmill/job/sweep_plan.h"
#include "endmill/job/sweep_workers.h"
