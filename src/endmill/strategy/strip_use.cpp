// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/strip_use.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/strategy/detail/covered_part.h"
#include "endmill/strategy/detail/reach.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/tool_side.h"

// Places of the part are kept in cells of a grid in plan. Each move takes away the places
// that it covers, and their area is its own.

namespace endmill {
namespace {

constexpr double most_places = 2e5;
constexpr double places_across =
    12;  // at least this many across a strip, if they suffice
constexpr double stretch_widths = 2;  // length of a stretch in strip widths
constexpr double longest_in_radii =
    4;  // longer moves are divided, so that few cells count
// Places along a patch from which the lengths of its sides are taken.
constexpr int measured_places = 5;

struct Place {
    Vec3 raised;  // by the scallop height
    double area;  // mm^2
};

// Collects places of equal weight from many small pieces of area.
class Places {
public:
    // \param area of the part, mm^2.
    Places(double height, double width, double area)
        : height_{height},
          area_each_{std::max(area / most_places, std::pow(width / places_across, 2))}
    {
    }

    double spacing() const { return std::sqrt(area_each_); }

    void add(const Vec3& point, const Vec3& normal, double area)
    {
        saved_ += area;
        if (saved_ < area_each_ / 2)
            return;
        places_.push_back({point + height_ * normal, saved_});
        saved_ = 0;
    }

    std::vector<Place> taken() { return std::move(places_); }

private:
    double height_;
    double area_each_;
    double saved_ = 0;  // area of pieces without a place so far
    std::vector<Place> places_;
};

// The number of cells along a side of a patch.
int cells_along(const Surface& surface, int i, int j, Parameter along, double spacing)
{
    const Interval u{surface.breaks(Parameter::U)[i],
                     surface.breaks(Parameter::U)[i + 1]};
    const Interval v{surface.breaks(Parameter::V)[j],
                     surface.breaks(Parameter::V)[j + 1]};
    const Interval range = along == Parameter::U ? u : v;
    double longest = 0;
    for (int a = 0; a < measured_places; ++a)
        for (int b = 0; b < measured_places; ++b) {
            const SurfaceJet jet = surface.jet_in_patch(
                i, j, std::lerp(u.low, u.high, (a + 0.5) / measured_places),
                std::lerp(v.low, v.high, (b + 0.5) / measured_places));
            longest = std::max(longest, (along == Parameter::U ? jet.du : jet.dv).norm());
        }
    return std::max(1,
                    static_cast<int>(longest * (range.high - range.low) / spacing) + 1);
}

void add_patch(const Surface& surface, double side, int i, int j, Places& places)
{
    const Interval u{surface.breaks(Parameter::U)[i],
                     surface.breaks(Parameter::U)[i + 1]};
    const Interval v{surface.breaks(Parameter::V)[j],
                     surface.breaks(Parameter::V)[j + 1]};
    const int columns = cells_along(surface, i, j, Parameter::U, places.spacing());
    const int rows = cells_along(surface, i, j, Parameter::V, places.spacing());
    const double cell = (u.high - u.low) / columns * (v.high - v.low) / rows;
    for (int column = 0; column < columns; ++column)
        for (int row = 0; row < rows; ++row) {
            const SurfaceJet jet = surface.jet_in_patch(
                i, j, std::lerp(u.low, u.high, (column + 0.5) / columns),
                std::lerp(v.low, v.high, (row + 0.5) / rows));
            const Vec3 normal = side * jet.du.cross(jet.dv);
            if (normal.norm() > 0)
                places.add(jet.point, normal.normalized(), normal.norm() * cell);
        }
}

void add_facet(const std::array<Vec3, 3>& corners, Places& places)
{
    const auto& [a, b, c] = corners;
    const Vec3 normal = (b - a).cross(c - a);
    if (normal.z() <= 0)
        return;
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int parts =
        std::max(1, static_cast<int>(std::ceil(longest / places.spacing())));
    const double area = normal.norm() / 2 / parts / parts;
    // the middles of the small triangles that point like the facet, and of the others
    for (int i = 0; i < parts; ++i)
        for (int j = 0; i + j < parts; ++j)
            for (const double third : {1.0, 2.0}) {
                if (third == 2 && i + j + 1 == parts)
                    continue;
                const double s = (i + third / 3) / parts;
                const double t = (j + third / 3) / parts;
                places.add(a + s * (b - a) + t * (c - a), normal.normalized(), area);
            }
}

std::vector<Place> places_on(const Part& part, double height, double width)
{
    if (const auto* mesh = std::get_if<TriangleMesh>(&part)) {
        double area = 0;
        for (std::size_t k = 0; k < mesh->triangles().size(); ++k) {
            const auto& [a, b, c] = mesh->corners(k);
            area += (b - a).cross(c - a).norm() / 2;
        }
        Places places{height, width, area};
        for (std::size_t k = 0; k < mesh->triangles().size(); ++k)
            add_facet(mesh->corners(k), places);
        return places.taken();
    }
    const auto& surfaces = std::get<std::vector<Surface>>(part);
    const std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    Places places{height, width, area(surfaces)};
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        for (int i = 0; i < surfaces[k].patches(Parameter::U); ++i)
            for (int j = 0; j < surfaces[k].patches(Parameter::V); ++j)
                add_patch(surfaces[k], sides[k], i, j, places);
    return places.taken();
}

// The places that no move has covered yet, in cells in plan.
class UncoveredPlaces {
public:
    UncoveredPlaces(const std::vector<Place>& places, double radius, double cell)
        : radius_{radius},
          per_mm_{1 / cell}
    {
        for (const Place& place : places)
            box_.extend(place.raised.head<2>());
        if (places.empty())
            return;
        const Eigen::Vector2d size = per_mm_ * box_.sizes();
        columns_ = static_cast<int>(size.x()) + 1;
        rows_ = static_cast<int>(size.y()) + 1;
        cells_.resize(static_cast<std::size_t>(columns_) * rows_);
        for (const Place& place : places)
            cells_[number(column(place.raised.x()), row(place.raised.y()))].push_back(
                place);
    }

    // Takes away what a move of the centre covers. Returns its area in mm^2.
    double cover(const Vec3& from, const Vec3& to)
    {
        const int parts =
            std::max(1, static_cast<int>(std::ceil((to - from).norm() /
                                                   (longest_in_radii * radius_))));
        double sum = 0;
        for (int k = 0; k < parts; ++k)
            sum += cover_part(from + double(k) / parts * (to - from),
                              from + double(k + 1) / parts * (to - from));
        return sum;
    }

private:
    int column(double x) const
    {
        return std::clamp(static_cast<int>(per_mm_ * (x - box_.min().x())), 0,
                          columns_ - 1);
    }
    int row(double y) const
    {
        return std::clamp(static_cast<int>(per_mm_ * (y - box_.min().y())), 0, rows_ - 1);
    }
    std::size_t number(int column, int row) const
    {
        return static_cast<std::size_t>(row) * columns_ + column;
    }

    double cover_part(const Vec3& from, const Vec3& to)
    {
        if (cells_.empty())
            return 0;
        const UprightSweep sweep{from, to};
        double sum = 0;
        const int last_row = row(std::max(from.y(), to.y()) + radius_);
        const int last_column = column(std::max(from.x(), to.x()) + radius_);
        for (int j = row(std::min(from.y(), to.y()) - radius_); j <= last_row; ++j)
            for (int i = column(std::min(from.x(), to.x()) - radius_); i <= last_column;
                 ++i)
                sum += cover_in(cells_[number(i, j)], sweep);
        return sum;
    }

    double cover_in(std::vector<Place>& places, const UprightSweep& sweep) const
    {
        double sum = 0;
        std::size_t kept = 0;
        for (const Place& place : places) {
            if (sweep.squared_distance(place.raised) <= radius_ * radius_)
                sum += place.area;
            else
                places[kept++] = place;
        }
        places.resize(kept);
        return sum;
    }

    double radius_;
    double per_mm_;
    Eigen::AlignedBox2d box_;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::vector<Place>> cells_;
};

const Vec3& contact_or_tip(const PathPoint& point)
{
    return point.contact() ? point.contact()->contact.point : point.location.tip;
}

}  // namespace

std::vector<double> strip_use(const Part& part, const ToolPath& path,
                              const BallCutter& cutter, double scallop_height)
{
    const double R = cutter.radius();
    require(0 < scallop_height && scallop_height < R,
            "strip_use: need 0 < scallop height < cutter radius");
    const double width = strip_width(cutter, scallop_height);
    UncoveredPlaces uncovered{places_on(part, scallop_height, width), R, width / 2};
    const auto centre = [&](std::size_t k) -> Vec3 {
        return path.points[k].location.tip + R * Vec3::UnitZ();
    };
    std::vector<double> use(path.points.size());
    double area = 0;
    double length = 0;
    std::size_t first = 1;  // move of the present stretch
    const auto finish = [&](std::size_t end) {
        if (length > 0)
            std::fill(use.begin() + static_cast<std::ptrdiff_t>(first),
                      use.begin() + static_cast<std::ptrdiff_t>(end),
                      area / (length * width));
        area = 0;
        length = 0;
        first = end;
    };
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const Move move = path.points[k].move;
        if (move != Move::Cut) {
            finish(k);
            first = k + 1;
            if (move == Move::Link)
                uncovered.cover(centre(k - 1), centre(k));
            continue;
        }
        area += uncovered.cover(centre(k - 1), centre(k));
        length +=
            (contact_or_tip(path.points[k]) - contact_or_tip(path.points[k - 1])).norm();
        if (length >= stretch_widths * width)
            finish(k + 1);
    }
    finish(path.points.size());
    return use;
}

}  // namespace endmill
