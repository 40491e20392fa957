// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/tolerance.h"
#include "endmill/drop_cutter/detail/drop_tree.h"
#include "endmill/gouge/detail/surface_gap.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double pieces_per_radius = 2;
// Positions in a chunk share the smallest gap found so far. The size of a chunk is fixed,
// so that the result does not depend on the number of threads.
constexpr std::size_t places_in_a_chunk = 64;
// Every 256th position is searched first, then every 16th, then all.
constexpr std::array<std::size_t, 3> steps{256, 16, 1};

void check(std::span<const Vec3> references, double resolution)
{
    require(resolution > 0, "least_gap: need 0 < resolution");
    for (const Vec3& reference : references)
        require(reference.allFinite(), "least_gap: a place is not finite");
}

// The smallest gap below `enough` that `search(number, enough)` finds at the positions
// `begin`, `begin + step`, ... below `end`.
template <typename Search>
std::optional<LeastGap> least_of_some(const std::array<std::size_t, 3>& begin_end_step,
                                      double enough, Search& search)
{
    const auto [begin, end, step] = begin_end_step;
    std::optional<LeastGap> least;
    for (std::size_t k = begin; k < end; k += step)
        if (const auto found = search(k, enough); found && found->gap < enough) {
            least = LeastGap{found->gap, k, found->point};
            enough = found->gap;
        }
    return least;
}

// The smallest gap that `search(number, enough)` finds at any position. Few positions are
// searched first, then those between them: once a small gap is known, everything farther
// away is skipped.
template <typename MakeSearch>
std::optional<LeastGap> least_of_all(std::size_t count, const MakeSearch& make_search)
{
    std::optional<LeastGap> least;
    for (const std::size_t step : steps) {
        const std::size_t stretch = step * places_in_a_chunk;
        const std::size_t chunks = (count + stretch - 1) / stretch;
        const double enough = least ? least->gap : infinite;
        std::vector<std::optional<LeastGap>> least_of_chunk(chunks);
        parallel_for(chunks, [&](std::size_t begin, std::size_t end) {
            auto search = make_search();
            for (std::size_t chunk = begin; chunk < end; ++chunk)
                least_of_chunk[chunk] = least_of_some(
                    {chunk * stretch, std::min((chunk + 1) * stretch, count), step},
                    enough, search);
        });
        for (const auto& found : least_of_chunk)
            if (found && (!least || found->gap < least->gap))
                least = found;
    }
    return least;
}

// Searches a DropTree for the smallest gap. The tree searches for the largest value, so
// that all bounds are negated gaps.
class MeshGapQuery {
public:
    MeshGapQuery(const DropTree& tree, const Vec3& reference, double resolution,
                 double enough)
        : tree_{tree},
          core_{tree.cutter(), reference - tree.origin()},
          resolution_{resolution},
          found_{enough, {}}
    {
    }

    float limit() const { return static_cast<float>(resolution_ - found_.gap); }

    // All points of a node lie inside its box and below its plane. Therefore none of them
    // is nearer to a supporting plane that faces downwards than the corners of the node's
    // plane over its box.
    FloatLanes bounds(const DropTree::Nodes& nodes, const FloatLanes& /*tops*/) const
    {
        FloatLanes depths;
        for (Eigen::Index k = 0; k < float_lanes; ++k) {
            const DropTree::Plane plane = tree_.plane(nodes, k);
            if (plane.is_empty) {
                depths[k] = -std::numeric_limits<float>::infinity();
                continue;
            }
            const auto [normal, distance] = core_.nearest_plane_below(plane.middle);
            const Eigen::Vector2d along = normal.head<2>() + normal.z() * plane.slope;
            const double bound =
                distance - along.cwiseAbs().dot(plane.half_size) - core_.corner_radius();
            depths[k] = static_cast<float>(-bound + resolution_ / 4 +
                                           rounding_share * std::abs(bound));
        }
        return depths;
    }

    void look_at(std::size_t triangle)
    {
        auto corners = tree_.mesh().corners(triangle);
        for (Vec3& corner : corners)
            corner -= tree_.origin();
        const TriangleGap gap =
            triangle_gap(core_, corners, resolution_ / 4, found_.gap - resolution_ / 2);
        if (gap.gap < found_.gap) {
            found_ = gap;
            is_found_ = true;
        }
    }

    std::optional<TriangleGap> found() const
    {
        if (!is_found_)
            return std::nullopt;
        return TriangleGap{found_.gap, found_.point + tree_.origin()};
    }

private:
    // more than the rounding errors of floats
    static constexpr double rounding_share = 1e-6;

    const DropTree& tree_;
    CutterCore core_;
    double resolution_;
    TriangleGap found_;
    bool is_found_ = false;
};

}  // namespace

std::optional<LeastGap> least_gap(std::span<const Surface> surfaces, const Cutter& cutter,
                                  std::span<const Vec3> references, double resolution)
{
    check(references, resolution);
    const PieceTree tree{surfaces, cutter.radius() / pieces_per_radius};
    return least_of_all(references.size(), [&] {
        return [&, finer = FinerPieces{}](std::size_t k, double enough) mutable {
            return surface_gap(tree, CutterCore{cutter, references[k]}, resolution,
                               enough, finer);
        };
    });
}

std::optional<LeastGap> least_gap(const DropCutter& drop_cutter,
                                  std::span<const Vec3> references, double resolution)
{
    check(references, resolution);
    const DropTree& tree = drop_cutter.tree();
    return least_of_all(references.size(), [&] {
        return [&](std::size_t k, double enough) {
            MeshGapQuery query{tree, references[k], resolution, enough};
            tree.search(query);
            return query.found();
        };
    });
}

namespace {

// A mesh of two triangles a segment, from y = -half_width to half_width. Any width gives
// the same gap, since the cutter is widest in the plane y = 0; one near the length of a
// segment gives well-shaped triangles.
TriangleMesh prisms_over(std::span<const SectionCurve> profiles)
{
    double length = 0;
    std::size_t segments = 0;
    for (const SectionCurve& curve : profiles)
        for (std::size_t i = 0; i + 1 < curve.points.size(); ++i, ++segments)
            length += (curve.points[i + 1] - curve.points[i]).norm();
    const double half_width =
        segments > 0 ? length / static_cast<double>(segments) / 2 : 0;
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (const SectionCurve& curve : profiles)
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const SectionPoint& at = curve.points[i];
            const auto next = static_cast<std::int32_t>(points.size());
            points.emplace_back(at.x(), -half_width, at.y());
            points.emplace_back(at.x(), half_width, at.y());
            if (i == 0)
                continue;
            triangles.push_back({next - 2, next, next - 1});
            triangles.push_back({next - 1, next, next + 1});
        }
    return {std::move(points), std::move(triangles)};
}

}  // namespace

std::optional<LeastGap> profile_gap(std::span<const SectionCurve> profiles,
                                    const Cutter& cutter,
                                    std::span<const SectionPoint> references,
                                    double resolution)
{
    const TriangleMesh mesh = prisms_over(profiles);
    if (mesh.triangles().empty())
        return std::nullopt;
    std::vector<Vec3> places;
    for (const SectionPoint& at : references)
        places.emplace_back(at.x(), 0, at.y());
    return least_gap(DropCutter{mesh, cutter}, places, resolution);
}

std::optional<LeastGap> greatest_rise(const DropCutter& drop_cutter,
                                      std::span<const Vec3> references)
{
    check(references, gap_resolution);
    std::vector<Eigen::Vector2d> places;
    places.reserve(references.size());
    for (const Vec3& reference : references)
        places.emplace_back(reference.head<2>());
    const double r = drop_cutter.cutter().corner_radius();
    const std::vector<std::optional<DropContact>> contacts = drop_cutter.contacts(places);
    std::optional<LeastGap> least;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (!contacts[k])
            continue;
        const double gap = references[k].z() - r - contacts[k]->tip_z;
        if (!least || gap < least->gap)
            least = LeastGap{gap, k, contacts[k]->point};
    }
    return least;
}

bool is_accessible(const DropCutter& drop_cutter, const CutterContact& contact,
                   double distance)
{
    constexpr int rim_points = 8;
    if (contact.normal.z() < 0)
        return false;
    const Cutter& cutter = drop_cutter.cutter();
    const Vec3 tip =
        control_point(cutter, {contact.point + distance * contact.normal, contact.normal},
                      ControlPoint::Tip);
    const auto is_clear_at = [&](const Eigen::Vector2d& place) {
        const auto found = drop_cutter.contact(place);
        return !found || found->tip_z <= tip.z() + rest_gouge;
    };
    if (is_clear_at(tip.head<2>()))
        return true;
    if (!(cutter.flat_radius() > 0 && is_level(contact.normal)))
        return false;
    for (int k = 0; k < rim_points; ++k) {
        const double angle = 2 * std::numbers::pi * k / rim_points;
        const Eigen::Vector2d beside{std::cos(angle), std::sin(angle)};
        if (is_clear_at(tip.head<2>() + cutter.flat_radius() * beside))
            return true;
    }
    return false;
}

}  // namespace endmill
