// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/drop_cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/drop_cutter/detail/ball_clearance.h"
#include "endmill/drop_cutter/detail/concave_bound.h"
#include "endmill/drop_cutter/detail/drop_tree.h"
#include "endmill/drop_cutter/detail/hilbert_curve.h"
#include "endmill/drop_cutter/detail/reached_share.h"
#include "endmill/drop_cutter/detail/triangle_drop.h"

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr std::size_t places_in_a_chunk = 256;
// the relative error of eight roundings of floats
constexpr double float_share = 0x1p-21;

// The search for the highest contact over one position.
class DropQuery {
public:
    DropQuery(const DropTree& tree, const TriangleDrop& drop, const Vec2& place,
              std::optional<std::size_t> hint)
        : tree_{tree},
          drop_{drop},
          place_{place},
          x_{static_cast<float>(place.x() - tree.origin().x())},
          y_{static_cast<float>(place.y() - tree.origin().y())}
    {
        if (hint)
            lower_onto(*hint);
        first_ = triangle_;
    }

    float limit() const { return limit_; }

    FloatLanes bounds(const DropTree::Nodes& nodes, const FloatLanes& tops) const
    {
        return tree_.tip_bounds(nodes, tops, x_, y_);
    }

    // The search visits the hint again; it is skipped.
    void look_at(std::size_t triangle)
    {
        if (triangle != first_)
            lower_onto(triangle);
    }

    std::optional<DropContact> contact() const
    {
        if (triangle_ == none)
            return std::nullopt;
        return DropContact{best_.tip_z, best_.point, triangle_};
    }

private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    void lower_onto(std::size_t triangle)
    {
        const TriangleContact found =
            drop_(tree_.mesh().corners(triangle), place_.x(), place_.y(), best_.tip_z);
        const bool is_equal = triangle_ != none && found.tip_z == best_.tip_z;
        if (!(found.tip_z > best_.tip_z || (is_equal && triangle < triangle_)))
            return;
        best_ = found;
        triangle_ = triangle;
        limit_ = rounded_down(found.tip_z - tree_.origin().z());
    }

    const DropTree& tree_;
    const TriangleDrop& drop_;
    const Vec2& place_;
    float x_;
    float y_;
    float limit_ = std::numeric_limits<float>::lowest();
    TriangleContact best_;
    std::size_t triangle_ = none;
    std::size_t first_;  // the triangle of the hint, or none
};

// The search for a triangle that rises above the tip of a moving cutter by more than a
// tolerance. It stops at the first one.
class ClearQuery {
public:
    ClearQuery(const DropTree& tree, const Vec3& from, const Vec3& to, double tolerance)
        : tree_{tree},
          drop_{tree.cutter()},
          from_{from},
          to_{to},
          tolerance_{tolerance},
          to_centre_{(tree.cutter().radius() + tolerance) * Vec3::UnitZ()}
    {
        const Vec3 a = from - tree.origin();
        const Vec3 b = to - tree.origin();
        const auto lowered = [](double z) {
            return rounded_down(z - float_share * std::abs(z));
        };
        move_ = {a.head<2>().cast<float>(), b.head<2>().cast<float>(), lowered(a.z()),
                 lowered(b.z())};
    }

    bool is_clear() const { return is_clear_; }

    float limit() const
    {
        return is_clear_ ? rounded_down(tolerance_)
                         : std::numeric_limits<float>::infinity();
    }

    FloatLanes bounds(const DropTree::Nodes& nodes, const FloatLanes& tops) const
    {
        return tree_.rise_bounds(nodes, tops, move_);
    }

    // Along the move, the height of the tip on one triangle minus that of the move is a
    // concave function where the cutter reaches the triangle, so that stays_below can bound it
    // from few values there.
    void look_at(std::size_t triangle)
    {
        const auto corners = tree_.mesh().corners(triangle);
        if (tree_.cutter().is_ball() &&
            is_ball_proved_clear(corners, from_ + to_centre_, to_ + to_centre_,
                                 tree_.cutter().radius()))
            return;
        const auto reached = reached_share(corners, from_.head<2>(), to_.head<2>(),
                                           tree_.cutter().radius());
        if (!reached)
            return;
        const double length = reached->second - reached->first;
        is_clear_ = stays_below(
            [&](double share) {
                const Vec3 tip =
                    from_ + (reached->first + share * length) * (to_ - from_);
                return drop_(corners, tip.x(), tip.y()).tip_z - tip.z();
            },
            tolerance_);
    }

private:
    const DropTree& tree_;
    TriangleDrop drop_;
    const Vec3& from_;
    const Vec3& to_;
    double tolerance_;
    Vec3 to_centre_;  // of a ball, lifted by the tolerance
    DropTree::FloatMove move_;
    bool is_clear_ = true;
};

bool is_beneath(const DropTree& tree, const Vec2& place)
{
    const Vec2 gap = (place - tree.origin().head<2>()).cwiseAbs() - tree.half_size();
    return gap.maxCoeff() <= 2 * tree.cutter().radius();
}

ENDMILL_WIDEST_REGISTERS
std::optional<DropContact> contact_at(const DropTree& tree, const TriangleDrop& drop,
                                      const Vec2& place, std::optional<std::size_t> hint)
{
    if (!is_beneath(tree, place))
        return std::nullopt;
    DropQuery query{tree, drop, place, hint};
    tree.search(query);
    return query.contact();
}

// The order in which the positions are processed. It is the given order if they follow a
// path. If they jump, they are sorted along the Hilbert curve, so that the contact of one
// is a good hint for the next.
std::vector<std::uint32_t> convenient_order(const DropTree& tree,
                                            std::span<const Vec2> places)
{
    std::vector<std::uint32_t> order(places.size());
    std::iota(order.begin(), order.end(), 0U);
    double travel = 0;
    for (std::size_t k = 1; k < places.size(); ++k)
        travel += std::min((places[k] - places[k - 1]).lpNorm<Eigen::Infinity>(),
                           4 * tree.cutter().radius());
    if (travel <= tree.cutter().radius() * static_cast<double>(places.size()))
        return order;
    const double size = std::max(tree.half_size().maxCoeff(), tree.cutter().radius());
    const Vec2 corner = tree.origin().head<2>() - Vec2::Constant(size);
    const auto cell = [&](double at) {
        return static_cast<std::uint32_t>(std::clamp(at / size * 32767.5, 0.0, 65535.0));
    };
    std::vector<std::uint32_t> keys(places.size());
    for (std::size_t k = 0; k < places.size(); ++k)
        keys[k] = hilbert_number(cell(places[k].x() - corner.x()),
                                 cell(places[k].y() - corner.y()));
    std::ranges::stable_sort(order, {}, [&](std::uint32_t k) { return keys[k]; });
    return order;
}

// Calls keep(number, contact) for all positions, on all threads. Within a chunk the last
// contact is the hint for the next position.
template <typename Keep>
void lower_all(const DropTree& tree, std::span<const Vec2> places, const Keep& keep)
{
    for (const Vec2& place : places)
        require(place.allFinite(), "DropCutter: a place is not finite");
    const std::vector<std::uint32_t> order = convenient_order(tree, places);
    const std::size_t chunks =
        (places.size() + places_in_a_chunk - 1) / places_in_a_chunk;
    parallel_for(chunks, [&](std::size_t begin, std::size_t end) {
        const TriangleDrop drop{tree.cutter()};
        const std::size_t last = std::min(end * places_in_a_chunk, places.size());
        std::optional<std::size_t> hint;
        for (std::size_t k = begin * places_in_a_chunk; k < last; ++k) {
            const auto found = contact_at(tree, drop, places[order[k]], hint);
            if (found)
                hint = found->triangle;
            keep(order[k], found);
        }
    });
}

}  // namespace

DropCutter::DropCutter(const TriangleMesh& mesh, const Cutter& cutter)
    : tree_{std::make_shared<const DropTree>(mesh, cutter)}
{
}

const Cutter& DropCutter::cutter() const
{
    return tree_->cutter();
}

const TriangleMesh& DropCutter::mesh() const
{
    return tree_->mesh();
}

std::optional<DropContact> DropCutter::contact(const Vec2& place,
                                               std::optional<std::size_t> hint) const
{
    require(place.allFinite(), "DropCutter: a place is not finite");
    require(!hint || *hint < mesh().triangles().size(),
            "DropCutter: the hint is no triangle");
    return contact_at(*tree_, TriangleDrop{cutter()}, place, hint);
}

std::vector<std::optional<DropContact>> DropCutter::contacts(
    std::span<const Vec2> places) const
{
    std::vector<std::optional<DropContact>> found(places.size());
    lower_all(*tree_, places,
              [&](std::size_t k, const auto& contact) { found[k] = contact; });
    return found;
}

std::vector<double> DropCutter::tip_heights(std::span<const Vec2> places) const
{
    std::vector<double> heights(places.size(), -std::numeric_limits<double>::infinity());
    lower_all(*tree_, places, [&](std::size_t k, const auto& contact) {
        if (contact)
            heights[k] = contact->tip_z;
    });
    return heights;
}

bool DropCutter::is_clear(const Vec3& from, const Vec3& to, double tolerance) const
{
    require(from.allFinite() && to.allFinite(), "DropCutter: a move is not finite");
    require(tolerance > 0, "DropCutter: need 0 < tolerance");
    require(mesh().triangles().empty() ||
                (is_beneath(*tree_, from.head<2>()) && is_beneath(*tree_, to.head<2>())),
            "DropCutter: a move must stay within 2 R of the mesh's box in plan");
    ClearQuery query{*tree_, from, to, tolerance};
    tree_->search(query);
    return query.is_clear();
}

}  // namespace endmill
