// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/tool_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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
// Deepest tree of triangles, which is halved at each node, and stack of its traversal.
constexpr std::size_t most_depth = 64;

using Corners = std::array<Vec3, 3>;

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

    // Lowers the best to the least distance of a triangle, by tangents on ever smaller
    // triangles. Corners as seen from the tool.
    void visit(const Corners& corners)
    {
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        const CuttingBody::Distance at = body_.distance(middle);
        double change = 0;
        double size = 0;
        for (const Vec3& corner : corners) {
            change = std::min(change, at.gradient.dot(corner - middle));
            size = std::max(size, (corner - middle).norm());
        }
        if (is_finished() || is_far(at.value + change))
            return;
        best_ = std::min(best_, at.value);
        // the true least is nearer than the size
        if (size <= ToolClearance::accuracy) {
            best_ = std::min(best_, at.value + change);
            return;
        }
        const Corners middles{(corners[1] + corners[2]) / 2,
                              (corners[2] + corners[0]) / 2,
                              (corners[0] + corners[1]) / 2};
        for (std::size_t k = 0; k < 3; ++k)
            visit({corners[k], middles[(k + 2) % 3], middles[(k + 1) % 3]});
        visit(middles);
    }

private:
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

double ToolClearance::lower_bound(const Disc& disc, const CuttingBody& body,
                                  const ToolFrame& tool)
{
    const CuttingBody::Distance at = body.distance(tool.seen(disc.centre));
    const double along = std::abs((tool.axes.transpose() * disc.normal).dot(at.gradient));
    const double beside =
        std::sqrt(std::max(0.0, at.gradient.squaredNorm() - along * along));
    return at.value -
           std::min(disc.radius, beside * disc.radius + along * disc.thickness);
}

double ToolClearance::searched(const CuttingBody& body, const ToolFrame& tool,
                               const SearchLimits& limits) const
{
    Search search{body, limits.enough, limits.stop, limits.slack};
    struct Open {
        double bound;
        std::int32_t disc;
    };
    std::array<Open, most_depth> open{};
    std::size_t count = 0;
    open[count++] = {lower_bound(discs_.front(), body, tool), 0};
    while (count > 0) {
        const Open next = open[--count];
        if (search.is_far(next.bound))
            continue;
        const Disc& disc = discs_[static_cast<std::size_t>(next.disc)];
        if (disc.second == 0) {
            Corners seen = corners_[static_cast<std::size_t>(disc.triangle)];
            for (Vec3& corner : seen)
                corner = tool.seen(corner);
            search.visit(seen);
            if (search.is_finished())
                break;
            continue;
        }
        const std::int32_t first = next.disc + 1;
        const Open a{lower_bound(discs_[static_cast<std::size_t>(first)], body, tool),
                     first};
        const Open b{
            lower_bound(discs_[static_cast<std::size_t>(disc.second)], body, tool),
            disc.second};
        // the one with the lower bound is taken first
        open[count++] = a.bound < b.bound ? b : a;
        open[count++] = a.bound < b.bound ? a : b;
    }
    return search.best();
}

bool ToolClearance::is_clear(const CuttingBody& body, const ToolFrame& tool,
                             double least) const
{
    const double limit = least + chord_error_;
    return searched(body, tool, {.enough = limit, .stop = limit, .slack = rounding}) >=
           limit;
}

double ToolClearance::gap(const CuttingBody& body, const ToolFrame& tool,
                          double enough) const
{
    const double found =
        searched(body, tool, {.enough = enough, .stop = -infinity, .slack = accuracy});
    return found < enough ? found : infinity;
}

}  // namespace endmill
