// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `import`.

#include "endmill/import/cad_import.h"
#include "endmill/import/cad_part.h"
#include "endmill/import/cad_stream.h"
