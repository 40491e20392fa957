// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "endmill/core/detail/finished_share.h"
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
// Positions over which a cutter is dropped before progress is reported.
constexpr std::size_t places_a_report = 65536;

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
std::optional<LeastGap> least_of_all(std::size_t count, const MakeSearch& make_search,
                                     const std::function<void(double)>& progress)
{
    const auto chunks_of = [&](std::size_t step) {
        const std::size_t stretch = step * places_in_a_chunk;
        return (count + stretch - 1) / stretch;
    };
    std::size_t all_chunks = 0;
    for (const std::size_t step : steps)
        all_chunks += chunks_of(step);
    FinishedShare finished{progress, all_chunks};
    std::optional<LeastGap> least;
    for (const std::size_t step : steps) {
        const std::size_t stretch = step * places_in_a_chunk;
        const std::size_t chunks = chunks_of(step);
        const double enough = least ? least->gap : infinite;
        std::vector<std::optional<LeastGap>> least_of_chunk(chunks);
        parallel_for(chunks, [&](std::size_t begin, std::size_t end) {
            auto search = make_search();
            for (std::size_t chunk = begin; chunk < end; ++chunk) {
                least_of_chunk[chunk] = least_of_some(
                    {chunk * stretch, std::min((chunk + 1) * stretch, count), step},
                    enough, search);
                finished.add(1);
            }
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
    MeshGapQuery(const DropTree& tree, const Cutter& cutter, const Vec3& reference,
                 double resolution, double enough)
        : tree_{tree},
          core_{cutter, reference - tree.origin()},
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
                                  std::span<const Vec3> references,
                                  const GapOptions& options)
{
    check(references, options.resolution);
    const PieceTree tree{surfaces, cutter.radius() / pieces_per_radius};
    const auto make_search = [&] {
        return [&, finer = FinerPieces{}](std::size_t k, double enough) mutable {
            return surface_gap(tree, CutterCore{cutter, references[k]},
                               options.resolution, enough, finer);
        };
    };
    return least_of_all(references.size(), make_search, options.progress);
}

std::optional<LeastGap> least_gap(const DropCutter& drop_cutter,
                                  std::span<const Vec3> references,
                                  const GapOptions& options)
{
    check(references, options.resolution);
    const DropTree& tree = drop_cutter.tree();
    const auto make_search = [&] {
        return [&](std::size_t k, double enough) {
            MeshGapQuery query{tree, tree.cutter(), references[k], options.resolution,
                               enough};
            tree.search(query);
            return query.found();
        };
    };
    return least_of_all(references.size(), make_search, options.progress);
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
                                    const GapOptions& options)
{
    const TriangleMesh mesh = prisms_over(profiles);
    if (mesh.triangles().empty())
        return std::nullopt;
    std::vector<Vec3> places;
    for (const SectionPoint& at : references)
        places.emplace_back(at.x(), 0, at.y());
    return least_gap(DropCutter{mesh, cutter}, places, options);
}

std::optional<LeastGap> greatest_rise(const DropCutter& drop_cutter,
                                      std::span<const Vec3> references,
                                      const std::function<void(double)>& progress)
{
    check(references, gap_resolution);
    FinishedShare finished{progress, references.size()};
    const double r = drop_cutter.cutter().corner_radius();
    std::optional<LeastGap> least;
    std::vector<Eigen::Vector2d> places;
    for (std::size_t first = 0; first < references.size(); first += places.size()) {
        places.clear();
        for (const Vec3& reference : references.subspan(
                 first, std::min(places_a_report, references.size() - first)))
            places.emplace_back(reference.head<2>());
        const auto contacts = drop_cutter.contacts(places);
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            if (!contacts[k])
                continue;
            const double gap = references[first + k].z() - r - contacts[k]->tip_z;
            if (!least || gap < least->gap)
                least = LeastGap{gap, first + k, contacts[k]->point};
        }
        finished.add(places.size());
    }
    return least;
}

namespace {

// Stops at the first point of the mesh that is inside the cutter by the resolution.
class InnerPointQuery : public MeshGapQuery {
public:
    InnerPointQuery(const DropTree& tree, const Cutter& cutter, const Vec3& reference,
                    double resolution)
        : MeshGapQuery{tree, cutter, reference, resolution, -resolution}
    {
    }

    float limit() const
    {
        return found() ? std::numeric_limits<float>::infinity() : MeshGapQuery::limit();
    }
};

// Searches the tips of a cutter whose flat bottom covers a point, all at one height, for one
// that is clear of a mesh. Squares of tips are tested at their middle and quartered; a square
// is dropped if the mesh bars all of its tips.
class FlatSearch {
public:
    FlatSearch(const DropCutter& drop_cutter, const Vec3& middle, double spacing)
        : drop_cutter_{drop_cutter},
          middle_{middle},
          spacing_{spacing}
    {
    }

    // Also true if it remains unknown after many tests.
    bool finds_clear_tip()
    {
        squares_.push_back({{0, 0}, drop_cutter_.cutter().flat_radius()});
        for (std::size_t next = 0; next < squares_.size(); ++next) {
            const Square square = squares_[next];
            const auto found = drop_cutter_.contact(middle_.head<2>() + nearest(square));
            if (!found || found->tip_z <= middle_.z())
                return true;
            if (is_barred(square))
                continue;
            if (next >= most_tests || square.half_size < spacing_)
                return true;
            quarter(square);
        }
        return false;
    }

private:
    static constexpr std::size_t most_tests = 1024;
    static constexpr double resolution_share = 0.125;  // of the size of a square

    struct Square {
        Eigen::Vector2d middle;  // relative to middle_
        double half_size;
    };

    // The tip of the disc next to the square's middle.
    Eigen::Vector2d nearest(const Square& square) const
    {
        const double flat_radius = drop_cutter_.cutter().flat_radius();
        const double distance = square.middle.norm();
        return distance > flat_radius
                   ? Eigen::Vector2d{square.middle * (flat_radius / distance)}
                   : square.middle;
    }

    // Whether the mesh bars all tips of the square: a narrower cutter in its middle, whose
    // bottom the true one covers from every tip of the square, is not clear.
    bool is_barred(const Square& square) const
    {
        const Cutter& cutter = drop_cutter_.cutter();
        const double less = std::sqrt(2.0) * square.half_size;
        if (less >= cutter.flat_radius())
            return false;
        const double r = cutter.corner_radius();
        Vec3 reference = middle_ + r * Vec3::UnitZ();
        reference.head<2>() += square.middle;
        InnerPointQuery query{drop_cutter_.tree(),
                              {cutter.radius() - less, r},
                              reference,
                              std::max(gap_resolution, resolution_share * less)};
        drop_cutter_.tree().search(query);
        return query.found().has_value();
    }

    void quarter(const Square& square)
    {
        const double half_size = square.half_size / 2;
        for (const double x : {-half_size, half_size})
            for (const double y : {-half_size, half_size}) {
                const Eigen::Vector2d middle = square.middle + Eigen::Vector2d{x, y};
                const Eigen::Vector2d corner =
                    (middle.cwiseAbs() - Eigen::Vector2d{half_size, half_size})
                        .cwiseMax(0);
                if (corner.norm() < drop_cutter_.cutter().flat_radius())
                    squares_.push_back({middle, half_size});
            }
    }

    const DropCutter& drop_cutter_;
    Vec3 middle_;
    double spacing_;
    std::vector<Square> squares_;
};

}  // namespace

bool is_accessible(const DropCutter& drop_cutter, const CutterContact& contact,
                   double distance)
{
    constexpr double unit_accuracy = 1e-9;
    require(contact.point.allFinite(), "is_accessible: the point is not finite");
    require(std::abs(contact.normal.norm() - 1) <= unit_accuracy,
            "is_accessible: the normal is not a unit vector");
    require(distance >= 0 && std::isfinite(distance),
            "is_accessible: need a finite distance >= 0");
    if (contact.normal.z() < 0)
        return false;
    const Cutter& cutter = drop_cutter.cutter();
    Vec3 tip =
        control_point(cutter, {contact.point + distance * contact.normal, contact.normal},
                      ControlPoint::Tip);
    tip.z() += rest_gouge;
    if (cutter.flat_radius() > 0 && is_level(contact.normal))
        return FlatSearch{drop_cutter, tip, distance}.finds_clear_tip();
    const auto found = drop_cutter.contact(tip.head<2>());
    return !found || found->tip_z <= tip.z();
}

}  // namespace endmill
