// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/part_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
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

// Steps of the first net across each patch. Its edges are then halved until they are short
// enough; a patch whose curves oscillate more often than this within a step is not resolved.
constexpr int first_steps = 8;

// The parameters of the first net: every patch border, and equal steps between them.
std::vector<double> first_lines(const Surface& surface, Parameter along)
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

[[noreturn]] void throw_too_many(double needed, std::size_t most_samples)
{
    std::ostringstream message;
    message << std::setprecision(2) << "the part would need more than " << needed
            << " samples at this scallop height; expected at most "
            << static_cast<double>(most_samples)
            << " for the memory (--max-memory); a larger --scallop needs fewer";
    throw LimitError{message.str()};
}

}  // namespace

PartSamples::PartSamples(std::span<const Surface> surfaces, std::span<const double> sides,
                         double spacing, std::size_t most_samples)
    : source_{SampledSurfaces{surfaces, {sides.begin(), sides.end()}}},
      spacing_{spacing},
      most_samples_{most_samples}
{
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        add_surface(surfaces[k], static_cast<int>(k));
    find_twins(surfaces);
    refine();
    number_by_place();
    join();
}

PartSamples::PartSamples(const MeshNet& net, std::shared_ptr<const BallOnMesh> ball,
                         const MeshSampling& sampling, std::size_t most_samples)
    : source_{SampledMesh{std::move(ball), net.is_coarser}},
      spacing_{sampling.spacing},
      most_samples_{most_samples},
      triangles_{net.triangles}
{
    for (std::size_t k = 0; k < net.points.size(); ++k)
        add_sample(net.points[k], net.normals[k]);
    representatives_.resize(size());
    std::iota(representatives_.begin(), representatives_.end(), 0);
    refine();
    find_accessible(sampling.accessible_distance);
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
    const std::vector<double> us = first_lines(surface, Parameter::U);
    const std::vector<double> vs = first_lines(surface, Parameter::V);
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
        throw_too_many(needed, most_samples_);
}

// Halves every edge that is longer than the spacing, until there is none.
void PartSamples::refine()
{
    require_enough();
    const auto is_long = [&](std::int32_t a, std::int32_t b) {
        return (points_[a] - points_[b]).norm() > spacing_;
    };
    const auto middle = [&](std::int32_t a, std::int32_t b) {
        return add_middle(a, b, 0.5);
    };
    while (divide_edges(is_long, middle)) {
    }
}

// Divides edges by new samples, and the triangles at them. Edges of twins are divided
// together.
// \return whether there are any.
bool PartSamples::divide_edges(
    const std::function<bool(std::int32_t a, std::int32_t b)>& is_divided,
    const std::function<std::int32_t(std::int32_t a, std::int32_t b)>& add_between)
{
    const std::vector<NetEdge> edges = net_edges(triangles_, representatives_);
    EdgeMiddles middles;
    for (std::size_t k = 0, next = 0; k < edges.size(); k = next) {
        bool is_any = false;
        for (; next < edges.size() && edges[next][0] == edges[k][0] &&
               edges[next][1] == edges[k][1];
             ++next)
            is_any = is_any || is_divided(edges[next][2], edges[next][3]);
        std::int32_t representative = -1;
        for (std::size_t l = k; l < next && is_any; ++l) {
            const auto [ra, rb, a, b] = edges[l];
            if (middles.of(a, b))
                continue;
            if (points_.size() >= most_samples_)
                throw LimitError{"the part needs more than " +
                                 std::to_string(most_samples_) +
                                 " samples for this scallop height"};
            const std::int32_t middle = add_between(a, b);
            representative = representative < 0 ? middle : representative;
            representatives_.push_back(representative);
            middles.add(a, b, middle);
        }
    }
    if (middles.empty())
        return false;
    triangles_ = divided_triangles(triangles_, middles);
    return true;
}

// Halvings of an edge in search of the last place that the ball can reach.
constexpr int border_halvings = 6;

// Finds which samples of a mesh need not be covered, and divides the edges between them and
// the others at the last place that the ball reaches.
void PartSamples::find_accessible(double distance)
{
    const SampledMesh& mesh = std::get<SampledMesh>(source_);
    const auto is_reached = [&](const CutterContact& place) {
        return mesh.ball->is_accessible(place, distance);
    };
    std::vector<char> reached(size());
    parallel_for(size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            reached[i] = is_reached({points_[i], normals_[i]}) ? 1 : 0;
    });
    is_wanted_.assign(reached.begin(), reached.end());
    divide_edges(
        [&](std::int32_t a, std::int32_t b) { return is_wanted_[a] != is_wanted_[b]; },
        [&](std::int32_t a, std::int32_t b) {
            const std::int32_t inside = is_wanted_[a] ? a : b;
            const std::int32_t outside = is_wanted_[a] ? b : a;
            double share = 0;
            for (double step = 0.5; step >= std::exp2(-border_halvings); step /= 2)
                if (is_reached(mesh_place(mesh, {inside, outside, share + step})))
                    share += step;
            is_wanted_.push_back(true);
            return add_middle(inside, outside, share);
        });
}

// Finds the contacts of the ball at the samples of a mesh.
void PartSamples::seat()
{
    const SampledMesh& mesh = std::get<SampledMesh>(source_);
    seats_.resize(size());
    parallel_for(size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            seats_[i] = mesh.ball->seated({points_[i], normals_[i]});
    });
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

PassContact PartSamples::contact(const SurfacePoint& at, std::int32_t near) const
{
    const int number = surface_of_[near];
    const auto& [surfaces, sides] = std::get<SampledSurfaces>(source_);
    const Surface& surface = surfaces[number];
    return {{at.u,
             at.v,
             {surface.tangents(at.u, at.v).point,
              tool_normal(surface, sides[number], at.u, at.v)}},
            number,
            near};
}

PassContact PartSamples::contact(const SampleEdge& place) const
{
    const std::int32_t near = place.share < 0.5 ? place.from : place.to;
    if (const auto* mesh = std::get_if<SampledMesh>(&source_))
        return place.from == place.to
                   ? mesh_contact(seats_[near], near)
                   : mesh_contact(mesh->ball->seated(mesh_place(*mesh, place)), near);
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
        return mesh_contact(mesh->ball->seated(at), near);
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
