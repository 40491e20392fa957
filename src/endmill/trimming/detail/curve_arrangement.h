// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/offset/section_curve.h"

namespace endmill {

/// The curves as sections are stored: each turned and begun as SectionCurve says, all in
/// the order of their smallest s, of equal ones of z there. An open curve whose ends have
/// equal s keeps its direction.
/// \pre no curve has fewer than two points, a closed one ends with its first.
std::vector<SectionCurve> arranged(std::vector<SectionCurve> curves);

}  // namespace endmill
