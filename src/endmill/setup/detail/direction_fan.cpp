// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/direction_fan.h"

#include <algorithm>
#include <numbers>

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;

struct PolarDirection {
    double azimuth;  // rad, from 0 to 2 pi
    double polar;    // rad
};

}  // namespace

DirectionFan::DirectionFan(const PolePoints& points)
{
    std::vector<PolarDirection> fan;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double polar = points.polar(i);
        if (polar > pi - equal_angles)
            opposite_ = std::max(opposite_, polar);  // has every azimuth
        else if (polar > equal_angles)
            fan.push_back({full_turn(points.azimuth(i)), polar});
        largest_ = std::max(largest_, polar);
    }
    std::sort(fan.begin(), fan.end(), [](const auto& a, const auto& b) {
        return a.azimuth != b.azimuth ? a.azimuth < b.azimuth : a.polar < b.polar;
    });
    azimuths_.reserve(2 * fan.size());
    polars_.reserve(2 * fan.size());
    for (const double beyond : {0.0, 2 * pi}) {
        for (const PolarDirection& v : fan) {
            azimuths_.push_back(v.azimuth + beyond);
            polars_.push_back(v.polar);
        }
    }
}

SectorCandidate DirectionFan::candidate(double from, double width, double polar,
                                        double other) const
{
    double& larger = polar >= other ? polar : other;
    larger = std::max(larger, opposite_);
    return {full_turn(from), width > equal_angles ? width : 0, polar, other};
}

double RunMaximum::of(std::size_t begin, std::size_t end)
{
    for (; next_ < end; ++next_) {
        while (falling_.size() > head_ &&
               fan_->polar(falling_.back()) <= fan_->polar(next_))
            falling_.pop_back();
        falling_.push_back(next_);
    }
    while (head_ < falling_.size() && falling_[head_] < begin)
        ++head_;
    return begin < end ? fan_->polar(falling_[head_]) : 0;
}

}  // namespace endmill
