// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "endmill/core/detail/large_pages.h"
#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/mesh/detail/nearest_bounds.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// mm, so that boxes and squared distances stay finite
constexpr double largest_length = 1e30;
// Lengths of a ray's direction, so that neither it nor its inverse loses digits.
constexpr double shortest_direction = 1e-100;
constexpr double longest_direction = 1e100;
constexpr std::size_t fan_out = 4;  // children of a node, and triangles of a leaf
// Highest level from the leaves upwards that is too large for the nearest caches if there
// are a million triangles.
constexpr std::int32_t highest_cold_level = 3;
// Margin for the rounding of a ray with a far origin, as a share of the largest coordinate.
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
    return rounded <= value
               ? rounded
               : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
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

// The functions that only prefetch are inlined by force: GCC takes one for a function
// without effect, and removes calls to it.
[[gnu::always_inline]] inline void prefetch_lines(const FourEnclosures& node)
{
    static_assert(sizeof node == 3 * 64);
    const auto* line = reinterpret_cast<const char*>(&node);
    for (std::size_t k = 0; k < sizeof node; k += 64)
        __builtin_prefetch(line + k);
}

// Unit vector along `vector`; zero if it has no direction.
Eigen::Vector3f unit_or_zero(const Vec3& vector)
{
    const double length = vector.norm();
    if (!(length > 0 && length < infinity))
        return Eigen::Vector3f::Zero();
    return (vector / length).cast<float>();
}

// The least and the greatest of some numbers.
struct Extent {
    double low = infinity;
    double high = -infinity;

    void include(double number)
    {
        low = std::min(low, number);
        high = std::max(high, number);
    }
};

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

std::array<Vec3, 3> corners_of(const Triangle& triangle, std::span<const Vec3> points)
{
    return {points[triangle[0]], points[triangle[1]], points[triangle[2]]};
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
    double margin;      // mm, by which a box is larger
    std::int32_t hint;  // number of a triangle that has been looked at, or -1
    NearestPoint best{{}, infinity, 0};
    double least_square = infinity;  // mm^2

    double limit() const { return least_square; }

    std::array<double, 4> bounds(const FourEnclosures& children) const
    {
        return bound_squares(children, place, margin, least_square);
    }

    void look_at(const std::array<Vec3, 3>& corners, std::int32_t number)
    {
        const Vec3 point = nearest_on_triangle(place, corners);
        const double square = (point - place).squaredNorm();
        const auto triangle = static_cast<std::size_t>(number);
        if (square < least_square ||
            (square == least_square && triangle < best.triangle)) {
            least_square = square;
            best.point = point;
            best.triangle = triangle;
        }
    }

    // Bounds of all four triangles first: most triangles are beyond the limit, above all
    // if the triangle with the least bound has been looked at.
    void look_at(const TriangleMesh& mesh, const Leaf& leaf)
    {
        const std::array<double, 4> bounds =
            bound_squares(mesh.points(), leaf.corners, place, margin);
        const auto least = std::ranges::min_element(bounds) - bounds.begin();
        for (int i = 0; i < 4; ++i) {
            const auto k = (least + i) % 4;
            if (bounds[k] <= least_square && leaf.numbers[k] != hint)
                look_at(corners_of(leaf.corners[k], mesh.points()), leaf.numbers[k]);
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
    std::array<double, 4> bounds(const FourEnclosures& children) const
    {
        Eigen::Array4d enter = Eigen::Array4d::Zero();
        Eigen::Array4d leave = Eigen::Array4d::Constant(infinity);
        for (int axis = 0; axis < 3; ++axis) {
            const bool falls = is_falling[axis];
            const Eigen::Array4f& first =
                falls ? children.high[axis] : children.low[axis];
            const Eigen::Array4f& last = falls ? children.low[axis] : children.high[axis];
            const double outwards = falls ? -margin : margin;
            const double begin = ray.origin[axis] + outwards;
            const double end = ray.origin[axis] - outwards;
            enter = enter.max((first.cast<double>() - begin) * inverse[axis]);
            leave = leave.min((last.cast<double>() - end) * inverse[axis]);
        }
        std::array<double, 4> bounds;
        Eigen::Map<Eigen::Array4d>{bounds.data()} =
            (enter <= leave).select(enter, infinity);
        return bounds;
    }

    void look_at(const TriangleMesh& mesh, const Leaf& leaf)
    {
        for (int k = 0; k < 4; ++k)
            look_at(corners_of(leaf.corners[k], mesh.points()),
                    static_cast<std::size_t>(leaf.numbers[k]));
    }

    void look_at(const std::array<Vec3, 3>& corners, std::size_t number)
    {
        std::array<double, 3> x;
        std::array<double, 3> y;
        std::array<double, 3> t;
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

TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(const TriangleTree&) = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(const TriangleTree&) = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

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

// Fills leaves_.
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
    const std::size_t leaves = (centres.size() + fan_out - 1) / fan_out;
    reserve_in_large_pages(leaves_, leaves);
    leaves_.resize(leaves);
    for (std::size_t k = 0; k < leaves_.size() * fan_out; ++k) {
        const std::int32_t number = centres[std::min(k, centres.size() - 1)].triangle;
        Leaf& leaf = leaves_[k / fan_out];
        leaf.numbers[k % fan_out] = number;
        leaf.corners[k % fan_out] = mesh_->triangles()[number];
    }
}

// Fills levels_: first around the leaves, then level by level around the children below.
void TriangleTree::enclose()
{
    add_level(leaves_.size());
    for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf)
        enclose_leaf(leaf);
    while (levels_.back().size() > 1) {
        add_level(levels_.back().size());
        const std::vector<FourEnclosures>& below = levels_[levels_.size() - 2];
        for (std::size_t node = 0; node < below.size(); ++node)
            enclose_node(below[node], levels_.back()[node / fan_out],
                         place_in_node(node));
    }
}

// Adds a level of nodes above `count` children.
void TriangleTree::add_level(std::size_t count)
{
    levels_.emplace_back();
    const std::size_t nodes = (count + fan_out - 1) / fan_out;
    reserve_in_large_pages(levels_.back(), nodes);
    levels_.back().resize(nodes);
}

// The box and the slab of a leaf. The slab is normal to the sum of the triangles' areas.
void TriangleTree::enclose_leaf(std::size_t leaf)
{
    const double margin = box_margin_share * largest_coordinate_;
    Eigen::AlignedBox3d box;
    Vec3 sum = Vec3::Zero();
    for (const Triangle& triangle : leaves_[leaf].corners) {
        const auto [a, b, c] = corners_of(triangle, mesh_->points());
        sum += (b - a).cross(c - a);
        box.extend(a).extend(b).extend(c);
    }
    FourEnclosures& node = levels_[0][leaf / fan_out];
    const Eigen::Index part = place_in_node(leaf);
    for (int axis = 0; axis < 3; ++axis) {
        node.low[axis][part] = rounded_down(box.min()[axis] - margin);
        node.high[axis][part] = -rounded_down(-box.max()[axis] - margin);
    }
    const Eigen::Vector3f normal = unit_or_zero(sum);
    Extent along;
    for (const Triangle& triangle : leaves_[leaf].corners)
        for (const Vec3& corner : corners_of(triangle, mesh_->points()))
            along.include(normal.cast<double>().dot(corner));
    set_slab(node, part, normal, along.low, along.high);
}

// The box and the slab around the boxes and slabs of a node. The normal of the slab is a
// multiple of a child's normal and a rest. Along the former, the child's slab limits the
// child; along the rest, its box does.
void TriangleTree::enclose_node(const FourEnclosures& node, FourEnclosures& parent,
                                Eigen::Index part) const
{
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index k = 0; k < 4; ++k)
        sum += node.normal_of(k);
    for (int axis = 0; axis < 3; ++axis) {
        parent.low[axis][part] = node.low[axis].minCoeff();
        parent.high[axis][part] = node.high[axis].maxCoeff();
    }
    const Eigen::Vector3f normal = unit_or_zero(sum);
    Extent along;
    for (Eigen::Index k = 0; k < 4; ++k) {
        const Eigen::AlignedBox3d box = node.box_of(k);
        if (box.isEmpty())
            continue;
        const Vec3 own = node.normal_of(k);
        const double share = normal.cast<double>().dot(own);
        const Vec3 rest = normal.cast<double>() - share * own;
        const double middle = rest.dot(box.center());
        const double reach = rest.cwiseAbs().dot(box.sizes()) / 2;
        for (const float side : {node.slab_low[k], node.slab_high[k]}) {
            along.include(share * side + middle - reach);
            along.include(share * side + middle + reach);
        }
    }
    set_slab(parent, part, normal, along.low, along.high);
}

void TriangleTree::set_slab(FourEnclosures& node, Eigen::Index part,
                            const Eigen::Vector3f& normal, double low, double high) const
{
    const double margin = box_margin_share * largest_coordinate_;
    for (int axis = 0; axis < 3; ++axis)
        node.normal[axis][part] = normal[axis];
    node.slab_low[part] = rounded_down(low - margin);
    node.slab_high[part] = -rounded_down(-high - margin);
}

// Prefetches a node, and its leaves if it has leaves, or the points of a leaf if the level
// is -1. Searches at scattered places find few of them in the nearest caches.
[[gnu::always_inline]] inline void TriangleTree::prefetch(std::int32_t level,
                                                          std::size_t node) const
{
    if (level < 0) {
        for (const Triangle& triangle : leaves_[node].corners)
            for (const std::int32_t corner : triangle)
                __builtin_prefetch(&mesh_->points()[corner]);
        return;
    }
    prefetch_lines(levels_[level][node]);
    const std::size_t end = level == 0 ? (node + 1) * fan_out : 0;
    for (std::size_t leaf = node * fan_out; leaf < std::min(end, leaves_.size()); ++leaf)
        __builtin_prefetch(&leaves_[leaf]);
}

// Prefetches the nodes below the node that is searched next, so that they arrive while it
// is searched. The levels above `highest_cold_level` are in the nearest caches.
[[gnu::always_inline]] inline void TriangleTree::prefetch_below(std::int32_t level,
                                                                std::size_t node) const
{
    if (level < 1 || level > highest_cold_level)
        return;
    const std::vector<FourEnclosures>& below = levels_[level - 1];
    const std::size_t end = std::min((node + 1) * fan_out, below.size());
    for (std::size_t child = node * fan_out; child < end; ++child)
        prefetch_lines(below[child]);
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
            query.look_at(*mesh_, leaves_[next.node]);
            continue;
        }
        const std::size_t before = count;
        const std::array<double, 4> bounds = query.bounds(levels_[next.level][next.node]);
        for (std::uint32_t k = 0; k < fan_out; ++k) {
            if (!(bounds[k] <= query.limit() && bounds[k] < infinity))
                continue;
            std::size_t place = count++;
            for (; place > before && waiting[place - 1].bound < bounds[k]; --place)
                waiting[place] = waiting[place - 1];
            waiting[place] = {bounds[k], next.node * 4 + k, next.level - 1};
            prefetch(next.level - 1, waiting[place].node);
        }
        if (count > before)
            prefetch_below(next.level - 1, waiting[count - 1].node);
    }
}

std::optional<NearestPoint> TriangleTree::nearest(const Vec3& place,
                                                  std::optional<std::size_t> hint,
                                                  double within) const
{
    require(is_within_reach(place), "TriangleTree: a place must be within 1e30 mm");
    require(!hint || *hint < mesh_->triangles().size(),
            "TriangleTree: the hint is no triangle");
    if (leaves_.empty())
        return std::nullopt;
    NearestQuery query{place, box_margin_share * largest_coordinate_,
                       hint ? static_cast<std::int32_t>(*hint) : -1};
    query.least_square = within > 0 ? within * within : 0;
    const double asked = query.least_square;
    if (hint)
        query.look_at(mesh_->corners(*hint), query.hint);
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
    if (!leaves_.empty())
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
    if (!leaves_.empty())
        ask(asked);
    return asked.triangle.has_value();
}

}  // namespace endmill
