// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/curve_shares.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Tells behind which curves a share may end. Curves are visited in their order.
class Breaks {
public:
    Breaks(std::span<const SectionCurve> curves, CurveCoupling coupling)
        : curves_{curves},
          coupling_{coupling},
          has_closed_{std::ranges::any_of(curves, &SectionCurve::is_closed)}
    {
        if (is_anywhere() || coupling == CurveCoupling::Plane)
            return;
        least_behind_.assign(curves.size() + 1, std::numeric_limits<double>::infinity());
        for (std::size_t k = curves.size(); k-- > 0;)
            least_behind_[k] = std::min(least_behind_[k + 1], s_range(k).first);
    }

    // Whether a share that began behind the last break may end behind curve k.
    bool is_possible_behind(std::size_t k)
    {
        if (is_anywhere())
            return true;
        if (coupling_ == CurveCoupling::Plane)
            return false;
        greatest_so_far_ = std::max(greatest_so_far_, s_range(k).second);
        has_open_ = has_open_ || !curves_[k].is_closed;
        return has_open_ && greatest_so_far_ < least_behind_[k + 1];
    }

    // A share ends behind the last visited curve. A later one needs an open curve, too.
    void begin_share() { has_open_ = false; }

private:
    bool is_anywhere() const { return coupling_ == CurveCoupling::None && !has_closed_; }

    std::pair<double, double> s_range(std::size_t k) const
    {
        const auto s = [](const SectionPoint& point) { return point.x(); };
        const auto [least, greatest] =
            std::ranges::minmax_element(curves_[k].points, {}, s);
        return {least->x(), greatest->x()};
    }

    std::span<const SectionCurve> curves_;
    CurveCoupling coupling_;
    bool has_closed_;
    std::vector<double> least_behind_;  // the least s of curve k and all later ones
    double greatest_so_far_ = -std::numeric_limits<double>::infinity();
    bool has_open_ = false;  // in the share
};

std::size_t points_of(std::span<const SectionCurve> curves)
{
    std::size_t points = 0;
    for (const SectionCurve& curve : curves)
        points += curve.points.size();
    return points;
}

bool has_open(std::span<const SectionCurve> curves)
{
    return !std::ranges::all_of(curves, &SectionCurve::is_closed);
}

SectionPoint least_point(const TrimmedCurve& curve)
{
    return std::ranges::min_element(curve.points, {},
                                    [](const TrimmedPoint& point) {
                                        return std::pair{point.at.x(), point.at.y()};
                                    })
        ->at;
}

// Brings curves into the order of their smallest s, then z; equal ones keep their order.
void sort_by_least_point(std::vector<TrimmedCurve>& curves)
{
    struct Place {
        std::pair<double, double> least;
        std::size_t number;
    };
    std::vector<Place> places;
    places.reserve(curves.size());
    for (const TrimmedCurve& curve : curves) {
        const SectionPoint least = least_point(curve);
        places.push_back({{least.x(), least.y()}, places.size()});
    }
    std::ranges::stable_sort(places, {}, &Place::least);
    std::vector<TrimmedCurve> sorted;
    sorted.reserve(curves.size());
    for (const Place& place : places)
        sorted.push_back(std::move(curves[place.number]));
    curves = std::move(sorted);
}

// Counts the curves of a result from the first curve of the plane.
void renumber(Trimmed& result, std::size_t first)
{
    const auto shift = static_cast<std::int32_t>(first);
    for (TrimmedCurve& curve : result.curves)
        for (TrimmedPoint& point : curve.points) {
            point.on.curve += shift;
            point.across.curve += shift;
        }
    for (AppliedRule& rule : result.rules)
        rule.curve += shift;
}

template <typename Value>
void append(std::vector<Value>& values, std::vector<Value>&& more)
{
    values.insert(values.end(), std::make_move_iterator(more.begin()),
                  std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<CurveShare> curve_shares(std::span<const SectionCurve> curves,
                                     CurveCoupling coupling, std::size_t most)
{
    require(most >= 1, "curve_shares: need at least one share");
    std::vector<CurveShare> shares;
    if (curves.empty())
        return shares;
    const std::size_t points = points_of(curves);
    Breaks breaks{curves, coupling};
    CurveShare share{0, 0};
    std::size_t points_before = 0;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        ++share.count;
        points_before += curves[k].points.size();
        const bool is_possible = breaks.is_possible_behind(k);
        const bool is_full = points_before * most >= points * (shares.size() + 1);
        if (!is_possible || !is_full || shares.size() + 1 == most)
            continue;
        shares.push_back(std::exchange(share, {k + 1, 0}));
        breaks.begin_share();
    }
    if (share.count == 0)
        return shares;
    if (!shares.empty() && !has_open(curves.subspan(share.first)))
        shares.back().count += share.count;
    else
        shares.push_back(share);
    return shares;
}

Trimmed joined(std::span<const CurveShare> shares, std::vector<Trimmed> results)
{
    require(shares.size() == results.size(), "joined: need a result for each share");
    if (results.empty())
        return {};
    Trimmed all = std::move(results.front());
    for (std::size_t k = 1; k < results.size(); ++k) {
        Trimmed& result = results[k];
        renumber(result, shares[k].first);
        append(all.curves, std::move(result.curves));
        append(all.rules, std::move(result.rules));
        all.unresolved += result.unresolved;
        // A share without a closed curve may have no cut that needs the rule.
        if (all.rule.empty())
            all.rule = result.rule;
        result = {};
    }
    if (results.size() > 1)
        sort_by_least_point(all.curves);
    return all;
}

}  // namespace endmill
