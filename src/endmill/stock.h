// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `stock`.

#include "endmill/stock/dexel_stock.h"
#include "endmill/stock/height_stock.h"
#include "endmill/stock/mesh_stock.h"
#include "endmill/stock/removal.h"
#include "endmill/stock/stock_engagement.h"
#include "endmill/stock/stock_history.h"
