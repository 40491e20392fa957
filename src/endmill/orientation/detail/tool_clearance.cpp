// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/tool_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/surface/sampling.h"

namespace endmill {
namespace {

// Slack of a proof in mm. It ends the search where a plane face of the part is parallel to the
// tool at just the asked distance.
constexpr double rounding = 1e-9;
constexpr double infinity = std::numeric_limits<double>::infinity();
// Triangles of surfaces; a tree of them has 0.8 GB.
constexpr std::size_t most_triangles = 3'000'000;
// A disc of a front is divided if the contact is within this many radii of its middle.
constexpr double near_radii = 1.2;
// Deepest tree of triangles, which is halved at each node, and stack of its traversal.
constexpr std::size_t most_depth = 64;

using Corners = std::array<Vec3, 3>;

Corners seen_by(const ToolFrame& tool, const Corners& corners)
{
    return {tool.seen(corners[0]), tool.seen(corners[1]), tool.seen(corners[2])};
}

// A search for the least signed distance, or for a place below a limit.
class Search {
public:
    // \param limit places at this distance or farther do not matter.
    // \param stop the search ends at a place below this distance.
    // \param slack in mm: distances nearer to the limit than this are not searched for.
    Search(const CuttingBody& body, double limit, double stop, double slack)
        : body_{body},
          best_{limit},
          stop_{stop},
          slack_{slack}
    {
    }

    double best() const { return best_; }
    bool is_finished() const { return best_ < stop_; }
    // Whether nothing at or above this bound matters.
    bool is_far(double bound) const { return bound >= best_ - slack_; }

    // Whether no place of a disc matters, by tangents: at the middle; at the place of the rim
    // to which that falls; the mean of both that has the least slope.
    // \param disc with a centre, normal, radius and half thickness. \param bound is set to the
    //        greatest lower bound that was found.
    template <typename Disc>
    bool is_far(const Disc& disc, const ToolFrame& tool, double& bound) const
    {
        const Vec3 middle = tool.seen(disc.centre);
        const CuttingBody::Distance at = body_.distance(middle);
        bound = at.value - disc.radius;
        if (is_far(bound))
            return true;
        const Vec3 normal = tool.axes.transpose() * disc.normal;
        const auto take = [&](double value, const Vec3& gradient) {
            const double up = normal.dot(gradient);
            const double slope = (gradient - up * normal).norm();
            bound = std::max(bound,
                             value - slope * disc.radius - std::abs(up) * disc.thickness);
            return is_far(bound);
        };
        const Vec3 beside = at.gradient - normal.dot(at.gradient) * normal;
        const double slope = beside.norm();
        if (take(at.value, at.gradient) || !(slope > 0))
            return is_far(bound);
        const Vec3 rim = middle - disc.radius / slope * beside;
        const CuttingBody::Distance there = body_.distance(rim);
        const double rim_value = there.value + there.gradient.dot(middle - rim);
        const Vec3 change = there.gradient - at.gradient;
        const Vec3 change_beside = change - normal.dot(change) * normal;
        const double square = change_beside.squaredNorm();
        if (!(square > 0))
            return take(rim_value, there.gradient);
        const double share = std::clamp(-beside.dot(change_beside) / square, 0.0, 1.0);
        return take(at.value + share * (rim_value - at.value),
                    at.gradient + share * change);
    }

    // Lowers the best to the least distance of a triangle, by tangents on ever smaller
    // triangles. Corners as seen from the tool.
    void visit(const Corners& corners)
    {
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        const Tangent first = tangent(corners, middle);
        if (is_finished() || is_far(first.least))
            return;
        best_ = std::min(best_, first.value);
        const Tangent second = tangent(corners, first.at);
        const double bound = least_of_both(first.values, second.values);
        if (is_far(bound))
            return;
        best_ = std::min(best_, second.value);
        // the true least is nearer than the size
        if ((first.at - middle).norm() <= ToolClearance::accuracy) {
            best_ = std::min(best_, bound);
            return;
        }
        const Corners middles{(corners[1] + corners[2]) / 2,
                              (corners[2] + corners[0]) / 2,
                              (corners[0] + corners[1]) / 2};
        visit(middles);
        for (std::size_t k = 0; k < 3; ++k)
            visit({corners[k], middles[(k + 2) % 3], middles[(k + 1) % 3]});
    }

private:
    // The distance at a place, and the least value of the tangent on a triangle, at a corner.
    struct Tangent {
        double value;
        std::array<double, 3> values;  // at the corners
        double least;
        Vec3 at;
    };
    Tangent tangent(const Corners& corners, const Vec3& place) const
    {
        const CuttingBody::Distance distance = body_.distance(place);
        Tangent found{distance.value, {}, infinity, place};
        for (std::size_t k = 0; k < 3; ++k) {
            found.values[k] = distance.value + distance.gradient.dot(corners[k] - place);
            if (found.values[k] < found.least) {
                found.least = found.values[k];
                found.at = corners[k];
            }
        }
        return found;
    }

    // The greatest lower bound by means of two tangents: over all shares, the least of their
    // means at the corners.
    static double least_of_both(const std::array<double, 3>& a,
                                const std::array<double, 3>& b)
    {
        const auto least_at = [&](double share) {
            return std::min({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
                             a[2] + share * (b[2] - a[2])});
        };
        double best = std::max(least_at(0), least_at(1));
        for (std::size_t k = 0; k < 3; ++k) {
            // where the means at two corners are equal
            const std::size_t next = (k + 1) % 3;
            const double rise = (b[k] - a[k]) - (b[next] - a[next]);
            const double share = (a[next] - a[k]) / rise;
            if (share > 0 && share < 1)
                best = std::max(best, least_at(share));
        }
        return best;
    }

    const CuttingBody& body_;
    double best_;
    double stop_;
    double slack_;
};

}  // namespace

ToolClearance::ToolClearance(const TriangleMesh& mesh, double chord_error)
    : chord_error_{chord_error}
{
    build(mesh);
}

ToolClearance::ToolClearance(std::span<const Surface> surfaces,
                             std::span<const double> sides, double chord_tolerance)
{
    const SampledSurface sampling =
        sampled(surfaces, sides, chord_tolerance, most_triangles);
    chord_error_ = sampling.max_chord_error_mm;
    build(sampling.mesh);
}

void ToolClearance::build(const TriangleMesh& mesh)
{
    const std::size_t count = mesh.triangles().size();
    require(count > 0, "ToolClearance: need a triangle");
    std::vector<Vec3> centroids;
    centroids.reserve(count);
    corners_.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        corners_.push_back(mesh.corners(k));
        const Corners& corners = corners_.back();
        centroids.emplace_back((corners[0] + corners[1] + corners[2]) / 3);
    }
    std::vector<std::int32_t> triangles(count);
    std::iota(triangles.begin(), triangles.end(), 0);
    discs_.reserve(2 * count);
    add(triangles, centroids);
}

std::int32_t ToolClearance::add(std::span<std::int32_t> triangles,
                                std::span<const Vec3> centroids)
{
    const auto number = static_cast<std::int32_t>(discs_.size());
    discs_.push_back(enclosing(triangles));
    if (triangles.size() == 1) {
        discs_.back().triangle = triangles.front();
        return number;
    }
    Eigen::AlignedBox3d box;
    for (const std::int32_t triangle : triangles)
        box.extend(centroids[static_cast<std::size_t>(triangle)]);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t half = triangles.size() / 2;
    std::nth_element(triangles.begin(),
                     triangles.begin() + static_cast<std::ptrdiff_t>(half),
                     triangles.end(), [&](std::int32_t a, std::int32_t b) {
                         const double at_a = centroids[static_cast<std::size_t>(a)][axis];
                         const double at_b = centroids[static_cast<std::size_t>(b)][axis];
                         return at_a != at_b ? at_a < at_b : a < b;
                     });
    add(triangles.first(half), centroids);
    const std::int32_t second = add(triangles.subspan(half), centroids);
    discs_[static_cast<std::size_t>(number)].second = second;
    return number;
}

ToolClearance::Disc ToolClearance::enclosing(
    std::span<const std::int32_t> triangles) const
{
    Eigen::AlignedBox3d box;
    Vec3 normal = Vec3::Zero();
    for (const std::int32_t triangle : triangles) {
        const Corners& corners = corners_[static_cast<std::size_t>(triangle)];
        for (const Vec3& corner : corners)
            box.extend(corner);
        normal += (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    }
    normal = normal.norm() > 0 ? Vec3{normal.normalized()} : Vec3{Vec3::UnitZ()};
    Vec3 centre = box.center();
    double low = infinity;
    double high = -infinity;
    for (const std::int32_t triangle : triangles)
        for (const Vec3& corner : corners_[static_cast<std::size_t>(triangle)]) {
            const double height = normal.dot(corner - centre);
            low = std::min(low, height);
            high = std::max(high, height);
        }
    centre += (low + high) / 2 * normal;
    double radius = 0;
    for (const std::int32_t triangle : triangles)
        for (const Vec3& corner : corners_[static_cast<std::size_t>(triangle)])
            radius = std::max(radius, (corner - centre).norm());
    return {centre, normal, radius, (high - low) / 2, 0, 0};
}

double ToolClearance::searched(const CuttingBody& body, const ToolFrame& tool,
                               const SearchLimits& limits,
                               std::span<const std::int32_t> starts) const
{
    Search search{body, limits.enough, limits.stop, limits.slack};
    struct Open {
        double bound;
        std::int32_t disc;
    };
    std::array<Open, most_depth> open{};
    std::size_t count = 0;
    const auto add = [&](std::int32_t number) {
        const Disc& disc = discs_[static_cast<std::size_t>(number)];
        double bound = 0;
        if (!search.is_far(disc, tool, bound))
            open[count++] = {bound, number};
    };
    for (const std::int32_t start : starts) {
        add(start);
        while (count > 0) {
            const Open next = open[--count];
            if (search.is_far(next.bound))
                continue;
            const Disc& disc = discs_[static_cast<std::size_t>(next.disc)];
            if (disc.second == 0) {
                search.visit(
                    seen_by(tool, corners_[static_cast<std::size_t>(disc.triangle)]));
                if (search.is_finished())
                    return search.best();
                continue;
            }
            const std::size_t before = count;
            add(next.disc + 1);
            add(disc.second);
            // the one with the lower bound is taken first
            if (count == before + 2 && open[before].bound < open[before + 1].bound)
                std::swap(open[before], open[before + 1]);
        }
    }
    return search.best();
}

ToolClearance::Front ToolClearance::front(const CutterContact& contact,
                                          double least) const
{
    const double limit = least + chord_error_ - rounding;
    Front found;
    std::vector<std::int32_t> open{0};
    while (!open.empty()) {
        const std::int32_t number = open.back();
        open.pop_back();
        const Disc& disc = discs_[static_cast<std::size_t>(number)];
        const Vec3 from = disc.centre - contact.point;
        const double up = disc.normal.dot(contact.normal);
        const double below = -contact.normal.dot(from) -
                             std::sqrt(std::max(0.0, 1 - up * up)) * disc.radius -
                             std::abs(up) * disc.thickness;
        if (below >= limit)
            continue;
        if (disc.second == 0 || from.norm() > near_radii * disc.radius) {
            found.push_back(number);
            continue;
        }
        open.push_back(disc.second);
        open.push_back(number + 1);
    }
    return found;
}

bool ToolClearance::rises_above(double elevation, const CutterContact& contact,
                                std::span<const std::int32_t> front) const
{
    const double sine = std::sin(elevation);
    const double cosine = std::cos(elevation);
    return std::ranges::any_of(front, [&](std::int32_t number) {
        const Disc& disc = discs_[static_cast<std::size_t>(number)];
        const Vec3 from = disc.centre - contact.point;
        const double up = std::abs(disc.normal.dot(contact.normal));
        const double least_distance = from.norm() - disc.radius - disc.thickness;
        if (least_distance <= 0)
            return up < cosine;
        const double height = contact.normal.dot(from) +
                              std::sqrt(std::max(0.0, 1 - up * up)) * disc.radius +
                              up * disc.thickness + chord_error_;
        return height > sine * least_distance;
    });
}

bool ToolClearance::is_clear(const CuttingBody& body, const ToolFrame& tool,
                             double least) const
{
    const std::array<std::int32_t, 1> root{0};
    return is_clear(body, tool, least, root);
}

bool ToolClearance::is_clear(const CuttingBody& body, const ToolFrame& tool, double least,
                             std::span<const std::int32_t> front) const
{
    const double limit = least + chord_error_;
    return searched(body, tool, {.enough = limit, .slack = rounding, .stop = limit},
                    front) >= limit;
}

double ToolClearance::gap(const CuttingBody& body, const ToolFrame& tool,
                          double enough) const
{
    const std::array<std::int32_t, 1> root{0};
    SearchLimits limits{};
    limits.enough = enough;
    limits.slack = accuracy;
    const double found = searched(body, tool, limits, root);
    if (found < enough)
        return found;
    return infinity;
}

}  // namespace endmill
