// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/piece_chords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "endmill/stock/detail/ball_chords.h"
#include "endmill/stock/detail/ray_on_motion.h"

namespace endmill {
namespace {

// A chord on a ray is sharp enough if its certain and its possible ends differ by this, in
// mm, at both ends together; otherwise the piece is halved.
constexpr double chord_sharpness = 2e-3;
constexpr int most_halvings = 6;
// A piece is not halved if its error is below this, in mm: the ray then grazes the cutter.
constexpr double small_error = 1e-5;
// Accuracy of the distance at the ends of a chord, in mm; about a unit.
constexpr double chord_accuracy = 1e-6;

using Range = RayStretch;

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

// The search for the chords of pieces with the rays.
class ChordSearch {
public:
    ChordSearch(const DexelRays& rays, std::vector<RayChord>& chords)
        : rays_{rays},
          chords_{chords}
    {
    }

    // Adds the chords with all rays.
    // \param material stretch that contains all material.
    void add(const ToolPiece& piece, const Range& material)
    {
        const RayOnMotion middle{rays_.middle, rays_.direction, piece.motion, piece.body};
        const auto near = middle.near_stretch(material.from, material.to, rays_.radius);
        if (!near)
            return;
        const double error = middle.largest_error(*near, rays_.radius);
        const NearTile tile{piece,
                            middle,
                            {near->from, near->to},
                            error,
                            middle.spread(*near, error, rays_.radius)};
        const bool is_ball = piece.body.cutter().is_ball();
        if (is_ball && std::isinf(piece.body.length()))
            add_chords_of_ball(tile);
        else
            add_all_chords(tile);
    }

    // Adds the chords with the material of one ray.
    void add_on_ray(const ToolPiece& piece, std::size_t ray)
    {
        for (const DexelInterval& one : rays_.dexels[ray].upper) {
            const Range range{one.from * rays_.unit, one.to * rays_.unit};
            const RayOnMotion on{rays_.starts[ray], rays_.direction, piece.motion,
                                 piece.body};
            const double error = on.largest_error({range.from, range.to}, 0);
            const NearMaterial material{ray, &piece, range, range};
            if (const auto removed = by_one_ray(material, error))
                add_chord(material, piece.motion, *removed, most_halvings);
        }
    }

private:
    Vec3 at(std::size_t ray, double s) const
    {
        return rays_.starts[ray] + s * rays_.direction;
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
        const std::vector<DexelInterval>& upper = rays_.dexels[ray].upper;
        return !upper.empty() && upper.front().from * rays_.unit <= within.to &&
               upper.back().to * rays_.unit >= within.from;
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
        for (const DexelInterval& one : rays_.dexels[ray].upper) {
            const Range range{one.from * rays_.unit, one.to * rays_.unit};
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
        for (std::size_t ray = 0; ray < rays_.dexels.size(); ++ray) {
            if (!has_material(ray, tile.near))
                continue;
            const Vec3 movement = rays_.starts[ray] - rays_.middle;
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
        for (; first < rays_.dexels.size() && numbers.count < numbers.of.size(); ++first)
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
                rays_.starts[numbers.of[std::min(k, numbers.count - 1)]] - rays_.middle;
            for (std::size_t c = 0; c < 3; ++c)
                movements[c][k] = movement[static_cast<Eigen::Index>(c)];
        }
        return moved_rays(ball, movements);
    }

    // The same for an endless ball.
    void add_chords_of_ball(const NearTile& tile)
    {
        const BallOnRays ball{rays_.middle, rays_.direction, tile.piece.motion,
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
        RayOnMotion on{rays_.starts[material.ray], rays_.direction,
                       material.piece->motion, material.piece->body};
        on.set_error(error, chord_accuracy);
        return removed_on(on, material.search);
    }

    // \param may outside which the whole motion removes nothing.
    void add_halves(const NearMaterial& material, const ToolMotion& motion,
                    const Range& may, int halvings)
    {
        for (const ToolMotion& half : motion.halves()) {
            RayOnMotion on{rays_.starts[material.ray], rays_.direction, half,
                           material.piece->body};
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
        chords_.push_back({material.ray, rounded(removed, material.range)});
    }

    // Returns a chord whose ends are rounded outwards to whole units.
    DexelChord rounded(const Removed& removed, const Range& range) const
    {
        const auto& [may, sure] = removed;
        // units are powers of two, so that quotients are exact
        const auto down = [&](double s) {
            const auto whole = static_cast<std::int32_t>(s / rays_.unit);
            return whole * rays_.unit > s ? whole - 1 : whole;
        };
        const auto up = [&](double s) { return -down(-s); };
        DexelChord chord{{down(may.from), up(may.to)}, {0, 0}};
        if (sure)
            chord.sure = {up(sure->from), down(sure->to)};
        // The ends of the range itself are whole units.
        if (may.to >= range.to)
            chord.may.to = up(range.to - rays_.unit / 2);
        if (sure && sure->to >= range.to)
            chord.sure.to = chord.may.to;
        if (sure && sure->from <= range.from)
            chord.sure.from = down(range.from + rays_.unit / 2);
        return chord;
    }

    const DexelRays& rays_;
    std::vector<RayChord>& chords_;
};

}  // namespace

void add_chords(const DexelRays& rays, const ToolPiece& piece, const RayStretch& material,
                std::vector<RayChord>& chords)
{
    ChordSearch{rays, chords}.add(piece, material);
}

void add_chords_on_ray(const DexelRays& rays, const ToolPiece& piece, std::size_t ray,
                       std::vector<RayChord>& chords)
{
    ChordSearch{rays, chords}.add_on_ray(piece, ray);
}

}  // namespace endmill
