// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/surface_families.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double width_x = 200;  // mm. Source: [KimChoi, fig. 2].
constexpr double width_y = 120;
constexpr int patches_x = 3;
constexpr int patches_y = 2;
constexpr double most_height =
    180;  // mm, either sign, relative to the first control point
constexpr double most_offset = 60;  // mm, sideways
// Largest shift of a control point along its curve, as a share of the distance of two.
constexpr double most_shift = 0.7;
constexpr double height_step = 10;  // mm, of SurfaceFamily::Tens

using Values = std::span<const double>;
using Numbers = std::vector<double>;

// Takes numbers from the front of a list.
class Reader {
public:
    explicit Reader(Values values) : values_{values} {}

    double next()
    {
        const double value = values_.front();
        values_ = values_.subspan(1);
        return value;
    }

private:
    Values values_;
};

bool is_joint(int i, int patches)
{
    return i % 3 == 0 && i > 0 && i < 3 * patches;
}

// One coordinate of the control points: `at` gives those that are not joints, a joint is the
// mean of its neighbours.
template <typename At>
Numbers joined(int patches, const At& at)
{
    Numbers numbers(3 * static_cast<std::size_t>(patches) + 1);
    for (int i = 0; i <= 3 * patches; ++i)
        if (!is_joint(i, patches))
            numbers[i] = at(i);
    for (int i = 3; i < 3 * patches; i += 3)
        numbers[i] = (numbers[i - 1] + numbers[i + 1]) / 2;
    return numbers;
}

// Control points that start at 0 and then take free values.
Numbers free_coordinate(int patches, Reader& reader)
{
    return joined(patches, [&](int i) { return i == 0 ? 0 : reader.next(); });
}

Numbers even_coordinate(int patches, double width)
{
    return joined(patches, [&](int i) { return width * i / (3.0 * patches); });
}

CompositeCurve curve_over_x(const Numbers& x, const Numbers& y, const Numbers& z)
{
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < x.size(); ++i)
        points.emplace_back(x[i], y[i], z[i]);
    return CompositeCurve{std::move(points)};
}

struct CurvePair {
    Numbers ax, ay, az;
    Numbers bx, by, bz;

    TranslationalSurface surface() const
    {
        return {curve_over_x(ax, ay, az), curve_over_x(bx, by, bz)};
    }
};

CurvePair even_pair()
{
    return {even_coordinate(patches_x, width_x), Numbers(3 * patches_x + 1, 0.0),
            Numbers(3 * patches_x + 1, 0.0),     Numbers(3 * patches_y + 1, 0.0),
            even_coordinate(patches_y, width_y), Numbers(3 * patches_y + 1, 0.0)};
}

CurvePair pair_with_heights(Reader& reader)
{
    CurvePair pair = even_pair();
    pair.az = free_coordinate(patches_x, reader);
    pair.bz = free_coordinate(patches_y, reader);
    return pair;
}

// Shifts the control points that are neither joints nor ends.
void shift(Numbers& coordinate, int patches, Reader& reader)
{
    const Numbers even = coordinate;
    coordinate = joined(patches, [&](int i) {
        return i == 0 || i == 3 * patches ? even[i] : even[i] + reader.next();
    });
}

TranslationalSurface symmetric_surface(Reader& reader)
{
    CurvePair pair = even_pair();
    const auto mirrored = [&](int patches) {
        Numbers half(static_cast<std::size_t>(3 * patches) / 2 + 1, 0.0);
        for (int i = 1; i < static_cast<int>(half.size()); ++i)
            if (!is_joint(i, patches))
                half[i] = reader.next();
        return joined(patches, [&](int i) { return half[std::min(i, 3 * patches - i)]; });
    };
    pair.az = mirrored(patches_x);
    pair.bz = mirrored(patches_y);
    return pair.surface();
}

Surface net_of_heights(const std::function<double(int column, int row)>& height)
{
    std::vector<Vec3> net;
    for (int row = 0; row <= 3 * patches_y; ++row)
        for (int column = 0; column <= 3 * patches_x; ++column)
            net.emplace_back(width_x * column / (3.0 * patches_x),
                             width_y * row / (3.0 * patches_y), height(column, row));
    return composite_bezier(patches_x, patches_y, net);
}

Surface swept_surface(Reader& reader)
{
    const Numbers a = free_coordinate(patches_x, reader);
    const Numbers b = free_coordinate(patches_y, reader);
    const double growth = reader.next();
    return net_of_heights([&](int column, int row) {
        return a[column] * (1 + growth * row / (3.0 * patches_y)) + b[row];
    });
}

// A bicubic patch without twists in x, y and z has regular x and y, so that only heights and
// slopes are free. The control points next to a corner are a slope away, the inner ones the
// sum of two slopes.
Surface ferguson_surface(Reader& reader)
{
    struct Corner {
        double z;
        double slope_u;
        double slope_v;
    };
    std::array<std::array<Corner, patches_x + 1>, patches_y + 1> corners{};
    for (auto& row : corners)
        for (Corner& corner : row) {
            corner.z = &corner == &corners[0][0] ? 0 : reader.next();
            corner.slope_u = reader.next();
            corner.slope_v = reader.next();
        }
    // Control point i belongs to the nearest corner; i % 3 - 1 steps away from it.
    const auto nearest = [](int i) { return (i + 1) / 3; };
    return net_of_heights([&](int column, int row) {
        const int i = nearest(column);
        const int j = nearest(row);
        const Corner& corner = corners[j][i];
        return corner.z + (column - 3 * i) * corner.slope_u +
               (row - 3 * j) * corner.slope_v;
    });
}

Surface net_surface(Reader& reader)
{
    std::vector<Numbers> rows(3 * patches_y + 1);
    for (int row = 0; row <= 3 * patches_y; ++row)
        if (!is_joint(row, patches_y))
            rows[row] = joined(patches_x, [&](int column) {
                return row == 0 && column == 0 ? 0 : reader.next();
            });
    for (int row = 3; row < 3 * patches_y; row += 3)
        for (std::size_t i = 0; i < rows[row - 1].size(); ++i)
            rows[row].push_back((rows[row - 1][i] + rows[row + 1][i]) / 2);
    return net_of_heights([&](int column, int row) { return rows[row][column]; });
}

// A curve of radii over x, turned about an axis by an angle to both sides. A row of patches is a
// quarter of the whole turn at most, whose circle a cubic represents to 3e-4 of the radius.
Surface revolved_surface(Reader& reader)
{
    const double base = reader.next();
    const Numbers rise = free_coordinate(patches_x, reader);
    const double half_angle = reader.next();
    const double part = 2 * half_angle / patches_y;
    const double handle = 4.0 / 3 * std::tan(part / 4);
    std::vector<Vec3> net;
    for (int row = 0; row <= 3 * patches_y; ++row) {
        const int corner = (row + 1) / 3;
        const double angle = -half_angle + corner * part;
        const double along = (row - 3 * corner) * handle;
        const double y = std::sin(angle) + along * std::cos(angle);
        const double z = std::cos(angle) - along * std::sin(angle);
        for (int column = 0; column <= 3 * patches_x; ++column) {
            const double radius = base + rise[column];
            net.emplace_back(width_x * column / (3.0 * patches_x), radius * y,
                             radius * z);
        }
    }
    return composite_bezier(patches_x, patches_y, net);
}

Surface ruled_surface(Reader& reader)
{
    const Numbers front = free_coordinate(patches_x, reader);
    const Numbers back = joined(patches_x, [&](int) { return reader.next(); });
    return net_of_heights([&](int column, int row) {
        return std::lerp(front[column], back[column], row / (3.0 * patches_y));
    });
}

constexpr std::array<std::string_view, surface_families.size()> names{
    "translational", "uneven",   "skew", "symmetric",  "tens",
    "swept",         "ferguson", "net",  "revolution", "ruled"};

bool visit_planned_runs(
    const Surface& surface, const RunPolicies& policies,
    const std::function<bool(const RunPlace&, const TableRun&)>& visit)
{
    require(
        policies.interval == IntervalArithmetic::Exact && !policies.points_of_first_pass,
        "visit_runs: these policies need a translational surface");
    for (int i = 0; i < 3; ++i)
        for (int j = 2; j >= 0; --j)
            for (int k = 0; k < 2; ++k) {
                TableRun run{};
                try {
                    const double diameter =
                        2 * policies.radius_per_diameter * table_diameters_mm[j];
                    const IsoParametricPlan plan =
                        table_plan(surface, policies.table, table_directions[k],
                                   table_tolerances_mm[i], diameter);
                    run.cost = path_cost(plan.path, policies.table);
                    run.passes = static_cast<int>(plan.governing.size());
                } catch (const GeometryError&) {
                    return false;
                } catch (const LimitError&) {
                    return false;
                }
                if (!visit({k, i, j}, run))
                    return true;
            }
    return true;
}

}  // namespace

std::string_view family_name(SurfaceFamily family)
{
    return names[static_cast<std::size_t>(family)];
}

SurfaceFamily family_named(std::string_view name)
{
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        throw DomainError{"family_named: no family of surfaces is called " +
                          std::string{name}};
    return surface_families[found - names.begin()];
}

std::vector<Interval> value_ranges(SurfaceFamily family)
{
    const Interval height{-most_height, most_height};
    const Interval offset{-most_offset, most_offset};
    std::vector<Interval> ranges;
    const auto add = [&](int count, const Interval& range) {
        ranges.insert(ranges.end(), count, range);
    };
    const auto shifts = [&](int count, double width, int patches) {
        const double most = most_shift * width / (3.0 * patches);
        add(count, {-most, most});
    };
    constexpr int a_heights = 7;  // 10 control points less 2 joints and the first
    constexpr int b_heights = 5;
    switch (family) {
        case SurfaceFamily::Translational:
        case SurfaceFamily::Tens:
            add(a_heights + b_heights, height);
            break;
        case SurfaceFamily::Uneven:
            add(a_heights + b_heights, height);
            shifts(a_heights - 1, width_x, patches_x);
            shifts(b_heights - 1, width_y, patches_y);
            break;
        case SurfaceFamily::Skew:
            add(a_heights + b_heights, height);
            add(a_heights + b_heights, offset);
            break;
        case SurfaceFamily::Symmetric:
            add(5, height);
            break;
        case SurfaceFamily::Swept:
            add(a_heights + b_heights, height);
            add(1, {-1, 1});
            break;
        case SurfaceFamily::Ferguson: {
            const Interval slope{-60, 60};
            for (int corner = 0; corner < (patches_x + 1) * (patches_y + 1); ++corner) {
                if (corner > 0)
                    add(1, height);
                add(2, slope);
            }
            break;
        }
        case SurfaceFamily::Net:
            add((a_heights + 1) * (b_heights + 1) - 1, height);
            break;
        case SurfaceFamily::Revolution:
            add(1, {20, 300});
            add(a_heights, height);
            add(1, {0.1, 1.4});
            break;
        case SurfaceFamily::Ruled:
            add(2 * a_heights + 1, height);
            break;
    }
    return ranges;
}

FamilyMember family_surface(SurfaceFamily family, std::span<const double> values)
{
    Reader reader{values};
    switch (family) {
        case SurfaceFamily::Translational:
            return pair_with_heights(reader).surface();
        case SurfaceFamily::Uneven: {
            CurvePair pair = pair_with_heights(reader);
            shift(pair.ax, patches_x, reader);
            shift(pair.by, patches_y, reader);
            return pair.surface();
        }
        case SurfaceFamily::Skew: {
            CurvePair pair = pair_with_heights(reader);
            pair.ay = free_coordinate(patches_x, reader);
            pair.bx = free_coordinate(patches_y, reader);
            return pair.surface();
        }
        case SurfaceFamily::Symmetric:
            return symmetric_surface(reader);
        case SurfaceFamily::Tens: {
            Numbers rounded;
            for (const double value : values)
                rounded.push_back(height_step * std::round(value / height_step));
            return family_surface(SurfaceFamily::Translational, rounded);
        }
        case SurfaceFamily::Swept:
            return swept_surface(reader);
        case SurfaceFamily::Ferguson:
            return ferguson_surface(reader);
        case SurfaceFamily::Net:
            return net_surface(reader);
        case SurfaceFamily::Revolution:
            return revolved_surface(reader);
        case SurfaceFamily::Ruled:
            break;
    }
    return ruled_surface(reader);
}

Surface as_surface(const FamilyMember& surface)
{
    if (const auto* translational = std::get_if<TranslationalSurface>(&surface))
        return as_surface(*translational);
    return std::get<Surface>(surface);
}

bool visit_runs(const FamilyMember& surface, const RunPolicies& policies,
                const std::function<bool(const RunPlace&, const TableRun&)>& visit)
{
    if (const auto* translational = std::get_if<TranslationalSurface>(&surface))
        return visit_runs(*translational, policies, visit);
    return visit_planned_runs(std::get<Surface>(surface), policies, visit);
}

}  // namespace endmill
