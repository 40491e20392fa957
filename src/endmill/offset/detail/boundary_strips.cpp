// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/boundary_strips.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

using Index = std::int32_t;

// The kind of a joint along the edge direction `along`, which has the side with `normal`
// on its left and the side with normal `beyond` on its right. The sign of the turn of the
// normal decides.
ContactKind crease_kind(const Vec3& normal, const Vec3& beyond, const Vec3& along)
{
    const Vec3 outwards = along.cross(normal).stableNormalized();
    const double turn = std::atan2(beyond.dot(outwards), beyond.dot(normal));
    if (std::abs(turn) <= smooth_angle)
        return ContactKind::Face;
    return turn > 0 ? ContactKind::ConvexCrease : ContactKind::ConcaveCrease;
}

// The chain of contacts over point k of a side, from the side's vertex to the mate's
// vertex.
ContactChain seam_chain(const GridSide& side, const GridSide& mate, std::size_t k,
                        OffsetDraft& draft)
{
    const Index from = side.vertices[k];
    const Index to = mate.vertices[mate.vertices.size() - 1 - k];
    if (from == to)
        return ContactChain::of(from);
    const Vec3& normal = draft.contacts[from].normal;
    const Vec3& beyond = draft.contacts[to].normal;
    const ContactKind kind = crease_kind(normal, beyond, side.along[k]);
    ContactChain chain = draft.add_chain(from, arc_between(normal, beyond), kind, to);
    if (kind != ContactKind::Face)
        draft.contacts[from].kind = draft.contacts[to].kind = kind;
    return chain;
}

ContactChain reversed(ContactChain chain)
{
    std::ranges::reverse(chain.vertices);
    std::ranges::reverse(chain.shares);
    for (double& share : chain.shares)
        share = 1 - share;
    return chain;
}

// Walks around a corner point of the part, clockwise as seen from the tool. A corner of a
// grid is denoted by the number of the side that begins there.
class CornerWalk {
public:
    CornerWalk(std::span<const GridSide> sides, std::span<const ContactChain> seams)
        : sides_{sides},
          seams_{seams}
    {
    }

    // The first corner in clockwise order, which lies behind the border. Inside the part,
    // where no border meets the point, `start` itself.
    Index first_corner(Index start) const
    {
        Index corner = start;
        while (true) {
            const GridSide& before = sides_[previous_side(corner)];
            if (before.is_border())
                return corner;
            corner = before.is_collapsed ? previous_side(corner) : before.mate;
            if (corner == start)
                return start;
        }
    }

    // The vertices over a corner point, without consecutive repetitions, and the corners
    // of grids that meet there. The ring is closed inside the part. Otherwise the last
    // corner is the one whose side is border.
    struct Ring {
        std::vector<Index> vertices;
        std::vector<Index> corners;
        bool is_closed;
    };

    Ring ring_from(Index first) const
    {
        Ring ring{{sides_[first].vertices.front()}, {}, false};
        Index corner = first;
        do {
            ring.corners.push_back(corner);
            const GridSide& side = sides_[corner];
            if (side.is_border())
                return ring;
            append(side.is_collapsed ? side.vertices : seams_[corner].vertices,
                   ring.vertices);
            corner = next_side(side.is_collapsed ? corner : side.mate);
        } while (corner != first);
        ring.is_closed = true;
        while (ring.vertices.size() > 1 && ring.vertices.back() == ring.vertices.front())
            ring.vertices.pop_back();
        return ring;
    }

private:
    static void append(std::span<const Index> more, std::vector<Index>& vertices)
    {
        for (const Index vertex : more)
            if (vertices.back() != vertex)
                vertices.push_back(vertex);
    }

    std::span<const GridSide> sides_;
    std::span<const ContactChain> seams_;
};

// Closes the hole between the strips that meet at a corner inside the part. A vertex with
// the mean normal is added, and connected by chains to all vertices of the ring.
void fill_ring(const std::vector<Index>& ring, OffsetDraft& draft)
{
    if (ring.size() < 3)
        return;
    OffsetContact contact = draft.contacts[ring.front()];
    Vec3 sum = Vec3::Zero();
    for (const Index vertex : ring) {
        sum += draft.contacts[vertex].normal;
        if (draft.contacts[vertex].kind == ContactKind::ConcaveCrease)
            contact.kind = ContactKind::ConcaveCrease;
    }
    contact.normal = sum.normalized();
    const Index middle = draft.add(draft.contact_point(ring.front()), contact);
    const auto chain_from = [&](Index vertex) {
        return draft.add_chain(vertex,
                               arc_between(draft.contacts[vertex].normal, contact.normal),
                               contact.kind, middle);
    };
    const ContactChain first = chain_from(ring.front());
    ContactChain right = first;
    for (std::size_t k = 1; k <= ring.size(); ++k) {
        ContactChain left = k < ring.size() ? chain_from(ring[k]) : first;
        draft.add_strip(right, left);
        right = std::move(left);
    }
}

// The chains and strips along the border. They are planned first, so that they can be
// computed on all threads.
class BorderPlan {
public:
    BorderPlan(std::span<const GridSide> sides, const OffsetDraft& draft)
        : draft_{draft},
          ends_(sides.size())
    {
    }

    std::span<const ChainPlan> chains() const { return chains_; }
    std::span<const StripPlan> strips() const { return strips_; }

    // Plans a chain over each point of side `number`, and the strips between them.
    void add_side(std::size_t number, const GridSide& side)
    {
        ends_[number].first = chains_.size();
        for (std::size_t k = 0; k < side.vertices.size(); ++k) {
            const Index vertex = side.vertices[k];
            add_chain(vertex, arc_over_border(normal_of(vertex), side.along[k]));
            if (k > 0)
                strips_.push_back({chains_.size() - 2, chains_.size() - 1});
        }
        ends_[number].last = chains_.size() - 1;
    }

    // Plans the strips around a corner of the border: from the chain over the end of side
    // `before` to the chain over the beginning of side `behind`. The level normals at the
    // ends of the chains turn about the z axis by less than half a turn. `ring` holds the
    // vertices over the corner point.
    void add_corner(std::size_t before, std::size_t behind, std::span<const Index> ring)
    {
        const std::size_t from = ends_[before].last;
        const std::size_t to = ends_[behind].first;
        const NormalArc level =
            arc_between(level_end(chains_[from].arc), level_end(chains_[to].arc));
        const std::size_t last = ring.size() - 1;
        const std::vector<double> shares =
            corner_shares(level, normal_of(ring[last / 2]),
                          {draft_.cutter, draft_.arc_tolerance}, last);
        std::size_t right = from;
        for (std::size_t k = 1; k + 1 < shares.size(); ++k) {
            const auto nearest = static_cast<std::size_t>(
                std::lround(shares[k] * static_cast<double>(last)));
            const Index base = ring[nearest];
            add_chain(base, arc_between(normal_of(base), level.at(shares[k])));
            strips_.push_back({right, chains_.size() - 1});
            right = chains_.size() - 1;
        }
        strips_.push_back({right, to});
    }

private:
    // The first and the last chain of a side on the border.
    struct Ends {
        std::size_t first;
        std::size_t last;
    };

    const Vec3& normal_of(Index vertex) const { return draft_.contacts[vertex].normal; }

    void add_chain(Index from, const NormalArc& arc) { chains_.push_back({from, arc}); }

    const OffsetDraft& draft_;
    std::vector<Ends> ends_;
    std::vector<ChainPlan> chains_;
    std::vector<StripPlan> strips_;
};

}  // namespace

// How the boundary of the grids is closed. A chain is a row of vertices over one contact
// point, whose normal turns from vertex to vertex; a strip is the triangles between two
// neighbouring chains (contact_strip.h).
// 1. Two sides that are mates have a chain over each of their points, from the normal of
//    one surface to that of the other. On a smooth joint the chain is one vertex.
// 2. At a corner inside the part the strips of several creases leave a hole. fill_ring
//    closes it with chains to the mean normal.
// 3. Each point of the border has a chain that turns outwards until the normal is level.
// 4. At a corner of the border the level normals of both sides differ. Further chains
//    between them close the gap.
std::vector<ContactChain> add_crease_strips(std::span<const GridSide> sides,
                                            OffsetDraft& draft)
{
    std::vector<ContactChain> seams(sides.size());
    for (Index number = 0; number < std::ssize(sides); ++number) {
        const GridSide& side = sides[number];
        if (side.mate <= number)  // without mate, or done with it
            continue;
        const GridSide& mate = sides[side.mate];
        ContactChain right = seam_chain(side, mate, 0, draft);
        seams[number] = right;
        for (std::size_t k = 1; k < side.vertices.size(); ++k) {
            ContactChain left = seam_chain(side, mate, k, draft);
            draft.add_strip(right, left);
            right = std::move(left);
        }
        seams[side.mate] = reversed(std::move(right));
    }
    const CornerWalk walk{sides, seams};
    std::vector<bool> is_done(sides.size());
    for (Index corner = 0; corner < std::ssize(sides); ++corner) {
        if (is_done[corner] || sides[corner].is_border())
            continue;
        const auto ring = walk.ring_from(walk.first_corner(corner));
        for (const Index other : ring.corners)
            is_done[other] = true;
        if (ring.is_closed)
            fill_ring(ring.vertices, draft);
    }
    return seams;
}

void add_border_strips(std::span<const GridSide> sides,
                       std::span<const ContactChain> seams, OffsetDraft& draft)
{
    BorderPlan plan{sides, draft};
    for (std::size_t number = 0; number < sides.size(); ++number)
        if (sides[number].is_border())
            plan.add_side(number, sides[number]);
    const CornerWalk walk{sides, seams};
    for (Index number = 0; number < std::ssize(sides); ++number) {
        if (!sides[number].is_border())
            continue;
        const auto ring = walk.ring_from(next_side(number));
        if (!ring.is_closed)
            plan.add_corner(number, ring.corners.back(), ring.vertices);
    }
    const std::vector<ContactChain> chains =
        draft.add_chains(plan.chains(), ContactKind::Border);
    draft.add_strips(chains, plan.strips());
}

}  // namespace endmill
