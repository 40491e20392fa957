// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/dexel_removal.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "endmill/core/parallel.h"
#include "endmill/stock/detail/ball_chords.h"
#include "endmill/stock/detail/ray_on_motion.h"

namespace endmill {
namespace {

constexpr int tile_side = 8;
// A chord on a ray is sharp enough if its certain and its possible ends differ by this, in
// mm, at both ends together; otherwise the piece is halved.
constexpr double chord_sharpness = 2e-3;
constexpr int most_halvings = 6;
// A piece is not halved if its error is below this, in mm: the ray then grazes the cutter.
constexpr double small_error = 1e-5;
// Accuracy of the distance at the ends of a chord, in mm; about a unit.
constexpr double chord_accuracy = 1e-6;

// An interval on a ray, in units.
using Interval32 = DexelInterval;

// What a piece removes on a ray: at most `may`, and all of `sure`.
struct Chord {
    Interval32 may;
    Interval32 sure;  // empty if from >= to
};

// Removes an interval from a set. \return the length that was removed, in units.
std::int64_t remove(std::vector<Interval32>& set, const Interval32& cut)
{
    std::int64_t removed = 0;
    for (std::size_t k = 0; k < set.size();) {
        Interval32& one = set[k];
        const Interval32 both{std::max(one.from, cut.from), std::min(one.to, cut.to)};
        if (both.from >= both.to) {
            ++k;
            continue;
        }
        removed += std::int64_t{both.to} - both.from;
        const Interval32 above{both.to, one.to};
        one.to = both.from;
        if (one.from < one.to) {
            ++k;
            if (above.from < above.to)
                set.insert(set.begin() + static_cast<std::ptrdiff_t>(k), above);
        } else if (above.from < above.to) {
            one = above;
        } else {
            set.erase(set.begin() + static_cast<std::ptrdiff_t>(k));
        }
    }
    return removed;
}

// Returns the length of a set within an interval, in units.
std::int64_t length_within(const std::vector<Interval32>& set, const Interval32& within)
{
    std::int64_t sum = 0;
    for (const Interval32& one : set)
        sum += std::max(std::int64_t{0}, std::int64_t{std::min(one.to, within.to)} -
                                             std::max(one.from, within.from));
    return sum;
}

// A range of places on a ray, mm.
struct Range {
    double from;
    double to;
};

// Bounds of what a motion removes on a ray, mm.
struct Removed {
    Range may;
    std::optional<Range> sure;
};

// A ray in both directions.
struct TwoWays {
    const RayOnMotion& on;
    RayOnMotion back;
};

// Returns the part that is removed for certain, between places that are. The pose that
// removes one end removes all up to any place that it removes too, because it is convex.
// If that fails, F itself is convex along the ray except for the turn of its direction.
// \param first, last the first places that may be removed, in both directions.
std::optional<Range> sure_range(const TwoWays& ways, const RayOnMotion::Place& first,
                                const RayOnMotion::Place& last)
{
    const auto from = ways.on.sure_entry(first, -last.s);
    if (!from)
        return std::nullopt;
    const auto back = ways.back.sure_entry(last, -from->s);
    if (!back)
        return std::nullopt;
    const RayOnMotion& on = ways.on;
    const RayOnMotion::Distance& at_from = from->distance;
    const RayOnMotion::Distance& at_to = back->distance;
    const Range sure{from->s, -back->s};
    // Along the ray both the distance from one pose and the error are convex.
    if (at_from.least.at == at_to.least.at)
        return sure;
    const double middle = (sure.from + sure.to) / 2;
    const double error = std::max(at_from.error, at_to.error);
    const bool is_whole = on.at_pose(middle, at_from.least.at) <= -error &&
                          on.at_pose(middle, at_to.least.at) <= -error;
    if (is_whole)
        return sure;
    const double bend = on.turn() * (sure.to - sure.from) *
                        std::abs(at_from.least.at - at_to.least.at) / 4;
    // Both ends are drawn in where the distance falls enough.
    const Range inner{sure.from + 2 * bend, sure.to - 2 * bend};
    if (!(inner.from <= inner.to))
        return std::nullopt;
    const auto is_deep = [&](double s) {
        return on.distance(s).least.value <= -(error + bend);
    };
    return bend == 0 || (is_deep(inner.from) && is_deep(inner.to)) ? std::optional{inner}
                                                                   : std::nullopt;
}

// Returns what a motion removes on a range of a ray; nothing if it removes nothing.
std::optional<Removed> removed_on(const RayOnMotion& on, const Range& range)
{
    const TwoWays ways{on, on.reversed()};
    const auto last = ways.back.first_entry(-range.to, -range.from);
    if (!last)
        return std::nullopt;
    const auto first = on.first_entry(range.from, -last->s);
    if (!first)
        return std::nullopt;
    return Removed{{first->s, -last->s}, sure_range(ways, *first, *last)};
}

// The rays of a tile while the pieces cut them.
class DexelTile {
public:
    DexelTile(const DexelStock& stock, int axis, int column, int row)
        : field_{stock.field(axis)},
          unit_{stock.unit()},
          direction_{Vec3::Unit(axis)},
          columns_{std::min(tile_side, field_.columns() - column)},
          rows_{std::min(tile_side, field_.rows() - row)},
          length_{stock.block().high[axis] - stock.block().low[axis]}
    {
        for (int j = 0; j < rows_; ++j)
            for (int i = 0; i < columns_; ++i) {
                const auto upper = field_.upper(column + i, row + j);
                const auto lower = field_.lower(column + i, row + j);
                dexels_.push_back(
                    {{upper.begin(), upper.end()}, {lower.begin(), lower.end()}});
                starts_.push_back(field_.start(column + i, row + j));
            }
        middle_ = (starts_.front() + starts_.back()) / 2;
        radius_ = (starts_.front() - middle_).norm();
    }

    const Vec3& middle() const { return middle_; }
    double radius() const { return radius_; }
    Vec3 end(const Vec3& start) const { return start + length_ * direction_; }
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    std::vector<Dexel>& dexels() { return dexels_; }

    // Calls `use(ray, chord)` for all chords of a piece with the material of the rays.
    template <typename Use>
    void for_chords(const ToolPiece& piece, const Use& use)
    {
        const Range material = material_range();
        if (!(material.from < material.to))
            return;
        const RayOnMotion middle{middle_, direction_, piece.motion, piece.body};
        const auto near = middle.near_stretch(material.from, material.to, radius_);
        if (!near)
            return;
        const double error = middle.largest_error(*near, radius_);
        const NearTile tile{piece,
                            middle,
                            {near->from, near->to},
                            error,
                            middle.spread(*near, error, radius_)};
        const bool is_ball = piece.body.cutter().is_ball();
        if (is_ball && std::isinf(piece.body.length()))
            add_chords_of_ball(tile);
        else
            add_all_chords(tile);
        if (chords_.empty())
            return;
        for (const auto& [ray, chord] : chords_)
            use(ray, chord);
        chords_.clear();
        material_.reset();
    }

private:
    Vec3 at(std::size_t ray, double s) const { return starts_[ray] + s * direction_; }

    // From the lowest to the highest material of all rays.
    Range material_range()
    {
        if (!material_) {
            material_ = Range{length_, 0};
            for (const Dexel& dexel : dexels_)
                if (!dexel.upper.empty())
                    material_ =
                        Range{std::min(material_->from, dexel.upper.front().from * unit_),
                              std::max(material_->to, dexel.upper.back().to * unit_)};
        }
        return *material_;
    }

    // A piece that comes near the rays.
    struct NearTile {
        const ToolPiece& piece;
        const RayOnMotion& middle;  // the line in the middle of the rays
        Range near;                 // on all rays nothing is removed outside
        double error;               // mm, largest one on all of them
        double within;              // mm, as CuttingBody::near_stretch needs it
    };

    bool has_material(std::size_t ray, const Range& within) const
    {
        const std::vector<Interval32>& upper = dexels_[ray].upper;
        return !upper.empty() && upper.front().from * unit_ <= within.to &&
               upper.back().to * unit_ >= within.from;
    }

    // An interval of material on a ray, and the part of it that a piece may reach.
    struct NearMaterial {
        std::size_t ray;
        const ToolPiece* piece;
        Range range;
        Range search;
    };

    // Calls `use` for all intervals of material of a ray within a stretch.
    template <typename Use>
    void for_near_material(std::size_t ray, const NearTile& tile, const Range& stretch,
                           const Use& use) const
    {
        const Range within{std::max(tile.near.from, stretch.from),
                           std::min(tile.near.to, stretch.to)};
        for (const Interval32& one : dexels_[ray].upper) {
            const Range range{one.from * unit_, one.to * unit_};
            const Range search{std::max(range.from, within.from),
                               std::min(range.to, within.to)};
            if (search.from <= search.to)
                use(NearMaterial{ray, &tile.piece, range, search});
        }
    }

    // Adds the chords of a piece with all rays.
    void add_all_chords(const NearTile& tile)
    {
        const ToolPiece& piece = tile.piece;
        const Vec3 along = tile.middle.middle_direction();
        const Eigen::Matrix3d to_start = piece.motion.from().axes.transpose();
        const Eigen::Matrix3d to_end = piece.motion.to().axes.transpose();
        for (std::size_t ray = 0; ray < dexels_.size(); ++ray) {
            if (!has_material(ray, tile.near))
                continue;
            const Vec3 movement = starts_[ray] - middle_;
            RayOnMotion on =
                tile.middle.moved(movement, to_start * movement, to_end * movement);
            const auto reached =
                piece.body.near_stretch(on.middle_start(), along, tile.within);
            if (!reached)
                continue;
            on.set_error(tile.error, chord_accuracy);
            for_near_material(
                ray, tile, {reached->from, reached->to},
                [&](const NearMaterial& material) {
                    if (const auto removed = removed_on(on, material.search))
                        add_chord(material, piece.motion, *removed, most_halvings);
                });
        }
    }

    // Rays whose chords are computed together.
    struct Lanes {
        EightRays rays{};
        EightStretches search{};
        std::array<NearMaterial, 8> material{};
        std::size_t count = 0;

        // \param lane of `from` that has the ray.
        void put(const NearMaterial& one, const EightRays& from, std::size_t lane)
        {
            for (std::size_t c = 0; c < 3; ++c) {
                rays.from[c][count] = from.from[c][lane];
                rays.to[c][count] = from.to[c][lane];
            }
            search.from[count] = one.search.from;
            search.to[count] = one.search.to;
            material[count++] = one;
        }
    };

    // Numbers of up to eight rays.
    struct RayNumbers {
        std::array<std::size_t, 8> of{};
        std::size_t count = 0;
    };

    // The next rays with material, from `first` on, which becomes the one behind them.
    RayNumbers next_rays(std::size_t& first, const Range& within) const
    {
        RayNumbers numbers;
        for (; first < dexels_.size() && numbers.count < numbers.of.size(); ++first)
            if (has_material(first, within))
                numbers.of[numbers.count++] = first;
        return numbers;
    }

    // The rays as seen from the tool; the last one is repeated.
    EightRays seen_rays(const RayNumbers& numbers, const BallOnRays& ball) const
    {
        EightPlaces movements;
        for (std::size_t k = 0; k < numbers.of.size(); ++k) {
            const Vec3 movement =
                starts_[numbers.of[std::min(k, numbers.count - 1)]] - middle_;
            for (std::size_t c = 0; c < 3; ++c)
                movements[c][k] = movement[static_cast<Eigen::Index>(c)];
        }
        return moved_rays(ball, movements);
    }

    // The same for an endless ball.
    void add_chords_of_ball(const NearTile& tile)
    {
        const BallOnRays ball{middle_, direction_, tile.piece.motion,
                              tile.piece.body.cutter().radius()};
        Lanes lanes;
        std::size_t first = 0;
        for (RayNumbers numbers = next_rays(first, tile.near); numbers.count > 0;
             numbers = next_rays(first, tile.near)) {
            const EightRays rays = seen_rays(numbers, ball);
            const EightStretches near = near_stretches(ball, rays, tile.within);
            for (std::size_t k = 0; k < numbers.count; ++k)
                for_near_material(numbers.of[k], tile, {near.from[k], near.to[k]},
                                  [&](const NearMaterial& material) {
                                      lanes.put(material, rays, k);
                                      if (lanes.count == lanes.material.size())
                                          add_chords(lanes, ball, tile);
                                  });
        }
        if (lanes.count > 0)
            add_chords(lanes, ball, tile);
    }

    // Adds the chords of the rays in the lanes, and clears them.
    void add_chords(Lanes& lanes, const BallOnRays& ball, const NearTile& tile)
    {
        const std::size_t count = std::exchange(lanes.count, 0);
        for (std::size_t k = count; k < lanes.material.size(); ++k) {
            lanes.count = k;
            lanes.put(lanes.material[count - 1], lanes.rays, count - 1);
        }
        lanes.count = 0;
        const EightChords chords =
            ball_chords(ball, lanes.rays, lanes.search, tile.error, chord_accuracy);
        for (std::size_t k = 0; k < count; ++k) {
            if (!(chords.may.from[k] <= chords.may.to[k]))
                continue;
            const NearMaterial& material = lanes.material[k];
            Removed removed{{chords.may.from[k], chords.may.to[k]}, {}};
            const bool has_sure = chords.sure.from[k] <= chords.sure.to[k];
            if (has_sure && chords.is_whole[k] > 0)
                removed.sure = Range{chords.sure.from[k], chords.sure.to[k]};
            else if (has_sure)
                removed = by_one_ray(material, tile.error).value_or(removed);
            add_chord(material, tile.piece.motion, removed, most_halvings);
        }
    }

    std::optional<Removed> by_one_ray(const NearMaterial& material, double error) const
    {
        RayOnMotion on{starts_[material.ray], direction_, material.piece->motion,
                       material.piece->body};
        on.set_error(error, chord_accuracy);
        return removed_on(on, material.search);
    }

    // \param may outside which the whole motion removes nothing.
    void add_halves(const NearMaterial& material, const ToolMotion& motion,
                    const Range& may, int halvings)
    {
        for (const ToolMotion& half : motion.halves()) {
            RayOnMotion on{starts_[material.ray], direction_, half, material.piece->body};
            const auto near = on.near_stretch(may.from, may.to);
            if (!near)
                continue;
            on.set_error(on.largest_error(*near, 0), chord_accuracy);
            if (const auto removed = removed_on(on, {near->from, near->to}))
                add_chord(material, half, *removed, halvings);
        }
    }

    // Adds what a motion of the piece removes; if its ends are in doubt, what the halves of
    // the motion remove.
    void add_chord(const NearMaterial& material, const ToolMotion& motion,
                   const Removed& removed, int halvings)
    {
        const auto& [may, sure] = removed;
        const double doubt =
            sure ? sure->from - may.from + may.to - sure->to : may.to - may.from;
        if (doubt > chord_sharpness && halvings > 0 &&
            std::max(motion.chord_error(at(material.ray, may.from)),
                     motion.chord_error(at(material.ray, may.to))) > small_error) {
            add_halves(material, motion, may, halvings - 1);
            return;
        }
        chords_.emplace_back(material.ray, rounded(removed, material.range));
    }

    // Returns a chord whose ends are rounded outwards to whole units.
    Chord rounded(const Removed& removed, const Range& range) const
    {
        const auto& [may, sure] = removed;
        // units are powers of two, so that quotients are exact
        const auto down = [&](double s) {
            const auto whole = static_cast<std::int32_t>(s / unit_);
            return whole * unit_ > s ? whole - 1 : whole;
        };
        const auto up = [&](double s) { return -down(-s); };
        Chord chord{{down(may.from), up(may.to)}, {0, 0}};
        if (sure)
            chord.sure = {up(sure->from), down(sure->to)};
        // The ends of the range itself are whole units.
        if (may.to >= range.to)
            chord.may.to = up(range.to - unit_ / 2);
        if (sure && sure->to >= range.to)
            chord.sure.to = chord.may.to;
        if (sure && sure->from <= range.from)
            chord.sure.from = down(range.from + unit_ / 2);
        return chord;
    }

    const DexelField& field_;
    double unit_;
    Vec3 direction_;
    int columns_;
    int rows_;
    double length_;
    std::vector<Dexel> dexels_;
    std::vector<Vec3> starts_;
    std::vector<std::pair<std::size_t, Chord>> chords_;  // with the numbers of their rays
    Vec3 middle_;
    double radius_;
    std::optional<Range> material_ = {};  // of all rays, if it is known
};

// What the moves do on the rays of one field, in units.
struct FieldMove {
    std::int64_t removed = 0;  // of the upper and of the lower set together
    std::int64_t deepest = 0;
    std::int64_t most_deep = 0;
    std::int64_t body = 0;
    std::int64_t most_body = 0;

    void add(const FieldMove& other)
    {
        removed += other.removed;
        deepest = std::max(deepest, other.deepest);
        most_deep = std::max(most_deep, other.most_deep);
        body = std::max(body, other.body);
        most_body = std::max(most_body, other.most_body);
    }
};

// A piece of a cutter or a body that comes near a tile.
struct NearPiece {
    std::int32_t order;
    bool is_cutter;  // bodies come first
    std::uint32_t number;

    auto key() const { return std::tuple{order, is_cutter, number}; }
};

std::vector<NearPiece> pieces_near(const DexelTile& tile, const DexelMotions& motions)
{
    std::vector<NearPiece> near;
    const auto add = [&](const ToolPieces& pieces, bool is_cutter) {
        for (const std::uint32_t number :
             pieces.near_segment(tile.middle(), tile.end(tile.middle()), tile.radius()))
            near.push_back({pieces.pieces()[number].order, is_cutter, number});
    };
    add(motions.bodies, false);
    add(motions.cutters, true);
    std::ranges::sort(near, {}, &NearPiece::key);
    return near;
}

// Cuts the rays of one tile by all pieces.
// \param moves receives what they do, by the number of the point.
void cut_tile(DexelTile& tile, const DexelMotions& motions, std::vector<FieldMove>& moves)
{
    for (const auto& [order, is_cutter, number] : pieces_near(tile, motions)) {
        if (!is_cutter) {
            FieldMove& move =
                moves[static_cast<std::size_t>(motions.bodies.pieces()[number].point)];
            tile.for_chords(motions.bodies.pieces()[number],
                            [&](std::size_t ray, const Chord& chord) {
                                const Dexel& dexel = tile.dexels()[ray];
                                move.add({0, 0, 0, length_within(dexel.lower, chord.sure),
                                          length_within(dexel.upper, chord.may)});
                            });
            continue;
        }
        FieldMove& move =
            moves[static_cast<std::size_t>(motions.cutters.pieces()[number].point)];
        tile.for_chords(motions.cutters.pieces()[number],
                        [&](std::size_t ray, const Chord& chord) {
                            Dexel& dexel = tile.dexels()[ray];
                            FieldMove done;
                            done.deepest = length_within(dexel.lower, chord.sure);
                            done.most_deep = length_within(dexel.upper, chord.may);
                            done.removed = remove(dexel.lower, chord.may);
                            done.removed += remove(dexel.upper, chord.sure);
                            move.add(done);
                        });
    }
}

// Removes the material on the rays of one field.
std::vector<FieldMove> cut_field(DexelStock& stock, int axis, const DexelMotions& motions,
                                 const std::function<void(double)>& progress)
{
    DexelField& field = stock.field(axis);
    const int across = (field.columns() + tile_side - 1) / tile_side;
    const int along = (field.rows() + tile_side - 1) / tile_side;
    const std::size_t tiles = static_cast<std::size_t>(across) * along;
    std::vector<Dexel> dexels(static_cast<std::size_t>(field.columns()) * field.rows());
    std::vector<FieldMove> moves(motions.points);
    std::mutex adding;
    std::atomic<std::size_t> done = 0;
    parallel_for(tiles, [&](std::size_t begin, std::size_t end) {
        std::vector<FieldMove> own(motions.points);
        for (std::size_t k = begin; k < end; ++k) {
            const int column = static_cast<int>(k % across) * tile_side;
            const int row = static_cast<int>(k / across) * tile_side;
            DexelTile tile{stock, axis, column, row};
            cut_tile(tile, motions, own);
            for (int j = 0; j < tile.rows(); ++j)
                for (int i = 0; i < tile.columns(); ++i)
                    dexels[static_cast<std::size_t>(row + j) * field.columns() + column +
                           i] =
                        std::move(
                            tile.dexels()[static_cast<std::size_t>(j) * tile.columns() +
                                          i]);
            const std::size_t finished = ++done;
            if (progress)
                progress(
                    (axis + static_cast<double>(finished) / static_cast<double>(tiles)) /
                    3);
        }
        const std::scoped_lock lock{adding};
        for (std::size_t k = 0; k < moves.size(); ++k)
            moves[k].add(own[k]);
    });
    field.assign(dexels);
    return moves;
}

}  // namespace

DexelRemoval remove_from_dexels(DexelStock& stock, const DexelMotions& motions,
                                const std::function<void(double)>& progress)
{
    DexelRemoval removal;
    removal.moves.resize(motions.points);
    std::array<double, 3> removed{};
    for (int axis = 0; axis < 3; ++axis) {
        const DexelVolume before = dexel_volume(stock, axis);
        const std::vector<FieldMove> moves = cut_field(stock, axis, motions, progress);
        const double unit = stock.unit();
        const double volume = unit * stock.field(axis).cell_area();
        for (std::size_t k = 0; k < moves.size(); ++k) {
            DexelMove& move = removal.moves[k];
            move.removed += static_cast<double>(moves[k].removed) * volume / 6;
            move.deepest =
                std::max(move.deepest, static_cast<double>(moves[k].deepest) * unit);
            move.most_deep =
                std::max(move.most_deep, static_cast<double>(moves[k].most_deep) * unit);
            move.body_depth =
                std::max(move.body_depth, static_cast<double>(moves[k].body) * unit);
            move.most_body_depth = std::max(
                move.most_body_depth, static_cast<double>(moves[k].most_body) * unit);
        }
        const DexelVolume after = dexel_volume(stock, axis);
        const double most = before.upper - after.lower;
        const double least = before.lower - after.upper;
        removed[std::size_t(axis)] = (most + least) / 2;
        removal.removed += (most + least) / 6;
        removal.bound += (most - least) / 6;
    }
    removal.spread =
        *std::ranges::max_element(removed) - *std::ranges::min_element(removed);
    return removal;
}

}  // namespace endmill
