// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/drop_kinks.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace endmill {
namespace {

// mm. Heights on two contacts that differ by more belong to different contacts. It is
// above rounding and far below the required accuracy.
constexpr double other_contact = 1e-8;
// mm per mm. The same for the slopes of the height.
constexpr double other_slope = 1e-5;
// mm. Contacts nearer than this are the same.
constexpr double same_contact = 1e-6;
// mm. Heights that differ by less are equal, and positions nearer than same_place are
// one.
constexpr double same_height = 1e-12;
constexpr double same_place = 1e-11;
// Enough to halve any distance between two positions down to `same_place`.
constexpr int most_rounds = 100;
// Depth of the search tree: between two positions at most 2^8 - 1 contacts are found,
// each higher than its neighbours.
constexpr int most_depth = 8;

// Searches the kinks of the height between two positions with known contacts:
// 1. If both contacts become the same halfway, there is no kink (goes_over).
// 2. Otherwise both contacts are followed along the line, and the position at which their
//    heights are equal is found by Newton's method within a bracket (kink_of).
// 3. If no third contact is higher there, that position is a kink. Otherwise the third
//    contact splits the interval, and both parts are searched in the same way.
class KinkSearch {
public:
    KinkSearch(const SmoothDrop& drop, const DriveLine& line, FinerPieces& finer)
        : drop_{drop},
          line_{line},
          finer_{finer}
    {
    }

    void search(const DropRest& low, const DropRest& high, int depth)
    {
        if (depth == 0 || goes_over(low, high))
            return;
        const auto kink = kink_of(low, high);
        if (!kink)
            return;
        const DropRest top{kink->s,
                           drop_.highest(kink->contact, line_.axis(kink->s), finer_)};
        if (top.contact.on.height <= kink->contact.on.height) {
            found.push_back(top);
            return;
        }
        search(low, top, depth - 1);
        search(top, high, depth - 1);
    }

    std::vector<DropRest> found;

private:
    // The contact that a known contact becomes when the cutter moves to `s`.
    std::optional<PartContact> moved(const PartContact& contact, double s) const
    {
        return drop_.climb({contact.surface, {contact.on.at.x(), contact.on.at.y()}},
                           line_.axis(s));
    }

    // Whether both contacts become the same halfway, or two with equal height and equal
    // slope on a level place, where one slides into the other.
    bool goes_over(const DropRest& low, const DropRest& high) const
    {
        const double middle = std::midpoint(low.s, high.s);
        const auto a = moved(low.contact, middle);
        const auto b = moved(high.contact, middle);
        return a && b && std::abs(a->on.height - b->on.height) <= other_contact &&
               (a->on.slope - b->on.slope).norm() <= other_slope;
    }

    // The position at which the heights on two contacts are equal. Where one contact has
    // slid into the other, the one that has moved less counts as the higher.
    std::optional<DropRest> kink_of(const DropRest& low, const DropRest& high) const
    {
        DropRest left = low;
        DropRest right = high;
        double s = tangents_meet(low, high);
        for (int round = 0; round < most_rounds; ++round) {
            if (!(left.s < s && s < right.s))
                s = std::midpoint(left.s, right.s);
            const auto a = moved(left.contact, s);
            const auto b = moved(right.contact, s);
            if (!a && !b)
                return std::nullopt;
            const double lead = lead_of(a, b, left.contact, right.contact);
            const bool is_left = lead > 0;
            const DropRest rest{s, is_left ? *a : *b};
            (is_left ? left : right) = rest;
            const double next = a && b ? tangents_meet({s, *a}, {s, *b}) : right.s;
            if (std::abs(lead) <= same_height || std::abs(next - s) <= same_place ||
                right.s - left.s <= same_place)
                return rest;
            s = next;
        }
        return std::nullopt;
    }

    // How much higher contact `a`, which came from `left`, is than `b`, which came from
    // `right`. A contact that was lost counts as below all others.
    static double lead_of(const std::optional<PartContact>& a,
                          const std::optional<PartContact>& b, const PartContact& left,
                          const PartContact& right)
    {
        if (!a || !b)
            return a ? infinite : -infinite;
        if ((a->on.point - b->on.point).norm() > same_contact)
            return a->on.height - b->on.height;
        const double from_left = (a->on.point - left.on.point).norm();
        const double from_right = (a->on.point - right.on.point).norm();
        return from_left < from_right ? infinite : -infinite;
    }

    // The s at which the tangents of the two heights meet: Newton's method for the
    // equation that both heights are equal.
    double tangents_meet(const DropRest& one, const DropRest& other) const
    {
        const double rise = line_.rise(one.contact.on.slope);
        const double other_rise = line_.rise(other.contact.on.slope);
        const double lead = one.contact.on.height - rise * one.s -
                            (other.contact.on.height - other_rise * other.s);
        return lead / (other_rise - rise);
    }

    static constexpr double infinite = 1e300;

    const SmoothDrop& drop_;
    const DriveLine& line_;
    FinerPieces& finer_;
};

}  // namespace

std::vector<DropRest> kinks_between(const SmoothDrop& drop, const DriveLine& line,
                                    const DropRest& low, const DropRest& high,
                                    FinerPieces& finer)
{
    KinkSearch search{drop, line, finer};
    search.search(low, high, most_depth);
    return std::move(search.found);
}

}  // namespace endmill
