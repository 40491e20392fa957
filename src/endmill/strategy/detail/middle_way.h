// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/strategy/detail/part_samples.h"

namespace endmill {

/// The way along the middle of an island of samples, from one end of it to the other. It is
/// the shortest way between the ends, where a step costs more the nearer it is to the rim.
/// \param samples of the part.
/// \param island  numbers of samples that are connected; at least one.
/// \param depths  of all samples; > 0 on the island, and greater in its middle.
/// \return numbers of samples, each a neighbour of the one before.
std::vector<std::int32_t> middle_way(const PartSamples& samples,
                                     std::span<const std::int32_t> island,
                                     std::span<const double> depths);

}  // namespace endmill
