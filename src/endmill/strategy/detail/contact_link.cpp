// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/contact_link.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace endmill {

std::optional<std::vector<PassContact>> contact_link(const PassContact& from,
                                                     const PassContact& to,
                                                     const PartSamples& samples,
                                                     const CoveredPart& part,
                                                     const MoveLimits& limits)
{
    const double distance = (to.at.contact.point - from.at.contact.point).norm();
    if (!samples.is_joined(from, to))
        return std::nullopt;
    const auto steps =
        std::max(1, static_cast<int>(std::ceil(distance / samples.spacing())));
    LaidPass way{{from}, false};
    way.contacts.reserve(static_cast<std::size_t>(steps) + 1);
    for (int k = 1; k < steps; ++k)
        way.contacts.push_back(samples.between(from, to, static_cast<double>(k) / steps));
    way.contacts.push_back(to);
    std::vector<LaidPass> pieces = divided_into_moves(way, samples, part, limits);
    const auto is_at = [](const PassContact& a, const PassContact& b) {
        return a.at.contact.point == b.at.contact.point;
    };
    if (pieces.size() != 1 || pieces[0].contacts.size() < 2 ||
        !is_at(pieces[0].contacts.front(), from) || !is_at(pieces[0].contacts.back(), to))
        return std::nullopt;
    return std::move(pieces[0].contacts);
}

}  // namespace endmill
