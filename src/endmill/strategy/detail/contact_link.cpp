// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/contact_link.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace endmill {

std::vector<PassContact> steps_along(const PassContact& from, const PassContact& to,
                                     const PartSamples& samples)
{
    const double distance = (to.at.contact.point - from.at.contact.point).norm();
    const auto steps =
        std::max(1, static_cast<int>(std::ceil(distance / samples.spacing())));
    std::vector<PassContact> contacts{from};
    contacts.reserve(static_cast<std::size_t>(steps) + 1);
    for (int k = 1; k < steps; ++k)
        contacts.push_back(samples.between(from, to, static_cast<double>(k) / steps));
    contacts.push_back(to);
    return contacts;
}

std::optional<std::vector<PassContact>> contact_link(const PassContact& from,
                                                     const PassContact& to,
                                                     const PartSamples& samples,
                                                     const CoveredPart& part,
                                                     const MoveLimits& limits)
{
    if (!samples.is_joined(from, to))
        return std::nullopt;
    std::vector<LaidPass> pieces = divided_into_moves(
        {steps_along(from, to, samples), false}, samples, part, limits);
    if (pieces.size() != 1 || pieces[0].contacts.size() < 2 ||
        !is_same_place(pieces[0].contacts.front(), from) ||
        !is_same_place(pieces[0].contacts.back(), to))
        return std::nullopt;
    return std::move(pieces[0].contacts);
}

}  // namespace endmill
