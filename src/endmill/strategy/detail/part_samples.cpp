// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/part_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/planning/detail/verified_pass.h"
#include "endmill/strategy/detail/near_contact.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {
namespace {

// The unit normal on the tool's side; its limit on a collapsed edge.
Vec3 tool_normal(const Surface& surface, double side, double u, double v)
{
    const SurfaceJet jet = surface.jet(u, v);
    const SurfaceTangents tangents{jet.point, jet.du, jet.dv};
    const Vec3 across = jet.du.cross(jet.dv);
    if (!is_singular(tangents, across))
        return side * across.normalized();
    const InwardSigns inward{u < surface.range(Parameter::U).high ? 1 : -1,
                             v < surface.range(Parameter::V).high ? 1 : -1};
    if (const std::optional<Vec3> limit = limit_normal(jet, inward))
        return side * *limit;
    throw GeometryError{"no normal at " + place_text({u, v}, jet.point)};
}

PassContact mesh_contact(const CutterContact& contact, std::int32_t near)
{
    return {{contact.point.x(), contact.point.y(), contact}, 0, near};
}

// Sides of a triangle whose squares differ by a smaller share are equally long.
constexpr double same_length = 1e-9;

// Least steps of the first net across each patch. Its edges are then halved until they are
// short enough; a patch whose curves oscillate more often than this within a step is not
// resolved.
constexpr int first_steps = 8;

// The parameters of every patch border, and equal steps between them.
std::vector<double> equal_lines(const Surface& surface, Parameter along)
{
    const std::span<const double> breaks = surface.breaks(along);
    std::vector<double> lines{breaks.front()};
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        for (int step = 1; step < first_steps; ++step)
            lines.push_back(
                std::lerp(breaks[k], breaks[k + 1], step / double{first_steps}));
        lines.push_back(breaks[k + 1]);
    }
    return lines;
}

// The greatest lengths of the steps between lines, mm.
struct StepLengths {
    std::vector<double> us;
    std::vector<double> vs;
};

// The greatest multiple of `side` by a power of two with which every patch has at least
// `first_steps` steps; at least `side`.
double first_side(const StepLengths& lengths, double side)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto* own : {&lengths.us, &lengths.vs})
        for (auto step = own->begin(); step != own->end(); step += first_steps)
            least = std::min(least, std::accumulate(step, step + first_steps, 0.0));
    double result = side;
    while (result * 2 * first_steps < least)
        result *= 2;
    return result;
}

// The lines of a net whose edges are at most `side` mm long, from lines at equal parameters.
// \param lengths of the steps between the equal lines, mm.
std::vector<double> even_lines(const std::vector<double>& equal,
                               const std::vector<double>& lengths, double side)
{
    std::vector<double> lines{equal.front()};
    for (std::size_t first = 0; first < lengths.size(); first += first_steps) {
        const auto begin = lengths.begin() + static_cast<std::ptrdiff_t>(first);
        const double length = std::accumulate(begin, begin + first_steps, 0.0);
        const int steps =
            std::max(first_steps, static_cast<int>(std::ceil(length / side)));
        double passed = 0;  // length up to the beginning of step k
        std::size_t k = first;
        for (int step = 1; step < steps; ++step) {
            const double wanted = length * step / steps;
            for (; k + 1 < first + first_steps && passed + lengths[k] < wanted; ++k)
                passed += lengths[k];
            const double share = lengths[k] > 0 ? (wanted - passed) / lengths[k] : 0;
            const double line =
                std::lerp(equal[k], equal[k + 1], std::clamp(share, 0.0, 1.0));
            if (line > lines.back())
                lines.push_back(line);
        }
        lines.push_back(equal[first + first_steps]);
    }
    return lines;
}

// The parameters of the first net.
struct FirstLines {
    std::vector<double> us;
    std::vector<double> vs;
};

// The greatest length of each step of equal lines, across all other lines, counts.
FirstLines even_lines(const Surface& surface, const FirstLines& equal, double side)
{
    const auto& [us, vs] = equal;
    StepLengths lengths{std::vector<double>(us.size() - 1, 0),
                        std::vector<double>(vs.size() - 1, 0)};
    std::vector<Vec3> row(us.size());
    std::vector<Vec3> row_before(us.size());
    for (std::size_t j = 0; j < vs.size(); ++j) {
        std::swap(row, row_before);
        for (std::size_t i = 0; i < us.size(); ++i)
            row[i] = surface.tangents(us[i], vs[j]).point;
        for (std::size_t i = 0; i + 1 < us.size(); ++i)
            lengths.us[i] = std::max(lengths.us[i], (row[i + 1] - row[i]).norm());
        for (std::size_t i = 0; i < us.size() && j > 0; ++i)
            lengths.vs[j - 1] =
                std::max(lengths.vs[j - 1], (row[i] - row_before[i]).norm());
    }
    const double first = first_side(lengths, side);
    return {even_lines(us, lengths.us, first), even_lines(vs, lengths.vs, first)};
}

// The edges of which one end is wanted and the other is not.
std::vector<MeshEdge> edges_between(std::span<const Triangle> triangles,
                                    const std::vector<bool>& is_wanted)
{
    std::vector<MeshEdge> crossing;
    for (const Triangle& triangle : triangles)
        for (int k = 0; k < 3; ++k)
            if (is_wanted[triangle[k]] != is_wanted[triangle[(k + 1) % 3]])
                crossing.push_back({triangle[k], triangle[(k + 1) % 3]});
    return crossing;
}

}  // namespace

void throw_too_many_samples(double needed, std::size_t most_samples)
{
    std::ostringstream message;
    message << std::setprecision(2) << "the part would need more than " << needed
            << " samples at this scallop height; expected at most "
            << static_cast<double>(most_samples)
            << " for the memory (--max-memory); a larger --scallop needs fewer";
    throw LimitError{message.str()};
}

PartSamples::PartSamples(std::span<const Surface> surfaces, std::span<const double> sides,
                         double spacing, std::size_t most_samples)
    : PartSamples{surfaces, sides, PartSampling{spacing}, most_samples}
{
}

PartSamples::PartSamples(std::span<const Surface> surfaces, std::span<const double> sides,
                         const PartSampling& sampling, std::size_t most_samples)
    : source_{SampledSurfaces{surfaces, {sides.begin(), sides.end()}}},
      spacing_{sampling.spacing},
      accessible_distance_{sampling.accessible_distance},
      guard_{sampling.guard},
      most_samples_{most_samples}
{
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        add_surface(surfaces[k], static_cast<int>(k));
    find_twins(surfaces);
    refine();
    if (guard_)
        find_accessible();
    number_by_place();
    join();
    if (guard_)
        seat();
}

PartSamples::PartSamples(const MeshNet& net, std::shared_ptr<const BallOnMesh> ball,
                         const PartSampling& sampling, std::size_t most_samples)
    : source_{SampledMesh{std::move(ball), net.is_coarser}},
      spacing_{sampling.spacing},
      accessible_distance_{sampling.accessible_distance},
      guard_{sampling.guard},
      most_samples_{most_samples},
      triangles_{net.triangles}
{
    for (std::size_t k = 0; k < net.points.size(); ++k)
        add_sample(net.points[k], net.normals[k]);
    representatives_.resize(size());
    std::iota(representatives_.begin(), representatives_.end(), 0);
    refine();
    find_accessible();
    number_by_place();
    join();
    seat();
}

std::int32_t PartSamples::add_sample(const SurfacePoint& at, int number)
{
    const auto& [surfaces, sides] = std::get<SampledSurfaces>(source_);
    const Surface& surface = surfaces[number];
    points_.push_back(surface.tangents(at.u, at.v).point);
    normals_.push_back(tool_normal(surface, sides[number], at.u, at.v));
    parameters_.push_back(at);
    surface_of_.push_back(number);
    return static_cast<std::int32_t>(points_.size() - 1);
}

std::int32_t PartSamples::add_sample(const Vec3& point, const Vec3& normal)
{
    points_.push_back(point);
    normals_.push_back(normal);
    parameters_.push_back({point.x(), point.y()});
    surface_of_.push_back(0);
    return static_cast<std::int32_t>(points_.size() - 1);
}

std::int32_t PartSamples::add_middle(std::int32_t a, std::int32_t b, double share)
{
    if (const auto* mesh = std::get_if<SampledMesh>(&source_)) {
        const CutterContact at = mesh_place(*mesh, {a, b, share});
        return add_sample(at.point, at.normal);
    }
    return add_sample({(parameters_[a].u + parameters_[b].u) / 2,
                       (parameters_[a].v + parameters_[b].v) / 2},
                      surface_of_[a]);
}

void PartSamples::add_surface(const Surface& surface, int number)
{
    FirstLines lines{equal_lines(surface, Parameter::U),
                     equal_lines(surface, Parameter::V)};
    // surfaces beside each other need samples at the same places of their border
    if (std::get<SampledSurfaces>(source_).surfaces.size() == 1)
        lines = even_lines(surface, lines, spacing_ / std::numbers::sqrt2);
    const std::vector<double>& us = lines.us;
    const std::vector<double>& vs = lines.vs;
    const std::size_t first = points_.size();
    for (const double v : vs)
        for (const double u : us)
            add_sample({u, v}, number);
    const auto corner = [&](std::size_t i, std::size_t j) {
        return static_cast<std::int32_t>(first + j * us.size() + i);
    };
    for (std::size_t j = 0; j + 1 < vs.size(); ++j)
        for (std::size_t i = 0; i + 1 < us.size(); ++i) {
            const std::int32_t a = corner(i, j);
            const std::int32_t b = corner(i + 1, j);
            const std::int32_t c = corner(i + 1, j + 1);
            const std::int32_t d = corner(i, j + 1);
            // the shorter diagonal makes the better triangles
            if ((points_[a] - points_[c]).norm() <= (points_[b] - points_[d]).norm()) {
                triangles_.push_back({a, b, c});
                triangles_.push_back({a, c, d});
            } else {
                triangles_.push_back({a, b, d});
                triangles_.push_back({b, c, d});
            }
        }
}

// Refuses a part early: a triangle with sides of at most s has at most the area sqrt(3) / 4
// s^2, and there are about two triangles for each sample.
void PartSamples::require_enough() const
{
    double area = 0;
    for (const Triangle& triangle : triangles_) {
        const Vec3& a = points_[triangle[0]];
        area += (points_[triangle[1]] - a).cross(points_[triangle[2]] - a).norm() / 2;
    }
    const double needed = area / (std::sqrt(0.75) * spacing_ * spacing_);
    if (needed > static_cast<double>(most_samples_))
        throw_too_many_samples(needed, most_samples_);
}

// Halves the longest edge of every triangle, until none is longer than the spacing. Sides of
// the triangles then differ by less than if all long edges were halved at once.
void PartSamples::refine()
{
    require_enough();
    const auto middle = [&](std::int32_t a, std::int32_t b) {
        return add_middle(a, b, 0.5);
    };
    while (divide_edges(longest_edges(), middle)) {
    }
}

// The longest edge of each triangle, if it is longer than the spacing.
std::vector<MeshEdge> PartSamples::longest_edges() const
{
    std::vector<MeshEdge> longest;
    for (const Triangle& triangle : triangles_) {
        double square = spacing_ * spacing_;
        int found = -1;
        for (int k = 0; k < 3; ++k) {
            const Vec3 way = points_[triangle[k]] - points_[triangle[(k + 1) % 3]];
            const double own = way.squaredNorm();
            if (own > square * (found < 0 ? 1 : 1 + same_length)) {
                square = own;
                found = k;
            }
        }
        if (found >= 0)
            longest.push_back({triangle[found], triangle[(found + 1) % 3]});
    }
    return longest;
}

// Divides edges by new samples, and the triangles at them. Edges of twins are divided
// together.
// \return whether there are any.
bool PartSamples::divide_edges(
    std::span<const MeshEdge> edges,
    const std::function<std::int32_t(std::int32_t a, std::int32_t b)>& add_between)
{
    if (edges.empty())
        return false;
    const auto place_of = [&](std::int32_t a, std::int32_t b) {
        const auto [low, high] = std::minmax(representatives_[a], representatives_[b]);
        return MeshEdge{low, high};
    };
    // the middles by the places of the edges, that of the first of twins
    EdgeMiddles places;
    std::vector<char> is_end(size(), 0);  // whether an edge ends at the place
    for (const auto& [a, b] : edges) {
        const auto [low, high] = place_of(a, b);
        places.add(low, high, -1);
        is_end[low] = is_end[high] = 1;
    }
    std::vector<char> may_be_divided;
    may_be_divided.reserve(triangles_.size());
    for (const auto& [a, b, c] : triangles_) {
        const int ends = is_end[representatives_[a]] + is_end[representatives_[b]] +
                         is_end[representatives_[c]];
        may_be_divided.push_back(ends > 1 ? 1 : 0);
    }
    EdgeMiddles middles;
    for (std::size_t number = 0; number < triangles_.size(); ++number)
        for (int k = 0; k < 3 && may_be_divided[number] != 0; ++k) {
            const Triangle& triangle = triangles_[number];
            const auto [a, b] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
            const auto [low, high] = place_of(a, b);
            std::int32_t* const first = places.find(low, high);
            if (!first || middles.of(a, b))
                continue;
            if (points_.size() >= most_samples_)
                throw_too_many_samples(static_cast<double>(points_.size()),
                                       most_samples_);
            const std::int32_t middle = add_between(a, b);
            *first = *first < 0 ? middle : *first;
            representatives_.push_back(*first);
            middles.add(a, b, middle);
        }
    triangles_ = divided_triangles(triangles_, middles, may_be_divided);
    return true;
}

// Halvings of an edge in search of the last place that the ball can reach.
constexpr int border_halvings = 6;

// Adds a sample at a share of the way between two others.
std::int32_t PartSamples::add_at(std::int32_t a, std::int32_t b, double share)
{
    if (is_mesh())
        return add_middle(a, b, share);
    const SurfacePoint& from = parameters_[a];
    const SurfacePoint& to = parameters_[b];
    return add_sample({std::lerp(from.u, to.u, share), std::lerp(from.v, to.v, share)},
                      surface_of_[a]);
}

// A place between two samples, on the part itself.
CutterContact PartSamples::exact_place(const SampleEdge& at) const
{
    if (const auto* mesh = std::get_if<SampledMesh>(&source_))
        return mesh_place(*mesh, at);
    const SurfacePoint& from = parameters_[at.from];
    const SurfacePoint& to = parameters_[at.to];
    return on_surface(
        {std::lerp(from.u, to.u, at.share), std::lerp(from.v, to.v, at.share)},
        surface_of_[at.from]);
}

// Whether the ball comes near enough to a place.
bool PartSamples::is_reached(const CutterContact& place) const
{
    const auto* mesh = std::get_if<SampledMesh>(&source_);
    return (!mesh || mesh->ball->is_accessible(place, accessible_distance_)) &&
           (!guard_ || guard_->is_accessible(place, accessible_distance_));
}

// Finds which samples need not be covered, and divides the edges between them and the others
// at the last place that the ball reaches.
void PartSamples::find_accessible()
{
    std::vector<char> reached(size());
    parallel_for(size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            reached[i] = is_reached({points_[i], normals_[i]}) ? 1 : 0;
    });
    if (!is_mesh() && std::find(reached.begin(), reached.end(), 0) == reached.end())
        return;
    if (guard_ && std::find(reached.begin(), reached.end(), 1) == reached.end())
        throw GeometryError{
            "the ball comes near no place of the part, which the protected part bars"};
    is_wanted_.assign(reached.begin(), reached.end());
    divide_edges(
        edges_between(triangles_, is_wanted_), [&](std::int32_t a, std::int32_t b) {
            const std::int32_t inside = is_wanted_[a] ? a : b;
            const std::int32_t outside = is_wanted_[a] ? b : a;
            double share = 0;
            for (double step = 0.5; step >= std::exp2(-border_halvings); step /= 2)
                if (is_reached(exact_place({inside, outside, share + step})))
                    share += step;
            is_wanted_.push_back(true);
            return add_at(inside, outside, share);
        });
}

// The contact of the ball that is wanted at a place, moved to where the ball does not enter
// the mesh or the protected part.
CutterContact PartSamples::seated(const CutterContact& place) const
{
    const auto* mesh = std::get_if<SampledMesh>(&source_);
    const CutterContact seat = mesh ? mesh->ball->seated(place) : place;
    return guard_ ? guard_->held_off(seat, accessible_distance_) : seat;
}

// Finds the contacts of the ball at the samples.
void PartSamples::seat()
{
    seats_.resize(size());
    parallel_for(size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            seats_[i] = seated({points_[i], normals_[i]});
    });
    // where nothing is held off, the samples are those of a part without protection
    if (!is_mesh() && std::equal(seats_.begin(), seats_.end(), points_.begin(),
                                 [](const CutterContact& seat, const Vec3& point) {
                                     return seat.point == point;
                                 }))
        seats_.clear();
}

double PartSamples::unwanted_area() const
{
    double area = 0;
    for (const Triangle& triangle : triangles_) {
        const auto& [a, b, c] = triangle;
        if (!is_wanted(a) || !is_wanted(b) || !is_wanted(c))
            area += (points_[b] - points_[a]).cross(points_[c] - points_[a]).norm() / 2;
    }
    return area;
}

// Numbers samples and triangles by their places.
void PartSamples::number_by_place()
{
    const std::vector<std::int32_t> number = numbers_by_place(points_);
    const auto arrange = [&](auto& values) {
        auto arranged = values;
        for (std::size_t i = 0; i < values.size(); ++i)
            arranged[number[i]] = values[i];
        values = std::move(arranged);
    };
    // twins take the lowest of their new numbers
    std::vector<std::int32_t> lowest(size(), static_cast<std::int32_t>(size()));
    for (std::size_t i = 0; i < size(); ++i)
        lowest[representatives_[i]] = std::min(lowest[representatives_[i]], number[i]);
    for (std::int32_t& representative : representatives_)
        representative = lowest[representative];
    arrange(representatives_);
    arrange(points_);
    arrange(normals_);
    arrange(parameters_);
    arrange(surface_of_);
    arrange(is_wanted_);
    for (Triangle& triangle : triangles_)
        for (std::int32_t& corner : triangle)
            corner = number[corner];
    std::stable_sort(triangles_.begin(), triangles_.end(),
                     [](const Triangle& a, const Triangle& b) {
                         return *std::min_element(a.begin(), a.end()) <
                                *std::min_element(b.begin(), b.end());
                     });
}

void PartSamples::find_twins(std::span<const Surface> surfaces)
{
    const double same = 1e-9 * std::max(1.0, spacing_);
    representatives_.resize(size());
    std::iota(representatives_.begin(), representatives_.end(), 0);
    // only samples on the sides of a surface can have twins
    std::vector<std::int32_t> candidates;
    for (std::size_t i = 0; i < size(); ++i) {
        const Surface& surface = surfaces[surface_of_[i]];
        const Interval u = surface.range(Parameter::U);
        const Interval v = surface.range(Parameter::V);
        const SurfacePoint& at = parameters_[i];
        if (at.u == u.low || at.u == u.high || at.v == v.low || at.v == v.high)
            candidates.push_back(static_cast<std::int32_t>(i));
    }
    std::sort(candidates.begin(), candidates.end(), [&](std::int32_t a, std::int32_t b) {
        return points_[a].x() != points_[b].x() ? points_[a].x() < points_[b].x() : a < b;
    });
    for (std::size_t k = 0; k < candidates.size(); ++k)
        for (std::size_t l = k + 1;
             l < candidates.size() &&
             points_[candidates[l]].x() - points_[candidates[k]].x() <= same;
             ++l) {
            const std::int32_t a = candidates[k];
            const std::int32_t b = candidates[l];
            if ((points_[a] - points_[b]).norm() > same ||
                normals_[a].dot(normals_[b]) < 1 - 1e-9)
                continue;
            const std::int32_t low = std::min(representatives_[a], representatives_[b]);
            representatives_[a] = representatives_[b] = low;
        }
    for (const std::int32_t a : candidates)
        while (representatives_[representatives_[a]] != representatives_[a])
            representatives_[a] = representatives_[representatives_[a]];
}

void PartSamples::join()
{
    border_ = net_border(triangles_, representatives_);
    neighbours_ = net_neighbours(triangles_, representatives_);
    at_samples_ = net_triangles_at(triangles_, size());
}

// The place of a mesh between two others in one triangle.
CutterContact PartSamples::mesh_place(const SampledMesh& mesh, const CutterContact& from,
                                      const CutterContact& to, double share)
{
    Vec3 point = from.point + share * (to.point - from.point);
    if (mesh.is_coarser && from.point != to.point)
        point = mesh.ball->nearest(point);
    const Vec3 normal = (1 - share) * from.normal + share * to.normal;
    return {point, normal.norm() > 0 ? normal.normalized() : from.normal};
}

CutterContact PartSamples::mesh_place(const SampledMesh& mesh, const SampleEdge& at) const
{
    return mesh_place(mesh, {points_[at.from], normals_[at.from]},
                      {points_[at.to], normals_[at.to]}, at.share);
}

// Point and normal of a surface.
CutterContact PartSamples::on_surface(const SurfacePoint& at, int number) const
{
    const auto& [surfaces, sides] = std::get<SampledSurfaces>(source_);
    const Surface& surface = surfaces[number];
    return {surface.tangents(at.u, at.v).point,
            tool_normal(surface, sides[number], at.u, at.v)};
}

PassContact PartSamples::contact(const SurfacePoint& at, std::int32_t near) const
{
    const int number = surface_of_[near];
    return {{at.u, at.v, seated(on_surface(at, number))}, number, near};
}

PassContact PartSamples::contact(const SampleEdge& place) const
{
    const std::int32_t near = place.share < 0.5 ? place.from : place.to;
    if (const auto* mesh = std::get_if<SampledMesh>(&source_))
        return place.from == place.to
                   ? mesh_contact(seats_[near], near)
                   : mesh_contact(seated(mesh_place(*mesh, place)), near);
    const SurfacePoint& from = parameters_[place.from];
    const SurfacePoint& to = parameters_[place.to];
    return contact(
        {std::lerp(from.u, to.u, place.share), std::lerp(from.v, to.v, place.share)},
        near);
}

CutterContact PartSamples::near_place(const CutterContact& from, const CutterContact& to,
                                      double share) const
{
    if (const auto* mesh = std::get_if<SampledMesh>(&source_))
        return mesh_place(*mesh, from, to, share);
    return near_contact(from, to, share);
}

CutterContact PartSamples::near_place(const SampleEdge& place) const
{
    const CutterContact from = place_at(place.from);
    return place.from == place.to ? from
                                  : near_place(from, place_at(place.to), place.share);
}

PassContact PartSamples::between(const PassContact& from, const PassContact& to,
                                 double share) const
{
    const std::int32_t near = share < 0.5 ? from.near : to.near;
    if (const auto* mesh = std::get_if<SampledMesh>(&source_)) {
        CutterContact at = mesh_place(*mesh, from.at.contact, to.at.contact, share);
        at.point = mesh->ball->nearest(at.point);
        return mesh_contact(seated(at), near);
    }
    return contact(
        {std::lerp(from.at.u, to.at.u, share), std::lerp(from.at.v, to.at.v, share)},
        near);
}

bool PartSamples::is_joined(const PassContact& from, const PassContact& to) const
{
    if (from.surface != to.surface)
        return false;
    // The middle is nearer to both than they are to each other.
    const auto is_between = [](const Vec3& middle, const Vec3& a, const Vec3& b) {
        const double way = (b - a).norm();
        return way > 0 && (middle - a).norm() < way && (middle - b).norm() < way;
    };
    if (const auto* mesh = std::get_if<SampledMesh>(&source_)) {
        const BallCutter& cutter = mesh->ball->cutter();
        return is_between(ball_centre(between(from, to, 0.5).at, cutter),
                          ball_centre(from.at, cutter), ball_centre(to.at, cutter));
    }
    const Surface& surface = std::get<SampledSurfaces>(source_).surfaces[from.surface];
    return is_between(
        surface.tangents((from.at.u + to.at.u) / 2, (from.at.v + to.at.v) / 2).point,
        from.at.contact.point, to.at.contact.point);
}

}  // namespace endmill
