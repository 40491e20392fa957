// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/mesh_density_search.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// Random places of a test on each piece beside one that exceeds 1.
constexpr std::size_t places_a_piece = 6;
// Longest edge of a piece, as a share of the spacing of nodes.
constexpr double piece_share = 0.5;
// By which the box of a piece is enlarged, as a share of the spacing.
constexpr double box_margin = 1e-6;
// A place at which the ball enters the mesh by gamma and this share of the scallop height is a
// contact: in concave parts a mesh lies beside the part that it stands for.
constexpr double entry_share = 0.05;

double longest_edge_of(const std::vector<FacetPiece>& pieces)
{
    double longest = 0;
    for (const FacetPiece& piece : pieces)
        for (std::size_t k = 0; k < 3; ++k)
            longest =
                std::max(longest, (piece.corners[(k + 1) % 3] - piece.corners[k]).norm());
    return longest;
}

// Boxes around the pieces, with a margin for rounding.
std::vector<Eigen::AlignedBox3d> boxes_of(const std::vector<FacetPiece>& pieces,
                                          double margin)
{
    std::vector<Eigen::AlignedBox3d> boxes(pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        for (const Vec3& corner : pieces[k].corners)
            boxes[k].extend(corner);
        boxes[k] = {boxes[k].min().array() - margin, boxes[k].max().array() + margin};
    }
    return boxes;
}

}  // namespace

MeshDensitySearch::MeshDensitySearch(const TriangleMesh& mesh,
                                     const BoundProblem& problem,
                                     DensitySearchOptions options)
    : mesh_{mesh},
      problem_{problem},
      options_{std::move(options)},
      tree_{mesh},
      facets_at_{facets_at_points(mesh)},
      pieces_{facet_pieces(mesh, facets_at_, piece_share * options_.node_spacing)},
      spacing_{std::max(options_.node_spacing, longest_edge_of(pieces_) / piece_share)},
      all_(pieces_.size()),
      cover_{pieces_, problem},
      lattice_{boxes_of(pieces_, box_margin * spacing_), spacing_}
{
    std::iota(all_.begin(), all_.end(), std::size_t{0});
}

Vec3 MeshDensitySearch::centre(const MeshPlace& place) const
{
    return place.point + problem_.cutter.radius() * place.normal;
}

bool MeshDensitySearch::fits(const MeshPlace& place) const
{
    const double entry = problem_.stray + entry_share * problem_.scallop_height;
    return !tree_.nearest(centre(place), place.facet, problem_.cutter.radius() - entry);
}

MeshDensitySearch::Flows MeshDensitySearch::flows_at(const MeshPlace& place) const
{
    const Vec3 e1 = place.normal.unitOrthogonal();
    const Vec3 e2 = place.normal.cross(e1);
    Flows flows;
    for (const MeshFlow& flow : cover_.boundary(centre(place))) {
        const auto x = static_cast<float>(flow.flow.dot(e1));
        const auto y = static_cast<float>(flow.flow.dot(e2));
        const auto at = lattice_.place(flow.point);
        if (at && (x != 0 || y != 0))
            flows.push_back({*at, x, y});
    }
    sort_by_angle(flows);
    return flows;
}

// The first piece in each cube of a lattice, as far as the ball fits there.
std::vector<MeshPlace> MeshDensitySearch::spread_places(double step) const
{
    std::set<std::array<std::int64_t, 3>> cubes;
    std::vector<MeshPlace> places;
    for (const FacetPiece& piece : pieces_) {
        const Vec3 middle = piece.middle();
        const Vec3 cube = (middle / step).array().floor();
        if (cubes
                .insert({static_cast<std::int64_t>(cube.x()),
                         static_cast<std::int64_t>(cube.y()),
                         static_cast<std::int64_t>(cube.z())})
                .second)
            places.push_back({middle, piece.normal(), piece.facet});
    }
    std::vector<char> is_contact(places.size());
    parallel_for(places.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            is_contact[k] = fits(places[k]) ? 1 : 0;
    });
    std::vector<MeshPlace> contacts;
    for (std::size_t k = 0; k < places.size(); ++k)
        if (is_contact[k] != 0)
            contacts.push_back(places[k]);
    return contacts;
}

// A random place on a piece; or, if its facet has a crease at a corner or an edge, there, with a
// normal between those of the facets around.
MeshPlace MeshDensitySearch::random_place(std::size_t number,
                                          std::mt19937_64& engine) const
{
    const FacetPiece& piece = pieces_[number];
    double a = random_share(engine);
    double b = random_share(engine);
    const double kind = random_share(engine);
    const Triangle& triangle = mesh_.triangles()[piece.facet];
    const auto corner = static_cast<std::size_t>(a * 3);
    const std::int32_t from = triangle[corner];
    const std::int32_t to = triangle[(corner + 1) % 3];
    const bool is_on_edge = kind > 0.7;
    const Vec3 of_facet = facet_normal(mesh_, piece.facet);
    Vec3 normal = Vec3::Zero();
    bool has_crease = false;
    if (kind > 0.5)
        for (const std::uint32_t facet : facets_at_[from]) {
            const auto& other = mesh_.triangles()[facet];
            if (is_on_edge && std::ranges::find(other, to) == other.end())
                continue;
            const Vec3 of_other = facet_normal(mesh_, facet);
            has_crease = has_crease || is_crease(of_facet, of_other);
            normal += random_share(engine) * of_other;
        }
    const double length = normal.norm();
    if (has_crease && length > 0) {
        const Vec3 start = mesh_.points()[from];
        const Vec3 along = mesh_.points()[to] - start;
        return {is_on_edge ? Vec3{start + b * along} : start, normal / length,
                piece.facet};
    }
    if (a + b > 1)
        std::tie(a, b) = std::pair{1 - a, 1 - b};
    const auto mean = [&](const std::array<Vec3, 3>& of_corners) -> Vec3 {
        return of_corners[0] + a * (of_corners[1] - of_corners[0]) +
               b * (of_corners[2] - of_corners[0]);
    };
    return {mean(piece.corners), mean(piece.normals).normalized(), piece.facet};
}

// Random places on the given pieces, each as likely as it is large.
std::vector<MeshPlace> MeshDensitySearch::random_places(
    std::span<const std::size_t> pieces, std::size_t count, std::mt19937_64& engine) const
{
    std::vector<double> sums;
    sums.reserve(pieces.size());
    double sum = 0;
    for (const std::size_t piece : pieces)
        sums.push_back(sum += pieces_[piece].area());
    std::vector<MeshPlace> places;
    for (std::size_t k = 0; k < count && !pieces.empty(); ++k) {
        const auto found = std::ranges::upper_bound(sums, random_share(engine) * sum);
        const auto number =
            std::min(static_cast<std::size_t>(found - sums.begin()), sums.size() - 1);
        const MeshPlace place = random_place(pieces[number], engine);
        if (place.normal.z() > 0)
            places.push_back(place);
    }
    return places;
}

// Gives weight to the pieces that the ball comes within half the scallop height of.
void MeshDensitySearch::weigh(const std::vector<MeshPlace>& places)
{
    BoundProblem near = problem_;
    near.scallop_height /= 2;
    near.stray = 0;
    near.tool = CoveringTool::Ball;
    const MeshCover cover{pieces_, near};
    std::vector<std::atomic<bool>> is_near(pieces_.size());
    parallel_for(places.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            cover.visit_covered(
                centre(places[k]), [&](std::uint32_t piece, double share) {
                    if (share == 1)
                        is_near[piece].store(true, std::memory_order_relaxed);
                });
    });
    for (std::size_t k = 0; k < pieces_.size(); ++k)
        if (is_near[k].load(std::memory_order_relaxed))
            lattice_.add_area(pieces_[k].middle(), pieces_[k].area());
}

// Adds the places whose inflow exceeds 1; returns their numbers.
std::vector<std::size_t> MeshDensitySearch::test(const std::vector<MeshPlace>& places)
{
    const auto flows = [&](std::size_t k) {
        return fits(places[k]) ? flows_at(places[k]) : Flows{};
    };
    return join_exceeding(lattice_, density_, places.size(), flows, places_);
}

// Tests random places, and then others in the cells of those that exceed 1.
void MeshDensitySearch::test_at_random(std::uint64_t seed)
{
    std::mt19937_64 engine{seed};
    const std::vector<MeshPlace> places =
        random_places(all_, options_.random_places, engine);
    std::vector<std::uint32_t> cells;
    for (const std::size_t k : test(places))
        cells.push_back(lattice_.place(places[k].point)->node);
    std::ranges::sort(cells);
    std::vector<std::size_t> beside;
    for (std::size_t k = 0; k < pieces_.size(); ++k)
        if (std::ranges::binary_search(cells, lattice_.place(pieces_[k].middle())->node))
            beside.push_back(k);
    test(random_places(beside,
                       std::min(options_.random_places, beside.size() * places_a_piece),
                       engine));
}

double MeshDensitySearch::disc_at(const MeshPlace& place) const
{
    double disc = 0;
    cover_.visit_covered(centre(place), [&](std::uint32_t piece, double share) {
        disc += share * pieces_[piece].area() * density_at(pieces_[piece]);
    });
    return disc;
}

void MeshDensitySearch::report(double share) const
{
    if (options_.progress)
        options_.progress(share);
}

std::vector<double> MeshDensitySearch::inflows_at_random(std::size_t count,
                                                         std::uint64_t seed) const
{
    std::mt19937_64 engine{seed};
    const std::vector<MeshPlace> places = random_places(all_, count, engine);
    std::vector<double> inflows(places.size());
    parallel_for(places.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            if (fits(places[k]))
                inflows[k] = greatest_inflow(flows_at(places[k]), lattice_, density_);
    });
    return inflows;
}

FoundDensity MeshDensitySearch::run()
{
    report(0);
    const std::vector<MeshPlace> starts = spread_places(spacing_ / 2);
    const std::vector<MeshPlace> denser = spread_places(spacing_ / 4);
    weigh(denser);
    density_.assign(lattice_.nodes(), 1 / (2 * plane_half_width(problem_)));
    places_.resize(starts.size());
    parallel_for(starts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            places_[k] = flows_at(starts[k]);
    });
    refine_density(lattice_, places_, density_,
                   {.denser = [&] { test(denser); },
                    .at_random = [&](std::uint64_t seed) { test_at_random(seed); },
                    .report = [&](double share) { report(share); }});
    std::mt19937_64 engine{last_seed};
    const std::vector<MeshPlace> last =
        random_places(all_, options_.random_places, engine);
    std::vector<double> inflows(last.size());
    std::vector<double> discs(last.size());
    parallel_for(last.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            if (fits(last[k])) {
                inflows[k] = greatest_inflow(flows_at(last[k]), lattice_, density_);
                discs[k] = disc_at(last[k]);
            }
    });
    FoundDensity found =
        finished_density(lattice_, density_, places_.size(), inflows, discs);
    report(1);
    return found;
}

double MeshDensitySearch::density_at(const FacetPiece& piece) const
{
    return lattice_.value(density_, *lattice_.place(piece.middle()));
}

}  // namespace endmill
