// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `page`.

#include "endmill/page/page.h"
#include "endmill/page/reduction.h"
