// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/cutter.h"

#include "endmill/core/error.h"

namespace endmill {

Cutter with_allowance(const Cutter& cutter, double allowance)
{
    require(std::isfinite(allowance) && allowance >= 0,
            "with_allowance: need 0 <= allowance");
    return {cutter.radius() + allowance, cutter.corner_radius() + allowance};
}

}  // namespace endmill
