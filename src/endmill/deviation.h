// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `deviation`.

#include "endmill/deviation/deviation.h"
#include "endmill/deviation/part_charts.h"
