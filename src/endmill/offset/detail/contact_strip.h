// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/offset/offset_mesh.h"

namespace endmill {

/// A great arc of unit normals, from `start` towards `heading`, at right angles to it.
struct NormalArc {
    Vec3 start;
    Vec3 heading;  ///< unit
    double angle;  ///< rad, 0 … pi

    Vec3 at(double share) const;  ///< the normal at a share 0 … 1 of the angle
};

/// The shorter great arc from one normal to another. \pre they are not opposite.
NormalArc arc_between(const Vec3& start, const Vec3& end);

/// The arc from `normal` about an edge, outwards, until N_z = 0.
/// \param along direction of the edge, the part on its left seen from the tool, not zero.
/// \pre normal.z() > 0
NormalArc arc_over_border(const Vec3& normal, const Vec3& along);

/// Greatest angle in rad of an arc of `radius` whose chord lies within `tolerance` of it, both
/// in mm; half a turn at most.
double chord_angle(double radius, double tolerance);

/// For which cutter an arc is sampled, and to what chord error.
struct ArcSampling {
    Cutter cutter;
    double tolerance;  ///< mm
};

/// Shares of `arc`, from 0 to 1, between which the reference points of `cutter` over a
/// fixed contact lie within `tolerance` mm of their chords. Where the arc passes over the
/// axis, the bottom of a flat or bull-nose cutter turns by up to half a turn at once: there
/// a chord goes across the disc.
std::vector<double> arc_shares(const NormalArc& arc, const Cutter& cutter,
                               double tolerance);

/// Vertices of an offset over one contact point, the normal turning from the first on.
struct ContactChain {
    std::vector<std::int32_t> vertices;
    std::vector<double> shares;  ///< of the whole turn, from 0 to 1

    static ContactChain of(std::int32_t vertex) { return {{vertex}, {0}}; }
};

/// The same for chains over a corner: shares of the arc `level` of level normals, from 0 to
/// 1, so that the strips between neighbouring chains, each from the unit `normal` to a level
/// one, lie within `tolerance` mm of what the cutter rolls over. Beside the axis the middle
/// of a flat or bull-nose cutter's bottom turns fast: chains that pass it are denser.
/// \param least of the steps, evenly spaced: these are not left out.
std::vector<double> corner_shares(const NormalArc& level, const Vec3& normal,
                                  const ArcSampling& sampling, std::size_t least);

/// A chain to be: from vertex `from` over its contact point along `arc`.
struct ChainPlan {
    std::int32_t from;
    NormalArc arc;
};

/// A strip to be: the numbers of its chains.
struct StripPlan {
    std::size_t right;
    std::size_t left;
};

/// The normal at the end of an arc over a border: level, to the bit.
Vec3 level_end(const NormalArc& arc);

/// An offset mesh that grows.
struct OffsetDraft {
    Cutter cutter;
    double arc_tolerance;
    std::vector<Vec3> points;
    std::vector<OffsetContact> contacts;
    std::vector<Triangle> triangles;

    /// Adds the vertex over the contact point `point`. \return its number.
    std::int32_t add(const Vec3& point, const OffsetContact& contact);

    /// A chain from vertex `from` over its contact point along `arc`; its last vertex is
    /// `to`, or a new one.
    ContactChain add_chain(std::int32_t from, const NormalArc& arc, ContactKind kind,
                           std::optional<std::int32_t> to = std::nullopt);

    /// Chains with new last vertices, as if added one after the other; on all threads.
    std::vector<ContactChain> add_chains(std::span<const ChainPlan> plans,
                                         ContactKind kind);

    /// Triangles between two chains. Looking along both, `left` is on the left, seen from
    /// the tool. Those with equal corners are left out.
    void add_strip(const ContactChain& right, const ContactChain& left);

    /// The same for pairs of chains, one after the other; on all threads.
    /// \pre they are from add_chains: no two share a vertex but their first.
    void add_strips(std::span<const ContactChain> chains,
                    std::span<const StripPlan> plans);

    /// The contact point of a vertex, in mm.
    Vec3 contact_point(std::int32_t vertex) const;

private:
    void fill_chain(const ChainPlan& plan, ContactKind kind, std::size_t first,
                    ContactChain& chain);
};

}  // namespace endmill
