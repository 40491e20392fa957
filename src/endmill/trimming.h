// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `trimming`.

#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/profile_families.h"
#include "endmill/trimming/refined_planes.h"
#include "endmill/trimming/trimmed_planes.h"
#include "endmill/trimming/trimming.h"
#include "endmill/trimming/trimming_memory.h"
#include "endmill/trimming/trimming_quality.h"
