// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/trimming_methods.h"

namespace endmill {

/// Method 3 with the range of its search as printed: with literal detection it runs from
/// the third change of slope to the end of the curve. Method 3 of `trimming_methods` ends
/// with the run of dz that begins there.
/// Source: [JangKimJeong, section IV.3].
const TrimmingMethod& printed_method_3();

/// The options of the paper's method 3: literal detection.
inline constexpr TrimmingOptions printed_options{.detection = FoldDetection::Literal};

}  // namespace endmill
