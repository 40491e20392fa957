// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `gouge`.

#include "endmill/gouge/gouge_test.h"
