// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/one_way_passes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace endmill {
namespace {

constexpr double longest_move = 10;  // mm

// Geometry at a contact of a pass along x.
struct PassContact {
    Vec3 at;
    Vec3 feed;        // T, unit
    Vec3 normal;      // N, unit, upwards
    Vec3 across;      // T x N
    double spread;    // |r_y x T|: distance on the surface per mm of y
    double k_across;  // 1/mm, normal curvature across the feed, positive where convex
    double k_along;   // 1/mm, of the section along x, signed
};

PassContact pass_contact(const OneWayPasses& plan, double x, double y)
{
    const HeightJet jet = plan.surface(x, y);
    PassContact contact;
    contact.at = {x, y, jet.z};
    contact.feed = Vec3{1, 0, jet.zx}.normalized();
    contact.normal = Vec3{-jet.zx, -jet.zy, 1}.normalized();
    contact.across = contact.feed.cross(contact.normal);
    contact.spread = Vec3{0, 1, jet.zy}.cross(contact.feed).norm();
    const double a = contact.across.x();
    const double b = contact.across.y();
    contact.k_across =
        -(jet.zxx * a * a + 2 * jet.zxy * a * b + jet.zyy * b * b) * contact.normal.z();
    contact.k_along = jet.zxx / std::pow(1 + jet.zx * jet.zx, 1.5);
    return contact;
}

// Distance in y to the next pass, mm.
double interval(const OneWayPasses& plan, double y)
{
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= plan.samples; ++i) {
        const double x = plan.extent.x.low + plan.extent.x.length() * i / plan.samples;
        const PassContact contact = pass_contact(plan, x, y);
        const double on_surface =
            std::sqrt(8 * plan.cusp * plan.radius / (1 + plan.radius * contact.k_across));
        least = std::min(least, on_surface / contact.spread);
    }
    return least;
}

Vec3 centre(const OneWayPasses& plan, double x, double y)
{
    const PassContact contact = pass_contact(plan, x, y);
    return contact.at + plan.radius * contact.normal;
}

// A move between two contacts of a pass.
struct PassMove {
    double begin;
    double end;
    double y;
    double back;  // distance in y to the pass before, mm; 0 for the first pass
};

SegmentCut cut_of(const OneWayPasses& plan, const PassMove& move)
{
    const PassContact middle = pass_contact(plan, (move.begin + move.end) / 2, move.y);
    SegmentCut cut;
    cut.length_mm =
        (centre(plan, move.end, move.y) - centre(plan, move.begin, move.y)).norm();
    cut.lambda = std::asin(middle.feed.z());
    cut.mu = std::atan2(middle.across.z(), middle.normal.z());
    cut.depth_mm = plan.stock_top - middle.at.z() + plan.radius * (1 - middle.normal.z());
    cut.previous = plan.first_pass;
    if (move.back > 0) {
        cut.previous = PreviousPass::Beside;
        cut.pick_feed_mm =
            move.back * middle.spread * (1 + plan.radius * middle.k_across);
        cut.pick_feed_horizontal_mm = *cut.pick_feed_mm * std::cos(*cut.mu);
    }
    return cut;
}

// x of the end of the move that begins at x.
double next_x(const OneWayPasses& plan, double x, double y)
{
    const PassContact begin = pass_contact(plan, x, y);
    const double chord = std::sqrt(8 * plan.outside_tolerance / std::abs(begin.k_along));
    const double step = std::min(longest_move, chord);
    return std::min(plan.extent.x.high, x + step * begin.feed.x());
}

void add_point(ToolPath& path, const Vec3& tip, int pass, Move move)
{
    const bool is_new = path.points.empty() || path.points.back().pass != pass;
    path.points.push_back({.pass = pass,
                           .point = is_new ? 0 : path.points.back().point + 1,
                           .move = move,
                           .location = {tip, Vec3::UnitZ()}});
}

}  // namespace

std::vector<double> pass_places(const OneWayPasses& plan)
{
    std::vector<double> places{plan.extent.y.low};
    while (places.back() < plan.extent.y.high)
        places.push_back(
            std::min(plan.extent.y.high, places.back() + interval(plan, places.back())));
    return places;
}

MilledPath milled_path(const OneWayPasses& plan)
{
    std::vector<double> places = pass_places(plan);
    std::ranges::reverse(places);
    MilledPath milled;
    for (std::size_t pass = 0; pass < places.size(); ++pass) {
        const double y = places[pass];
        const double back = pass == 0 ? 0 : places[pass - 1] - y;
        double x = plan.extent.x.low;
        for (int point = 1; x < plan.extent.x.high; ++point) {
            const PassMove move{x, next_x(plan, x, y), y, back};
            milled.cuts.push_back(cut_of(plan, move));
            milled.cuts.back().pass = static_cast<int>(pass);
            milled.cuts.back().point = point;
            milled.from.push_back(centre(plan, move.begin, y));
            milled.to.push_back(centre(plan, move.end, y));
            x = move.end;
        }
    }
    return milled;
}

double length_mm(const std::vector<SegmentCut>& cuts)
{
    double sum = 0;
    for (const SegmentCut& cut : cuts)
        sum += cut.length_mm;
    return sum;
}

std::vector<SegmentCut> stretched(std::vector<SegmentCut> cuts, double length_mm)
{
    const double factor = length_mm / endmill::length_mm(cuts);
    for (SegmentCut& cut : cuts)
        cut.length_mm *= factor;
    return cuts;
}

ToolPath milled_tool_path(const MilledPath& milled, double radius, double safe_height)
{
    ToolPath path;
    const auto lift = [&](Vec3 tip, int pass, Move move) {
        tip.z() = safe_height;
        add_point(path, tip, pass, move);
    };
    for (std::size_t i = 0; i < milled.cuts.size(); ++i) {
        const int pass = milled.cuts[i].pass;
        const Vec3 begin = milled.from[i] - radius * Vec3::UnitZ();
        if (i == 0 || milled.cuts[i - 1].pass != pass) {
            lift(begin, pass, Move::Rapid);
            add_point(path, begin, pass, Move::Plunge);
        }
        const Vec3 end = milled.to[i] - radius * Vec3::UnitZ();
        add_point(path, end, pass, Move::Cut);
        if (i + 1 == milled.cuts.size() || milled.cuts[i + 1].pass != pass)
            lift(end, pass, Move::Retract);
    }
    return path;
}

double noncut_travel_mm(const MilledPath& milled, double radius, double return_z,
                        double overrun)
{
    const ToolPath path = milled_tool_path(milled, radius, return_z);
    double travel = (milled.to.back() - milled.from.front()).head<2>().norm();
    for (std::size_t i = 1; i < path.points.size(); ++i)
        if (path.points[i].move != Move::Cut)
            travel +=
                (path.points[i].location.tip - path.points[i - 1].location.tip).norm();
    return travel + overrun * (milled.cuts.back().pass + 1);
}

}  // namespace endmill
