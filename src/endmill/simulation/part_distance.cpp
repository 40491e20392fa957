// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/part_distance.h"

#include <algorithm>

#include "endmill/surface/sampling.h"

namespace endmill {
namespace {

constexpr double longest = 1e9;      // mm
constexpr int most_shrinkings = 60;  // far more than it takes but where nothing is free
constexpr double rounding = 1e-9;    // of a ball's radius

}  // namespace

PartDistance::PartDistance(const PartCharts& charts, double chord_tolerance)
    : charts_{charts},
      chord_tolerance_{chord_tolerance}
{
}

void PartDistance::prepare() const
{
    std::call_once(is_prepared_, [this] {
        if (charts_.mesh())
            return;
        pieces_.emplace(charts_.surfaces(), chord_tolerance_);
        chord_error_ = pieces_->chord_error();
    });
}

// The part's triangles. Those of surfaces meet without gaps, as the pieces' do not.
const TriangleTree& PartDistance::whole() const
{
    std::call_once(is_whole_made_, [this] {
        if (charts_.mesh()) {
            whole_.emplace(*charts_.mesh());
            return;
        }
        sampled_ = sampled(charts_.surfaces(), charts_.sides(), chord_tolerance_).mesh;
        whole_.emplace(sampled_);
    });
    return *whole_;
}

NearestPoint PartDistance::nearest(const Vec3& place,
                                   std::optional<std::size_t>& hint) const
{
    prepare();
    const NearestPoint found =
        pieces_ ? pieces_->nearest(place, hint) : *whole().nearest(place, hint);
    hint = found.triangle;
    return found;
}

double PartDistance::operator()(const Vec3& place, std::optional<std::size_t>& hint) const
{
    return nearest(place, hint).distance + chord_error_;
}

double PartDistance::free_length(const Vec3& foot, const Vec3& direction, double length,
                                 std::optional<std::size_t>& hint) const
{
    double free = std::min(length, longest);
    for (int i = 0; i < most_shrinkings; ++i) {
        const Vec3 centre = foot + free * direction;
        const NearestPoint other = nearest(centre, hint);
        if (other.distance + chord_error_ >= free * (1 - rounding))
            return free == length ? length : std::max(0.0, free - uncertainty());
        // The ball that touches the foot and goes through the other place.
        const Vec3 away = other.point - foot;
        const double over = away.dot(direction);
        const double through = over > 0 ? away.squaredNorm() / (2 * over) : 0;
        free = std::min(through, (free + other.distance) / 2);
    }
    return 0;
}

double PartDistance::uncertainty() const
{
    prepare();
    return 2 * chord_error_;
}

bool PartDistance::is_over_or_under(const Vec3& place) const
{
    return whole().any_hit({place, Vec3::UnitZ()}) ||
           whole().any_hit({place, -Vec3::UnitZ()});
}

}  // namespace endmill
