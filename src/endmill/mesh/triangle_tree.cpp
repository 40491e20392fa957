// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr float no_box = std::numeric_limits<float>::infinity();
// mm, so that boxes and squared distances stay finite
constexpr double largest_length = 1e30;
// Lengths of a ray's direction, so that neither it nor its inverse loses digits.
constexpr double shortest_direction = 1e-100;
constexpr double longest_direction = 1e100;
constexpr std::size_t fan_out = 4;  // children of a node, and triangles of a leaf
// Margin for the rounding of a ray with a far origin, and of a large distance, as a share
// of the largest coordinate.
constexpr double question_margin = 1e-13;

double largest_coordinate(const Vec3& point)
{
    return point.lpNorm<Eigen::Infinity>();
}

bool is_within_reach(const Vec3& point)
{
    return (point.array().abs() <= largest_length).all();  // false for NaN
}

float rounded_down(double value)
{
    const auto rounded = static_cast<float>(value);
    return rounded <= value ? rounded : std::nextafter(rounded, -no_box);
}

Eigen::Index place_in_node(std::size_t child)
{
    return static_cast<Eigen::Index>(child % fan_out);
}

// Centre of a triangle, by which triangles are ordered.
struct Centre {
    std::array<float, 3> place;
    std::int32_t triangle;
};

int widest_axis(std::span<const Centre> centres)
{
    std::array<float, 3> low = centres.front().place;
    std::array<float, 3> high = low;
    for (const Centre& centre : centres)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], centre.place[axis]);
            high[axis] = std::max(high[axis], centre.place[axis]);
        }
    int widest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (high[axis] - low[axis] > high[widest] - low[widest])
            widest = axis;
    return widest;
}

// Orders the triangles by recursive halving: the half with the lower centres along the
// widest axis goes to the lower half of the `capacity` places, and so on down to leaves.
void arrange_centres(std::span<Centre> centres, std::size_t capacity)
{
    if (centres.size() <= fan_out)
        return;
    const std::size_t half = capacity / 2;
    if (centres.size() <= half)
        return arrange_centres(centres, half);
    const int axis = widest_axis(centres);
    std::ranges::nth_element(centres, centres.begin() + static_cast<std::ptrdiff_t>(half),
                             [axis](const Centre& a, const Centre& b) {
                                 return std::pair{a.place[axis], a.triangle} <
                                        std::pair{b.place[axis], b.triangle};
                             });
    arrange_centres(centres.first(half), half);
    arrange_centres(centres.subspan(half), half);
}

// Takes the ends of a segment in one order, so that triangles that share an edge find the
// same point.
Vec3 nearest_on_segment(const Vec3& place, const Vec3& end_a, const Vec3& end_b)
{
    const bool in_order = !std::ranges::lexicographical_compare(end_b, end_a);
    const Vec3& a = in_order ? end_a : end_b;
    const Vec3& b = in_order ? end_b : end_a;
    const Vec3 along = b - a;
    const double share = along.dot(place - a);
    const double square = along.squaredNorm();
    if (!(share > 0))
        return a;
    return share < square ? Vec3{a + share / square * along} : b;
}

Vec3 nearer(const Vec3& place, const Vec3& a, const Vec3& b)
{
    return (a - place).squaredNorm() <= (b - place).squaredNorm() ? a : b;
}

}  // namespace

// Works in the frame of the longest side a-b and the height over it: s counts along the
// side, h along the height up to the corner c. This frame loses no digits if the triangle
// is thin. The angles at a and b are acute, so a place below the side is nearest to the
// side.
Vec3 nearest_on_triangle(const Vec3& place, const std::array<Vec3, 3>& corners)
{
    const std::array<double, 3> squares{(corners[1] - corners[0]).squaredNorm(),
                                        (corners[2] - corners[1]).squaredNorm(),
                                        (corners[0] - corners[2]).squaredNorm()};
    const auto longest = std::ranges::max_element(squares) - squares.begin();
    const Vec3& a = corners[longest];
    const Vec3& b = corners[(longest + 1) % 3];
    const Vec3& c = corners[(longest + 2) % 3];
    const Vec3 side = b - a;
    const double top = side.dot(c - a) / squares[longest];
    const Vec3 height = c - a - top * side;
    const double s = side.dot(place - a) / squares[longest];
    const double h = height.dot(place - a - s * side) / height.squaredNorm();
    if (!(h > 0))  // also if the triangle has no height
        return nearest_on_segment(place, a, b);
    if (h * top <= s && s <= 1 - h * (1 - top))
        return a + s * side + h * height;
    return nearer(place, nearest_on_segment(place, a, c),
                  nearest_on_segment(place, b, c));
}

// A query for the nearest point: the best result so far, and the lower bounds of boxes.
struct TriangleTree::NearestQuery {
    Vec3 place;
    double margin;  // mm, by which a box is larger
    NearestPoint best{{}, infinity, 0};
    double least_square = infinity;  // mm^2

    double limit() const { return least_square; }

    // Squared distances to four boxes.
    Eigen::Array4d bounds(const Boxes& boxes) const
    {
        Eigen::Array4d squares = Eigen::Array4d::Zero();
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Array4d below = boxes.low[axis].cast<double>() - place[axis];
            const Eigen::Array4d above = place[axis] - boxes.high[axis].cast<double>();
            squares += below.max(above).max(0).square();
        }
        return (1 - question_margin) * squares;
    }

    // Lower bound for one triangle, by its box. It takes a third of the time of the
    // triangle itself.
    double bound(const std::array<Vec3, 3>& corners) const
    {
        const auto& [a, b, c] = corners;
        const Vec3 below = a.cwiseMin(b).cwiseMin(c) - place;
        const Vec3 above = place - a.cwiseMax(b).cwiseMax(c);
        const Vec3 offset = (below.cwiseMax(above).array() - margin).cwiseMax(0);
        return (1 - question_margin) * offset.squaredNorm();
    }

    void look_at(const TriangleMesh& mesh, std::size_t triangle)
    {
        const std::array<Vec3, 3> corners = mesh.corners(triangle);
        if (bound(corners) > least_square)
            return;
        const Vec3 point = nearest_on_triangle(place, corners);
        const double square = (point - place).squaredNorm();
        if (square < least_square ||
            (square == least_square && triangle < best.triangle)) {
            least_square = square;
            best.point = point;
            best.triangle = triangle;
        }
    }
};

// A query for the first hit. The axes are permuted so that the ray runs mainly along the
// last one. Projected along the ray onto the plane of the other two, the ray is a point,
// and the hit is decided in that plane.
struct TriangleTree::RayQuery {
    Ray ray;
    std::array<int, 3> axes{};
    // of the first two axes against the main one; and 1 over its component
    Vec3 shear = Vec3::Zero();
    std::array<double, 3> inverse{};   // of the direction's components
    std::array<bool, 3> is_falling{};  // whether the direction's components are negative
    double margin = 0;                 // mm, by which a box is larger
    double greatest_t = infinity;
    bool any_will_do = false;
    std::optional<std::size_t> triangle{};

    double limit() const { return any_will_do && triangle ? -infinity : greatest_t; }

    // The t at which the ray enters four boxes; infinite for boxes that it misses.
    Eigen::Array4d bounds(const Boxes& boxes) const
    {
        Eigen::Array4d enter = Eigen::Array4d::Zero();
        Eigen::Array4d leave = Eigen::Array4d::Constant(infinity);
        for (int axis = 0; axis < 3; ++axis) {
            const bool falls = is_falling[axis];
            const Eigen::Array4f& first = falls ? boxes.high[axis] : boxes.low[axis];
            const Eigen::Array4f& last = falls ? boxes.low[axis] : boxes.high[axis];
            const double outwards = falls ? -margin : margin;
            const double begin = ray.origin[axis] + outwards;
            const double end = ray.origin[axis] - outwards;
            enter = enter.max((first.cast<double>() - begin) * inverse[axis]);
            leave = leave.min((last.cast<double>() - end) * inverse[axis]);
        }
        return (enter <= leave).select(enter, infinity);
    }

    void look_at(const TriangleMesh& mesh, std::size_t number)
    {
        std::array<double, 3> x;
        std::array<double, 3> y;
        std::array<double, 3> t;
        const auto corners = mesh.corners(number);
        for (int k = 0; k < 3; ++k) {
            const Vec3 from = corners[k] - ray.origin;
            x[k] = from[axes[0]] - shear[0] * from[axes[2]];
            y[k] = from[axes[1]] - shear[1] * from[axes[2]];
            t[k] = shear[2] * from[axes[2]];
        }
        // Twice the signed areas between the projected ray and the sides. The sign of a
        // rounded difference of two products is never wrong; at worst the difference is
        // 0, which counts as inside.
        const double u = x[2] * y[1] - y[2] * x[1];
        const double v = x[0] * y[2] - y[0] * x[2];
        const double w = x[1] * y[0] - y[1] * x[0];
        if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0))
            return;
        const double whole = u + v + w;
        if (whole == 0)
            return;
        const double hit = u / whole * t[0] + v / whole * t[1] + w / whole * t[2];
        if (hit >= 0 && (hit < greatest_t ||
                         (hit == greatest_t && (!triangle || number < *triangle)))) {
            greatest_t = hit;
            triangle = number;
        }
    }
};

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_{&mesh}
{
    for (const Vec3& point : mesh.points())
        largest_coordinate_ = std::max(largest_coordinate_, largest_coordinate(point));
    require(largest_coordinate_ <= largest_length,
            "TriangleTree: coordinates must be within 1e30 mm");
    if (mesh.triangles().empty())
        return;
    arrange();
    enclose();
}

// Fills order_.
void TriangleTree::arrange()
{
    std::vector<Centre> centres;
    centres.reserve(mesh_->triangles().size());
    for (std::size_t k = 0; k < mesh_->triangles().size(); ++k) {
        const auto [a, b, c] = mesh_->corners(k);
        const Eigen::Vector3f sum = (a + b + c).cast<float>();
        centres.push_back({{sum.x(), sum.y(), sum.z()}, static_cast<std::int32_t>(k)});
    }
    std::size_t capacity = fan_out;
    while (capacity < centres.size())
        capacity *= fan_out;
    arrange_centres(centres, capacity);
    order_.reserve(centres.size());
    for (const Centre& centre : centres)
        order_.push_back(centre.triangle);
}

// Fills levels_: first the boxes of the leaves, then level by level the boxes around
// them.
void TriangleTree::enclose()
{
    const Eigen::Array4f none = Eigen::Array4f::Constant(no_box);
    const Boxes nothing{{none, none, none}, {-none, -none, -none}};
    const auto nodes_over = [](std::size_t count) {
        return (count + fan_out - 1) / fan_out;
    };
    const Vec3 margin = Vec3::Constant(box_margin_share * largest_coordinate_);
    const std::size_t leaves = nodes_over(order_.size());
    levels_.emplace_back(nodes_over(leaves), nothing);
    for (std::size_t k = 0; k < order_.size(); ++k) {
        const auto [a, b, c] = mesh_->corners(order_[k]);
        const Vec3 low = a.cwiseMin(b).cwiseMin(c) - margin;
        const Vec3 high = a.cwiseMax(b).cwiseMax(c) + margin;
        const std::size_t leaf = k / fan_out;
        Boxes& boxes = levels_[0][leaf / fan_out];
        for (int axis = 0; axis < 3; ++axis) {
            float& box_low = boxes.low[axis][place_in_node(leaf)];
            float& box_high = boxes.high[axis][place_in_node(leaf)];
            box_low = std::min(box_low, rounded_down(low[axis]));
            box_high = std::max(box_high, -rounded_down(-high[axis]));
        }
    }
    while (levels_.back().size() > 1) {
        const std::vector<Boxes>& below = levels_.back();
        std::vector<Boxes> level(nodes_over(below.size()), nothing);
        for (std::size_t k = 0; k < below.size(); ++k)
            for (int axis = 0; axis < 3; ++axis) {
                level[k / fan_out].low[axis][place_in_node(k)] =
                    below[k].low[axis].minCoeff();
                level[k / fan_out].high[axis][place_in_node(k)] =
                    below[k].high[axis].maxCoeff();
            }
        levels_.push_back(std::move(level));
    }
}

template <typename Query>
void TriangleTree::ask_triangles(Query& query, std::size_t leaf) const
{
    const std::size_t begin = leaf * fan_out;
    const std::size_t end = std::min(begin + fan_out, order_.size());
    for (std::size_t k = begin; k < end; ++k)
        query.look_at(*mesh_, static_cast<std::size_t>(order_[k]));
}

// Traverses the tree from the root. Children are visited in the order of their bounds,
// and those beyond the query's limit are skipped.
template <typename Query>
void TriangleTree::ask(Query& query) const
{
    struct Child {
        double bound;
        std::uint32_t node;
        std::int32_t level;  // -1 for a leaf
    };
    // 2^31 triangles make 15 levels. Each leaves at most three children waiting.
    std::array<Child, 64> waiting;
    std::size_t count = 0;
    waiting[count++] = {0, 0, static_cast<std::int32_t>(levels_.size()) - 1};
    while (count > 0) {
        const Child next = waiting[--count];
        if (next.bound > query.limit())
            continue;
        if (next.level < 0) {
            ask_triangles(query, next.node);
            continue;
        }
        const std::size_t before = count;
        const Eigen::Array4d bounds = query.bounds(levels_[next.level][next.node]);
        for (std::uint32_t k = 0; k < fan_out; ++k) {
            if (!(bounds[k] <= query.limit() && bounds[k] < infinity))
                continue;
            std::size_t place = count++;
            for (; place > before && waiting[place - 1].bound < bounds[k]; --place)
                waiting[place] = waiting[place - 1];
            waiting[place] = {bounds[k], next.node * 4 + k, next.level - 1};
        }
    }
}

std::optional<NearestPoint> TriangleTree::nearest(const Vec3& place,
                                                  std::optional<std::size_t> hint,
                                                  double within) const
{
    require(is_within_reach(place), "TriangleTree: a place must be within 1e30 mm");
    require(!hint || *hint < order_.size(), "TriangleTree: the hint is no triangle");
    if (order_.empty())
        return std::nullopt;
    NearestQuery query{place, box_margin_share * largest_coordinate_};
    query.least_square = within > 0 ? within * within : 0;
    const double asked = query.least_square;
    if (hint)
        query.look_at(*mesh_, *hint);
    ask(query);
    if (!(query.least_square < asked))
        return std::nullopt;
    query.best.distance = std::sqrt(query.least_square);
    return query.best;
}

TriangleTree::RayQuery TriangleTree::query(const Ray& ray, double greatest_t) const
{
    require(is_within_reach(ray.origin), "TriangleTree: a ray must begin within 1e30 mm");
    const double length = ray.direction.stableNorm();
    require(shortest_direction <= length && length <= longest_direction,
            "TriangleTree: a ray's direction must be 1e-100 to 1e100 long");
    RayQuery query{ray};
    query.greatest_t = greatest_t;
    int main_axis = 0;
    ray.direction.cwiseAbs().maxCoeff(&main_axis);
    query.axes = {(main_axis + 1) % 3, (main_axis + 2) % 3, main_axis};
    const double along = ray.direction[main_axis];
    query.shear = {ray.direction[query.axes[0]] / along,
                   ray.direction[query.axes[1]] / along, 1 / along};
    // Where the direction has a component of 0, a box is entered at once or never. Any
    // large number gives that result.
    constexpr double never = 1e250;
    for (int axis = 0; axis < 3; ++axis) {
        query.is_falling[axis] = std::signbit(ray.direction[axis]);
        query.inverse[axis] = std::clamp(1 / ray.direction[axis], -never, never);
    }
    query.margin =
        question_margin * (largest_coordinate(ray.origin) + largest_coordinate_);
    return query;
}

std::optional<RayHit> TriangleTree::first_hit(const Ray& ray) const
{
    RayQuery asked = query(ray, infinity);
    if (!order_.empty())
        ask(asked);
    if (!asked.triangle)
        return std::nullopt;
    return RayHit{asked.greatest_t, ray.origin + asked.greatest_t * ray.direction,
                  *asked.triangle};
}

bool TriangleTree::any_hit(const Ray& ray, double greatest_t) const
{
    RayQuery asked = query(ray, greatest_t);
    asked.any_will_do = true;
    if (!order_.empty())
        ask(asked);
    return asked.triangle.has_value();
}

}  // namespace endmill
