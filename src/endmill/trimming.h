// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `trimming`.

#include "endmill/trimming/curve_shares.h"
#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/trimmed_planes.h"
#include "endmill/trimming/trimming.h"
#include "endmill/trimming/trimming_methods.h"
#include "endmill/trimming/trimming_quality.h"
