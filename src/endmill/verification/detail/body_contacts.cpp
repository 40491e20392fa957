// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/body_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "endmill/core/parallel.h"
#include "endmill/verification/detail/body_place.h"

// The depth of a place of the part in a cylinder during a move (`place_in_body`) is a
// concave function of the place, and it changes by no more than the place moves.
// 1. The triangles are taken in blocks of eight. The tree lists the open moves that may
//    bring the cylinder into the box of a block; one evaluation at the box's middle
//    rejects most of them.
// 2. For each move and triangle, `PiecewiseDepth` bounds the depth: from below by the
//    depths at the corners and middles, from above by the tangent plane in the middle. A
//    piece is quartered until its bound is negligible or accurate enough.
// 3. The results are merged in the order of the blocks, so they do not depend on the
//    threads.
// Source: paper/notes/body-contacts.md.

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Triangles per block, and blocks whose results are kept before they are merged in order.
constexpr std::size_t block_size = 8;
constexpr std::size_t blocks_at_a_time = 2048;
// Accuracy of the deepest contact, as a share of its depth.
constexpr double error_share_of_depth = 0.01;
// Accuracy of a bound near `part_contact_slack`, as a share of that slack.
constexpr double error_share_of_slack = 0.125;
// Accuracy below this share of the chord error is useless, because the part itself is not
// known better.
constexpr double least_share_of_chord_error = 0.5;
// Limit of the pieces of a triangle per move. The upper bounds of the remaining pieces
// are kept.
constexpr int most_pieces = 20'000;

// The bounds that a block gives for a move.
struct Finding {
    std::size_t move;
    BodyMove found;
};

// The bounding box of a run of triangles. The moves are in a tree, so runs of neighbouring
// triangles need none.
using Box = Eigen::AlignedBox3d;

using Corners = std::array<Vec3, 3>;

// Bounds the depth of one move in one triangle by subdividing the triangle.
class PiecewiseDepth {
public:
    PiecewiseDepth(const BodyAndMesh& task, const SweptMove& move, BodyMove& found)
        : task_{task},
          move_{move},
          lowest_{move.z + std::min(move.rise, 0.0) + task.cylinder.above},
          found_{found}
    {
    }

    void look_at(const Corners& corners, double negligible, double sharpness)
    {
        const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3;
        double reach2 = 0;
        for (const Vec3& corner : corners)
            reach2 = std::max(reach2, (corner - centre).squaredNorm());
        if (place_in_body(task_.cylinder, move_, centre).depth + std::sqrt(reach2) +
                task_.chord_error <=
            std::max(negligible, found_.depth))
            return;
        // The corners lie on the part. Other places of the triangle are off by up to the
        // chord error.
        for (const Vec3& corner : corners)
            count(place_in_body(task_.cylinder, move_, corner).depth, corner);
        std::vector<Corners> pieces{corners};
        for (int done = 0; !pieces.empty(); ++done) {
            const Corners piece = pieces.back();
            pieces.pop_back();
            const Vec3 middle = (piece[0] + piece[1] + piece[2]) / 3;
            const BodyPlace at = place_in_body(task_.cylinder, move_, middle);
            count(at.depth - task_.chord_error, middle);
            const double most = greatest(piece, middle, at);
            // The accuracy that this piece needs.
            const double sharp =
                std::max({sharpness, least_share_of_chord_error * task_.chord_error,
                          found_.is_in() ? error_share_of_depth * found_.depth : 0});
            const double known = found_.is_in() ? found_.depth + sharp : 0;
            if (most + task_.chord_error <= std::max(negligible, known))
                continue;
            if (most - at.depth <= sharp || done >= most_pieces)
                found_.most = std::max(found_.most, most + task_.chord_error);
            else
                add_quarters(piece, pieces);
        }
    }

private:
    // Updates the greatest certain depth.
    void count(double depth, const Vec3& place)
    {
        if (depth > found_.depth) {
            found_.depth = depth;
            found_.place = place;
        }
    }

    // Returns an upper bound of the depth on a piece: by the tangent plane in the middle,
    // or by the highest corner over the lowest position of the cylinder's end.
    double greatest(const Corners& piece, const Vec3& middle, const BodyPlace& at) const
    {
        double by_tangent = -infinite;
        double highest = -infinite;
        for (const Vec3& corner : piece) {
            by_tangent = std::max(by_tangent, at.depth + at.rise.dot(corner - middle));
            highest = std::max(highest, corner.z());
        }
        return std::min(by_tangent, highest - lowest_);
    }

    static void add_quarters(const Corners& piece, std::vector<Corners>& pieces)
    {
        const auto& [a, b, c] = piece;
        const Vec3 ab = (a + b) / 2;
        const Vec3 bc = (b + c) / 2;
        const Vec3 ca = (c + a) / 2;
        for (const Corners& quarter : {Corners{a, ab, ca}, Corners{ab, b, bc},
                                       Corners{ca, bc, c}, Corners{ab, bc, ca}})
            pieces.push_back(quarter);
    }

    const BodyAndMesh& task_;
    const SweptMove& move_;
    double lowest_;  // lowest position of the cylinder's lower end, mm
    BodyMove& found_;
};

// Returns the open moves that may bring the cylinder into the box.
std::vector<std::size_t> moves_near(const BodyAndMesh& task, const Box& box)
{
    Vec3 place = box.center();
    place.z() = box.max().z() - task.cylinder.above;
    const double reach =
        task.cylinder.radius + (box.sizes() / 2).head<2>().norm() + task.chord_error;
    std::vector<std::size_t> near;
    task.tree.visit(
        place,
        [&](const Vec3& nearest) {
            return (nearest - place).head<2>().norm() < reach &&
                   nearest.z() - place.z() <= task.chord_error;
        },
        [&](std::size_t number) { near.push_back(number); });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
}

// Returns the bounds that the triangles first … last - 1 give for the open moves.
std::vector<Finding> contacts_in(const BodyAndMesh& task, const BodyMoves& moves,
                                 std::size_t first, std::size_t last)
{
    Box box;
    for (std::size_t k = first; k < last; ++k)
        for (const Vec3& corner : task.mesh.corners(k))
            box.extend(corner);
    std::vector<Finding> findings;
    for (const std::size_t number : moves_near(task, box)) {
        const StraightSweep& sweep = task.tree.sweeps()[number];
        const SweptMove move = swept_move(sweep.from(), sweep.to());
        const double negligible = moves.negligible(number);
        const double around = place_in_body(task.cylinder, move, box.center()).depth +
                              (box.sizes() / 2).norm() + task.chord_error;
        if (around <= negligible)
            continue;
        Finding finding{number, {.depth = 0, .place = box.center(), .most = -infinite}};
        PiecewiseDepth depth{task, move, finding.found};
        for (std::size_t k = first; k < last; ++k)
            depth.look_at(task.mesh.corners(k), negligible, moves.sharpness(number));
        if (finding.found.depth > 0 || finding.found.most > 0)
            findings.push_back(finding);
    }
    return findings;
}

}  // namespace

BodyMoves::BodyMoves(std::span<const StraightSweep> sweeps)
    : sweeps_{sweeps},
      moves_(sweeps.size())
{
    for (std::uint32_t k = 0; k < sweeps.size(); ++k)
        open_.push_back(k);
}

std::vector<StraightSweep> BodyMoves::open_sweeps() const
{
    std::vector<StraightSweep> sweeps;
    for (const std::uint32_t number : open_)
        sweeps.push_back(sweeps_[number]);
    return sweeps;
}

double BodyMoves::negligible(std::size_t number) const
{
    return open(number).is_in() ? deepest_ + depth_sharpness() : part_contact_slack;
}

double BodyMoves::sharpness(std::size_t number) const
{
    return open(number).is_in() ? depth_sharpness()
                                : error_share_of_slack * part_contact_slack;
}

// Accuracy of the greatest depth, mm.
double BodyMoves::depth_sharpness() const
{
    return std::max(error_share_of_slack * part_contact_slack,
                    error_share_of_depth * deepest_);
}

void BodyMoves::take(std::size_t number, const BodyMove& found)
{
    BodyMove& move = moves_[open_[number]];
    if (found.depth > move.depth) {
        move.depth = found.depth;
        move.place = found.place;
    }
    move.most = std::max(move.most, found.most);
    deepest_ = std::max(deepest_, move.depth);
}

void BodyMoves::begin_pass()
{
    for (const std::uint32_t number : open_)
        moves_[number].most = moves_[number].depth;
}

void BodyMoves::end_pass(double chord_error)
{
    std::erase_if(open_, [&](std::uint32_t number) {
        const BodyMove& move = moves_[number];
        if (!move.is_in())
            return move.most <= part_contact_slack;
        return chord_error <= depth_sharpness() ||
               move.most <= deepest_ + depth_sharpness();
    });
}

PartCollisions BodyMoves::found(std::size_t first) const
{
    PartCollisions found;
    found.bound_mm = part_contact_slack;
    double most = deepest_;
    for (std::size_t k = 0; k < moves_.size(); ++k) {
        const BodyMove& move = moves_[k];
        if (!move.is_in()) {
            found.bound_mm = std::max(found.bound_mm, move.most);
            continue;
        }
        most = std::max({most, move.most, deepest_ + depth_sharpness()});
        ++found.moves.count;
        if (!found.moves.first)
            found.moves.first = first + k;
        if (move.depth > found.moves.deepest) {
            found.moves.deepest = move.depth;
            found.deepest = {move.place, first + k};
        }
    }
    found.error_mm = most - deepest_;
    return found;
}

void find_contacts(const BodyAndMesh& task, BodyMoves& moves)
{
    const std::size_t triangles = task.mesh.triangles().size();
    const std::size_t blocks = (triangles + block_size - 1) / block_size;
    for (std::size_t start = 0; start < blocks; start += blocks_at_a_time) {
        const std::size_t count = std::min(blocks_at_a_time, blocks - start);
        std::vector<std::vector<Finding>> findings(count);
        parallel_for(count, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const std::size_t first = (start + k) * block_size;
                findings[k] = contacts_in(task, moves, first,
                                          std::min(triangles, first + block_size));
            }
        });
        for (const std::vector<Finding>& block : findings)
            for (const Finding& finding : block)
                moves.take(finding.move, finding.found);
    }
}

}  // namespace endmill
