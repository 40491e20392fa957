// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `path`.

#include "endmill/path/tool_path.h"
