// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/turning_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "endmill/core/parallel.h"
#include "endmill/core/tolerance.h"
#include "endmill/deviation/detail/bounded_ray.h"
#include "endmill/deviation/detail/part_tiles.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Cells are divided until their reach is at most this share of the slack.
constexpr double least_reach_share = 0.4;
// Reach of the cells by which moves with a contact are counted, as a share of the pitch.
constexpr double contact_reach_share = 0.5;
// The reach of a cell on a curved patch, from its corners and the partials at its middle, may
// be too small by this share while cells are small against the curvature.
constexpr double reach_margin = 1.1;

// What is found on one piece of the part.
struct Found {
    double deepest = 0;  // mm, certain
    Vec3 place = Vec3::Zero();
    std::size_t move = 0;
    double most = 0;  // mm, a contact may be this deep
    std::set<std::size_t> moves = {};

    void take(const Found& other)
    {
        if (other.deepest > deepest) {
            deepest = other.deepest;
            place = other.place;
            move = other.move;
        }
        most = std::max(most, other.most);
        moves.insert(other.moves.begin(), other.moves.end());
    }
};

class ContactSearch {
public:
    ContactSearch(const PartCharts& charts, const ToolPieces& bodies, double pitch)
        : charts_{charts},
          bodies_{bodies},
          contact_reach_{contact_reach_share * pitch}
    {
    }

    // Tests a cell and, if the answer is open, its quarters.
    // \param budget number of cells that may still be divided.
    Found test(const PartCell& cell, std::size_t& budget) const
    {
        const auto ray = charts_.ray(cell.chart, cell.centre());
        Found found;
        if (!ray)
            return found;
        const double reach = reach_of(cell, *ray);
        double nearest = infinite;
        bodies_.visit_nearest(ray->point, reach, [&](std::size_t number, double) {
            const ToolPiece& piece = bodies_.pieces()[number];
            const PieceDistance at = distance_from(piece, ray->point, infinite);
            nearest = std::min(nearest, at.lower);
            take_certain(found, piece, ray->point, at.at);
            return reach;
        });
        const double possible = reach - nearest;
        if (possible <= part_contact_slack)
            return found;
        // Where a contact is certain, the verdict is too; the cells become only as small
        // as needed to tell which moves have one.
        if ((found.deepest > 0 && reach <= contact_reach_) ||
            reach <= least_reach_share * part_contact_slack || budget == 0) {
            found.most = possible;
            return found;
        }
        --budget;
        for (const PartCell& quarter : cell.quarters())
            found.take(test(quarter, budget));
        return found;
    }

private:
    // Distance of the farthest place of a cell from its middle.
    double reach_of(const PartCell& cell, const PartRay& middle) const
    {
        double reach = cell.reach(middle);
        for (std::size_t k = 0; k < static_cast<std::size_t>(cell.corners); ++k)
            if (const auto corner = charts_.ray(cell.chart, cell.at[k]))
                reach = std::max(reach, (corner->point - middle.point).norm());
        return reach_margin * reach;
    }

    static void take_certain(Found& found, const ToolPiece& piece, const Vec3& place,
                             double u)
    {
        const double depth = -piece.body.distance(piece.motion.seen(place, u)).value;
        if (depth <= part_contact_slack)
            return;
        const auto move = static_cast<std::size_t>(piece.point);
        found.moves.insert(move);
        if (depth > found.deepest) {
            found.deepest = depth;
            found.place = place;
            found.move = move;
        }
    }

    const PartCharts& charts_;
    const ToolPieces& bodies_;
    double contact_reach_;  // mm
};

}  // namespace

PartCollisions turning_contacts(const PartCharts& charts, const ToolPieces& bodies,
                                double pitch, std::size_t most_cells)
{
    PartCollisions collisions;
    if (bodies.pieces().empty())
        return collisions;
    const std::vector<PartTile> tiles = part_tiles(charts, pitch, most_cells);
    const ContactSearch search{charts, bodies, pitch};
    std::vector<Found> found(tiles.size());
    const std::size_t budget = std::max<std::size_t>(1, most_cells / (tiles.size() + 1));
    parallel_for(tiles.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            std::size_t left = budget;
            found[k] = search.test(tiles[k].whole, left);
        }
    });
    Found all;
    for (const Found& some : found)
        all.take(some);
    collisions.moves.count = all.moves.size();
    if (!all.moves.empty())
        collisions.moves.first = *all.moves.begin();
    collisions.moves.deepest = all.deepest;
    if (all.deepest > 0)
        collisions.deepest = DeepestContact{all.place, all.move};
    collisions.error_mm = std::max(0.0, all.most - all.deepest);
    collisions.bound_mm = all.deepest > 0 ? 0 : std::max(part_contact_slack, all.most);
    return collisions;
}

}  // namespace endmill
