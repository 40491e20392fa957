// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "endmill/interference/cut_out.h"
#include "endmill/interference/drive_planes.h"
#include "endmill/interference/trimming.h"

namespace endmill {

/// The curves of each plane before trimming as a CSV file of the columns plane, curve,
/// point, s_mm, x_mm, y_mm, z_mm: reference points, a row a point, numbers from 0.
/// \param placed where the planes stand; null leaves x and y empty.
/// \throws DomainError if a number is not finite, or the planes are fewer than the curves'.
std::string sections_csv(std::span<const std::vector<SectionCurve>> planes,
                         const DrivePlanes* placed);

/// The same of what is left.
std::string trimmed_csv(std::span<const Trimmed> planes, const DrivePlanes* placed);

/// What was cut out as a CSV file of the columns plane, curve, s_mm, z_mm, first_point,
/// last_point, cause and, if `explained`, rule, a row a stretch; curve and points are
/// those of `sections_csv`, s and z empty where the stretch ends in no place.
/// \throws DomainError if a number is not finite.
std::string loops_csv(std::span<const std::vector<CutOut>> planes, bool explained);

}  // namespace endmill
