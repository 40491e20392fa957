// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/part_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <numeric>
#include <optional>
#include <sstream>
#include <unordered_map>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
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

// An edge of a triangle: the representatives of its ends, then its ends, lower ones first.
using NetEdge = std::array<std::int32_t, 4>;

std::vector<NetEdge> net_edges(std::span<const Triangle> triangles,
                               std::span<const std::int32_t> representatives)
{
    std::vector<NetEdge> edges;
    edges.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles)
        for (int k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax({triangle[k], triangle[(k + 1) % 3]});
            const auto [ra, rb] = std::minmax({representatives[a], representatives[b]});
            edges.push_back({ra, rb, a, b});
        }
    std::sort(edges.begin(), edges.end());
    return edges;
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

// The bits of three numbers from 0 to 1, interleaved; 21 of each.
std::uint64_t morton_code(const Vec3& place)
{
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        auto bits = static_cast<std::uint64_t>(place[axis] * 2097151.0);
        bits = (bits | bits << 32) & 0x1f00000000ffff;
        bits = (bits | bits << 16) & 0x1f0000ff0000ff;
        bits = (bits | bits << 8) & 0x100f00f00f00f00f;
        bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
        bits = (bits | bits << 2) & 0x1249249249249249;
        code |= bits << axis;
    }
    return code;
}

// Adds the parts of a triangle whose edges have the middles that `middle_of(a, b)` gives,
// or -1.
template <typename MiddleOf>
void divide(Triangle corners, std::vector<Triangle>& parts, const MiddleOf& middle_of)
{
    std::array<std::int32_t, 3> middles{};
    int count = 0;
    for (int k = 0; k < 3; ++k) {
        middles[k] = middle_of(corners[k], corners[(k + 1) % 3]);
        count += middles[k] >= 0 ? 1 : 0;
    }
    const auto turn = [&] {
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        std::rotate(middles.begin(), middles.begin() + 1, middles.end());
    };
    const auto& [a, b, c] = corners;
    const auto& [ab, bc, ca] = middles;
    if (count == 0) {
        parts.push_back(corners);
    } else if (count == 1) {
        while (ab < 0)
            turn();
        parts.push_back({a, ab, c});
        parts.push_back({ab, b, c});
    } else if (count == 2) {
        while (ca >= 0)
            turn();
        parts.push_back({ab, b, bc});
        parts.push_back({a, ab, bc});
        parts.push_back({a, bc, c});
    } else {
        parts.push_back({a, ab, ca});
        parts.push_back({ab, b, bc});
        parts.push_back({ca, bc, c});
        parts.push_back({ab, bc, ca});
    }
}

}  // namespace

PartSamples::PartSamples(std::span<const Surface> surfaces, std::span<const double> sides,
                         double spacing, std::size_t most_samples)
    : surfaces_{surfaces},
      sides_(sides.begin(), sides.end()),
      spacing_{spacing}
{
    for (std::size_t k = 0; k < surfaces.size(); ++k)
        add_surface(surfaces[k], static_cast<int>(k));
    find_twins();
    require_enough(most_samples);
    while (refine(most_samples)) {
    }
    number_by_place();
    find_neighbours();
    find_triangles();
}

std::int32_t PartSamples::add_sample(const SurfacePoint& at, int number)
{
    const Surface& surface = surfaces_[number];
    points_.push_back(surface.tangents(at.u, at.v).point);
    normals_.push_back(tool_normal(surface, sides_[number], at.u, at.v));
    parameters_.push_back(at);
    surface_of_.push_back(number);
    return static_cast<std::int32_t>(points_.size() - 1);
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
void PartSamples::require_enough(std::size_t most_samples) const
{
    double area = 0;
    for (const Triangle& triangle : triangles_) {
        const Vec3& a = points_[triangle[0]];
        area += (points_[triangle[1]] - a).cross(points_[triangle[2]] - a).norm() / 2;
    }
    const double needed = area / (std::sqrt(0.75) * spacing_ * spacing_);
    if (needed > static_cast<double>(most_samples))
        throw_too_many(needed, most_samples);
}

// Halves every edge that is longer than the spacing, and divides the triangles at such
// edges. Edges of twins are halved together.
bool PartSamples::refine(std::size_t most_samples)
{
    const std::vector<NetEdge> edges = net_edges(triangles_, representatives_);
    std::unordered_map<std::uint64_t, std::int32_t> middles;
    const auto key = [](std::int32_t a, std::int32_t b) {
        return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
               static_cast<std::uint64_t>(std::max(a, b));
    };
    for (std::size_t k = 0; k < edges.size();) {
        std::size_t next = k;
        bool is_long = false;
        for (; next < edges.size() && edges[next][0] == edges[k][0] &&
               edges[next][1] == edges[k][1];
             ++next)
            is_long =
                is_long ||
                (points_[edges[next][2]] - points_[edges[next][3]]).norm() > spacing_;
        std::int32_t representative = -1;
        for (; k < next; ++k) {
            const auto [ra, rb, a, b] = edges[k];
            if (!is_long || middles.contains(key(a, b)))
                continue;
            if (points_.size() >= most_samples)
                throw LimitError{"the part needs more than " +
                                 std::to_string(most_samples) +
                                 " samples for this scallop height"};
            const std::int32_t middle =
                add_sample({(parameters_[a].u + parameters_[b].u) / 2,
                            (parameters_[a].v + parameters_[b].v) / 2},
                           surface_of_[a]);
            representative = representative < 0 ? middle : representative;
            representatives_.push_back(representative);
            middles.emplace(key(a, b), middle);
        }
    }
    if (middles.empty())
        return false;
    std::vector<Triangle> divided;
    divided.reserve(triangles_.size() * 4);
    for (const Triangle& triangle : triangles_)
        divide(triangle, divided, [&](std::int32_t a, std::int32_t b) {
            const auto middle = middles.find(key(a, b));
            return middle == middles.end() ? -1 : middle->second;
        });
    triangles_ = std::move(divided);
    return true;
}

// Numbers samples and triangles along a curve that fills the box of the part, so that
// neighbours have near numbers and share cache lines.
void PartSamples::number_by_place()
{
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points_)
        box.extend(point);
    const double side = std::max(box.sizes().maxCoeff(), 1e-300);
    std::vector<std::pair<std::uint64_t, std::int32_t>> order(size());
    for (std::size_t i = 0; i < size(); ++i)
        order[i] = {morton_code((points_[i] - box.min()) / side),
                    static_cast<std::int32_t>(i)};
    std::sort(order.begin(), order.end());
    std::vector<std::int32_t> number(size());
    for (std::size_t k = 0; k < order.size(); ++k)
        number[order[k].second] = static_cast<std::int32_t>(k);
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
    for (Triangle& triangle : triangles_)
        for (std::int32_t& corner : triangle)
            corner = number[corner];
    std::stable_sort(triangles_.begin(), triangles_.end(),
                     [](const Triangle& a, const Triangle& b) {
                         return *std::min_element(a.begin(), a.end()) <
                                *std::min_element(b.begin(), b.end());
                     });
}

void PartSamples::find_twins()
{
    const double same = 1e-9 * std::max(1.0, spacing_);
    representatives_.resize(size());
    std::iota(representatives_.begin(), representatives_.end(), 0);
    // only samples on the sides of a surface can have twins
    std::vector<std::int32_t> candidates;
    for (std::size_t i = 0; i < size(); ++i) {
        const Surface& surface = surfaces_[surface_of_[i]];
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

void PartSamples::find_neighbours()
{
    std::vector<MeshEdge> edges;
    edges.reserve(3 * triangles_.size());
    for (const Triangle& triangle : triangles_)
        for (int k = 0; k < 3; ++k) {
            const std::int32_t a = triangle[k];
            const std::int32_t b = triangle[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b)});
        }
    std::sort(edges.begin(), edges.end());
    // the border: edges of one triangle whose places no other edge has
    std::vector<std::array<std::int32_t, 4>> single;
    for (std::size_t k = 0; k < edges.size();) {
        std::size_t next = k + 1;
        while (next < edges.size() && edges[next] == edges[k])
            ++next;
        if (next == k + 1) {
            const std::int32_t a = representatives_[edges[k][0]];
            const std::int32_t b = representatives_[edges[k][1]];
            if (a != b)
                single.push_back(
                    {std::min(a, b), std::max(a, b), edges[k][0], edges[k][1]});
        }
        k = next;
    }
    std::sort(single.begin(), single.end());
    for (std::size_t k = 0; k < single.size();) {
        std::size_t next = k + 1;
        while (next < single.size() && single[next][0] == single[k][0] &&
               single[next][1] == single[k][1])
            ++next;
        if (next == k + 1)
            border_.push_back({single[k][2], single[k][3]});
        k = next;
    }
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    // twins are neighbours through their representative
    for (std::size_t i = 0; i < size(); ++i)
        if (representatives_[i] != static_cast<std::int32_t>(i))
            edges.push_back({representatives_[i], static_cast<std::int32_t>(i)});
    first_neighbour_.assign(size() + 1, 0);
    for (const auto& [a, b] : edges) {
        ++first_neighbour_[a + 1];
        ++first_neighbour_[b + 1];
    }
    std::partial_sum(first_neighbour_.begin(), first_neighbour_.end(),
                     first_neighbour_.begin());
    neighbours_.resize(first_neighbour_.back());
    std::vector<std::size_t> next(first_neighbour_.begin(), first_neighbour_.end() - 1);
    for (const auto& [a, b] : edges) {
        neighbours_[next[a]++] = b;
        neighbours_[next[b]++] = a;
    }
}

void PartSamples::find_triangles()
{
    first_at_sample_.assign(size() + 1, 0);
    for (const Triangle& triangle : triangles_)
        for (const std::int32_t corner : triangle)
            ++first_at_sample_[corner + 1];
    std::partial_sum(first_at_sample_.begin(), first_at_sample_.end(),
                     first_at_sample_.begin());
    at_samples_.resize(first_at_sample_.back());
    std::vector<std::size_t> next(first_at_sample_.begin(), first_at_sample_.end() - 1);
    for (std::size_t number = 0; number < triangles_.size(); ++number)
        for (const std::int32_t corner : triangles_[number])
            at_samples_[next[corner]++] = static_cast<std::int32_t>(number);
}

PassContact PartSamples::contact(const SurfacePoint& at, std::int32_t near) const
{
    const int number = surface_of_[near];
    const Surface& surface = surfaces_[number];
    return {{at.u,
             at.v,
             {surface.tangents(at.u, at.v).point,
              tool_normal(surface, sides_[number], at.u, at.v)}},
            number,
            near};
}

PassContact PartSamples::contact(const SampleEdge& place) const
{
    const SurfacePoint& from = parameters_[place.from];
    const SurfacePoint& to = parameters_[place.to];
    return contact(
        {std::lerp(from.u, to.u, place.share), std::lerp(from.v, to.v, place.share)},
        place.share < 0.5 ? place.from : place.to);
}

PassContact PartSamples::between(const PassContact& from, const PassContact& to,
                                 double share) const
{
    return contact(
        {std::lerp(from.at.u, to.at.u, share), std::lerp(from.at.v, to.at.v, share)},
        share < 0.5 ? from.near : to.near);
}

bool PartSamples::is_joined(const PassContact& from, const PassContact& to) const
{
    if (from.surface != to.surface)
        return false;
    const Surface& surface = surfaces_[from.surface];
    const Vec3 middle =
        surface.tangents((from.at.u + to.at.u) / 2, (from.at.v + to.at.v) / 2).point;
    const Vec3& a = from.at.contact.point;
    const Vec3& b = to.at.contact.point;
    const double way = (b - a).norm();
    return way > 0 && (middle - a).norm() < way && (middle - b).norm() < way;
}

}  // namespace endmill
