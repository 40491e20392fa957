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
// Distance from which slabs are worth a test, in diagonals of leaves. Nearer, boxes
// exclude nearly as many children.
constexpr double far_leaves = 8;
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

// A coordinate of four points.
using FourNumbers = Eigen::Array4d;

// Four points, by coordinate.
struct FourPoints {
    FourNumbers x;
    FourNumbers y;
    FourNumbers z;

    FourNumbers dot(const FourPoints& other) const
    {
        return x * other.x + y * other.y + z * other.z;
    }
};

// Corner `corner` of four triangles, seen from a place.
FourPoints four_corners(std::span<const Vec3> points, std::span<const Triangle, 4> four,
                        int corner, const Vec3& place)
{
    FourPoints result;
    for (int k = 0; k < 4; ++k) {
        const Vec3& point = points[four[k][corner]];
        result.x[k] = point.x() - place.x();
        result.y[k] = point.y() - place.y();
        result.z[k] = point.z() - place.z();
    }
    return result;
}

// Lower bounds of the squared distances, mm^2, from a place to four triangles; `margin`
// in mm is subtracted from each distance. A triangle is beyond the plane through its
// nearest corner that is normal to the line from the place to its centre. Seen from afar
// this plane is near the triangle, whereas a box is larger than a sloping triangle. The
// box is the better bound for a triangle that is large for its distance.
FourNumbers least_squares(std::span<const Vec3> points, std::span<const Triangle, 4> four,
                          const Vec3& place, double margin)
{
    const FourPoints a = four_corners(points, four, 0, place);
    const FourPoints b = four_corners(points, four, 1, place);
    const FourPoints c = four_corners(points, four, 2, place);
    const FourPoints centre{a.x + b.x + c.x, a.y + b.y + c.y, a.z + b.z + c.z};
    // the least normal number, so that the length is not 0
    constexpr double not_zero = std::numeric_limits<double>::min();
    const FourNumbers along = centre.dot(a).min(centre.dot(b)).min(centre.dot(c)).max(0);
    const FourNumbers to_plane = along * (along / (centre.dot(centre) + not_zero));
    // (d - margin)^2 is at least d^2 - 2 d margin, and 2 d is at most d^2 / r + r for
    // every r. Here r is many margins, so that the share of d^2 is small.
    constexpr double share = 1e-7;
    const double rest = margin / share * margin;
    const auto to_box = [margin](const FourNumbers& p, const FourNumbers& q,
                                 const FourNumbers& r) -> FourNumbers {
        const FourNumbers low = p.min(q).min(r);
        const FourNumbers high = p.max(q).max(r);
        return (low.max(-high) - margin).max(0).square();
    };
    return ((1 - share) * to_plane - rest)
        .max(to_box(a.x, b.x, c.x) + to_box(a.y, b.y, c.y) + to_box(a.z, b.z, c.z));
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

    // Whether a child is beyond the limit. It is beyond the plane through the nearest
    // point of its slab and box that is normal to the line from the place to its centre.
    // Along that line, the slab limits the share of its own normal, and the box the rest.
    bool is_beyond(const Boxes& boxes, const Slabs& slabs, std::size_t child) const
    {
        const Eigen::AlignedBox3d box = boxes.of(place_in_node(child));
        const Slab& slab = slabs[child];
        const Vec3 normal = slab.normal.cast<double>();
        const Vec3 centre = box.center() - place;
        const double share = normal.dot(centre);
        const Vec3 rest = centre - share * normal;
        const double height = normal.dot(place);
        const double to_slab =
            std::min(share * (slab.low - height), share * (slab.high - height));
        const double to_plane =
            to_slab + rest.dot(centre) - rest.cwiseAbs().dot(box.sizes()) / 2;
        const double length = centre.norm();
        const double least = to_plane - margin * length;
        return least > 0 &&
               (1 - question_margin) * least * least > least_square * length * length;
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

    // Bounds of all four triangles first: most triangles are beyond the limit.
    void look_at(const TriangleMesh& mesh, const Leaf& leaf)
    {
        const FourNumbers bounds =
            least_squares(mesh.points(), leaf.corners, place, margin);
        for (int k = 0; k < 4; ++k)
            if ((1 - question_margin) * bounds[k] <= least_square &&
                leaf.numbers[k] != hint)
                look_at(corners_of(leaf.corners[k], mesh.points()), leaf.numbers[k]);
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

    // Slabs do not make a ray's search faster.
    static bool is_beyond(const Boxes&, const Slabs&, std::size_t) { return false; }

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
    const double far = far_leaves * mean_leaf_diagonal();
    far_square_ = far * far;
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
    leaves_.resize((centres.size() + fan_out - 1) / fan_out);
    for (std::size_t k = 0; k < leaves_.size() * fan_out; ++k) {
        const std::int32_t number = centres[std::min(k, centres.size() - 1)].triangle;
        Leaf& leaf = leaves_[k / fan_out];
        leaf.numbers[k % fan_out] = number;
        leaf.corners[k % fan_out] = mesh_->triangles()[number];
    }
}

// Fills levels_ and slabs_: first around the leaves, then level by level around the
// children below.
void TriangleTree::enclose()
{
    const Eigen::Array4f none = Eigen::Array4f::Constant(no_box);
    const Boxes nothing{{none, none, none}, {-none, -none, -none}};
    const auto nodes_over = [](std::size_t count) {
        return (count + fan_out - 1) / fan_out;
    };
    levels_.emplace_back(nodes_over(leaves_.size()), nothing);
    slabs_.emplace_back(nodes_over(leaves_.size()));
    for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf)
        enclose_leaf(leaf);
    while (levels_.back().size() > 1) {
        const std::vector<Boxes>& below = levels_.back();
        std::vector<Boxes> level(nodes_over(below.size()), nothing);
        std::vector<Slabs> slabs(level.size());
        for (std::size_t k = 0; k < below.size(); ++k) {
            for (int axis = 0; axis < 3; ++axis) {
                level[k / fan_out].low[axis][place_in_node(k)] =
                    below[k].low[axis].minCoeff();
                level[k / fan_out].high[axis][place_in_node(k)] =
                    below[k].high[axis].maxCoeff();
            }
            slabs[k / fan_out][k % fan_out] = slab_around(below[k], slabs_.back()[k]);
        }
        levels_.push_back(std::move(level));
        slabs_.push_back(std::move(slabs));
    }
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
    Boxes& boxes = levels_[0][leaf / fan_out];
    for (int axis = 0; axis < 3; ++axis) {
        boxes.low[axis][place_in_node(leaf)] = rounded_down(box.min()[axis] - margin);
        boxes.high[axis][place_in_node(leaf)] = -rounded_down(-box.max()[axis] - margin);
    }
    const Eigen::Vector3f normal = unit_or_zero(sum);
    Extent along;
    for (const Triangle& triangle : leaves_[leaf].corners)
        for (const Vec3& corner : corners_of(triangle, mesh_->points()))
            along.include(normal.cast<double>().dot(corner));
    slabs_[0][leaf / fan_out][leaf % fan_out] = {normal, rounded_down(along.low - margin),
                                                 -rounded_down(-along.high - margin)};
}

Eigen::AlignedBox3d TriangleTree::Boxes::of(Eigen::Index child) const
{
    return {Vec3{low[0][child], low[1][child], low[2][child]},
            Vec3{high[0][child], high[1][child], high[2][child]}};
}

// The slab around the boxes and slabs of a node. The normal of the result is a multiple
// of a child's normal and a rest. Along the former, the child's slab limits the child;
// along the rest, its box does.
TriangleTree::Slab TriangleTree::slab_around(const Boxes& boxes, const Slabs& slabs) const
{
    const double margin = box_margin_share * largest_coordinate_;
    Vec3 sum = Vec3::Zero();
    for (const Slab& slab : slabs)
        sum += slab.normal.cast<double>();
    const Eigen::Vector3f normal = unit_or_zero(sum);
    Extent along;
    for (std::size_t k = 0; k < fan_out; ++k) {
        const Eigen::AlignedBox3d box = boxes.of(place_in_node(k));
        if (box.isEmpty())
            continue;
        const Vec3 child = slabs[k].normal.cast<double>();
        const double share = normal.cast<double>().dot(child);
        const Vec3 rest = normal.cast<double>() - share * child;
        const double middle = rest.dot(box.center());
        const double reach = rest.cwiseAbs().dot(box.sizes()) / 2;
        for (const double side : {slabs[k].low, slabs[k].high}) {
            along.include(share * side + middle - reach);
            along.include(share * side + middle + reach);
        }
    }
    return {normal, rounded_down(along.low - margin),
            -rounded_down(-along.high - margin)};
}

// In mm; 0 if there are no leaves.
double TriangleTree::mean_leaf_diagonal() const
{
    double sum = 0;
    for (std::size_t leaf = 0; leaf < leaves_.size(); ++leaf)
        sum += levels_[0][leaf / fan_out].of(place_in_node(leaf)).diagonal().norm();
    return leaves_.empty() ? 0 : sum / static_cast<double>(leaves_.size());
}

// Prefetches a node, and its leaves if it has leaves, or the points of a leaf if the level
// is -1. Searches at scattered places find few of them in the nearest caches.
void TriangleTree::prefetch(std::int32_t level, std::size_t node) const
{
    if (level < 0) {
        for (const Triangle& triangle : leaves_[node].corners)
            for (const std::int32_t corner : triangle)
                __builtin_prefetch(&mesh_->points()[corner]);
        return;
    }
    const Boxes& boxes = levels_[level][node];
    __builtin_prefetch(&boxes.low);
    __builtin_prefetch(&boxes.high[2]);
    const std::size_t end = level == 0 ? (node + 1) * fan_out : 0;
    for (std::size_t leaf = node * fan_out; leaf < std::min(end, leaves_.size()); ++leaf)
        __builtin_prefetch(&leaves_[leaf]);
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
        const std::size_t above = next.level + 1;  // the level of its parent
        const std::size_t parent = next.node / fan_out;
        if (next.bound > 0 && query.limit() > far_square_ &&
            query.is_beyond(levels_[above][parent], slabs_[above][parent],
                            next.node % fan_out))
            continue;
        if (next.level < 0) {
            query.look_at(*mesh_, leaves_[next.node]);
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
            prefetch(next.level - 1, waiting[place].node);
        }
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
