// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "endmill/strategy/detail/covered_part.h"
#include "endmill/strategy/detail/pass_moves.h"

namespace endmill {

/// Contacts in steps of the samples' distance at most, straight in the parameters of a surface,
/// from one contact to another, both included.
/// \pre samples.is_joined(from, to)
std::vector<PassContact> steps_along(const PassContact& from, const PassContact& to,
                                     const PartSamples& samples);

/// A link on which the ball remains in contact with the part, so that it is a cut: the way
/// along the part between two contacts, divided into few moves as a pass is. It is straight
/// in the parameters of a surface.
/// \param from, to where it begins and ends.
/// \param samples  of the part.
/// \param part     tests the moves.
/// \param limits   of the moves.
/// \return the contacts from `from` to `to`, both included; nothing if the way is not short,
///         or if some move is not clear.
std::optional<std::vector<PassContact>> contact_link(const PassContact& from,
                                                     const PassContact& to,
                                                     const PartSamples& samples,
                                                     const CoveredPart& part,
                                                     const MoveLimits& limits);

}  // namespace endmill
