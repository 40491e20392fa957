// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/drop_kinks.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace endmill {
namespace {

// mm by which the heights over two contacts differ: above their rounding, and far below
// what is asked of them.
constexpr double other_contact = 1e-8;
// The same of their slopes, mm per mm.
constexpr double other_slope = 1e-5;
// mm: contacts that near are one.
constexpr double same_contact = 1e-6;
// mm: heights over two contacts that are equal, and places that are one.
constexpr double same_height = 1e-12;
constexpr double same_place = 1e-11;
// Halvings of any distance between two places down to `same_place`.
constexpr int most_rounds = 100;
// Contacts between two places, each higher than those beside it, in a tree of this depth.
constexpr int most_depth = 8;

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
    // The contact that a known one becomes where the cutter has gone to `s`.
    std::optional<PartContact> moved(const PartContact& contact, double s) const
    {
        return drop_.climb({contact.surface, {contact.on.at.x(), contact.on.at.y()}},
                           line_.axis(s));
    }

    // Whether both contacts become the same half way, or one that is as high and goes on as
    // the other, on a level place: one that ends there slides into the other.
    bool goes_over(const DropRest& low, const DropRest& high) const
    {
        const double middle = std::midpoint(low.s, high.s);
        const auto a = moved(low.contact, middle);
        const auto b = moved(high.contact, middle);
        return a && b && std::abs(a->on.height - b->on.height) <= other_contact &&
               (a->on.slope - b->on.slope).norm() <= other_slope;
    }

    // Where the heights over two contacts are equal. Where one of them slides into the
    // other, the one that has not moved far is the higher.
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

    // How much higher the contact `a`, once at `left`, is than `b`, once at `right`. One
    // that is lost is below all.
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
