// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/piece_chords.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

constexpr double unit = 0x1p-20;
constexpr double length = 12;
constexpr int poses = 64;

// Eight full rays along x.
DexelRays full_rays()
{
    const auto units = static_cast<std::int32_t>(length / unit);
    DexelRays rays{
        unit, Vec3::UnitX(), length, std::vector<Dexel>(8, {{{0, units}}, {{0, units}}}),
        {},   {0, 0.7, 0},   0.7};
    for (int k = 0; k < 8; ++k)
        rays.starts.emplace_back(0, 0.2 * k, 0);
    return rays;
}

// The least signed distance from the cutter over many poses.
double sampled(const ToolPiece& piece, const Vec3& place)
{
    double least = 1e9;
    for (int k = 0; k <= poses; ++k)
        least = std::min(
            least,
            piece.body.distance(piece.motion.seen(place, k / static_cast<double>(poses)))
                .value);
    return least;
}

ToolPiece random_piece(test::Random& random, const CuttingBody& body)
{
    const auto place = [&](double size) {
        return Vec3{random.uniform(-size, size), random.uniform(-size, size),
                    random.uniform(-size, size)};
    };
    const CutterLocation from{Vec3{6, 0, -1} + place(2), Vec3::UnitZ()};
    const Vec3 axis = (from.axis + place(0.03)).normalized();
    return {ToolMotion{from, {from.tip + place(0.5), axis}}, body, 0, 0};
}

// The sampled poses are at most 0.014 mm apart.
void expect_bounded(const DexelRays& rays, const ToolPiece& piece,
                    std::span<const RayChord> chords, test::Random& random)
{
    const auto distance = [&](std::size_t ray, double s) {
        return sampled(piece, rays.starts[ray] + s * rays.direction);
    };
    for (const auto& [ray, chord] : chords) {
        if (chord.sure.from >= chord.sure.to)
            continue;
        for (const double share : {0.0, 0.5, 1.0}) {
            const double s = unit * std::lerp(chord.sure.from, chord.sure.to, share);
            EXPECT_LE(distance(ray, s), 0.01);
        }
    }
    for (std::size_t ray = 0; ray < rays.starts.size(); ++ray)
        for (int k = 0; k < 40; ++k) {
            const double s = random.uniform(0, length);
            const bool is_outside =
                std::ranges::none_of(chords, [&](const RayChord& one) {
                    return one.ray == ray && one.chord.may.from * unit <= s &&
                           s <= one.chord.may.to * unit;
                });
            if (is_outside) {
                EXPECT_GT(distance(ray, s), -1e-9);
            }
        }
}

class PieceChords : public testing::TestWithParam<CuttingBody> {};

TEST_P(PieceChords, SureIsRemovedAndNothingOutsideThePossible)
{
    const DexelRays rays = full_rays();
    test::Random random{4};
    std::size_t found = 0;
    for (int number = 0; number < 60; ++number) {
        const ToolPiece piece = random_piece(random, GetParam());
        std::vector<RayChord> together;
        add_chords(rays, piece, {0, length}, together);
        expect_bounded(rays, piece, together, random);
        found += together.size();
        std::vector<RayChord> alone;
        for (std::size_t ray = 0; ray < rays.starts.size(); ++ray)
            add_chords_on_ray(rays, piece, ray, alone);
        expect_bounded(rays, piece, alone, random);
    }
    EXPECT_GT(found, 100U);
}

INSTANTIATE_TEST_SUITE_P(Cutters, PieceChords,
                         testing::Values(CuttingBody{Cutter::ball(2)},
                                         CuttingBody{Cutter::flat(2)},
                                         CuttingBody{Cutter{2, 0.5}},
                                         CuttingBody{Cutter::ball(2), 4}));

}  // namespace
}  // namespace endmill
