// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `bound`.

#include "endmill/bound/bound_problem.h"
#include "endmill/bound/path_bound.h"
#include "endmill/bound/points_bound.h"
