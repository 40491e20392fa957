// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/offset/offset_contact.h"

namespace endmill {

/// A great arc of unit normals. It begins at `start` and turns towards `heading`, which
/// is perpendicular to `start`.
struct NormalArc {
    Vec3 start;
    Vec3 heading;  ///< unit
    double angle;  ///< rad, 0 … pi

    Vec3 at(double share) const;  ///< the normal at a share 0 … 1 of the angle
};

/// The shorter great arc from one unit normal to another. \pre they are not opposite.
NormalArc arc_between(const Vec3& start, const Vec3& end);

/// The arc along which `normal` turns outwards about an edge of the border until N_z = 0.
/// \param normal unit, normal.z() > 0.
/// \param along direction of the edge, not zero; the part is on its left as seen from the
///     tool.
NormalArc arc_over_border(const Vec3& normal, const Vec3& along);

/// The largest angle in rad, at most pi, of an arc of `radius` mm whose chord lies within
/// `tolerance` mm of it.
double chord_angle(double radius, double tolerance);

/// The cutter and the chord error for the sampling of an arc.
struct ArcSampling {
    /// The cutter with the allowance.
    Cutter cutter;
    double tolerance;  ///< mm
};

/// Divides `arc` such that the reference points of `cutter` over a fixed contact lie
/// within `tolerance` mm of their chords. Where the arc passes over the axis, the bottom
/// of a flat or bull-nose cutter turns by up to half a turn at once; there a chord
/// crosses the disc.
/// \return the ends of the pieces as shares of the arc, from 0 to 1.
std::vector<double> arc_shares(const NormalArc& arc, const Cutter& cutter,
                               double tolerance);

/// A chain of vertices of an offset over one contact point. The normal turns from its
/// first vertex to its last.
struct ContactChain {
    /// Numbers of the vertices.
    std::vector<std::int32_t> vertices;
    std::vector<double> shares;  ///< of the whole turn, from 0 to 1, one for each vertex

    /// A chain of a single vertex.
    static ContactChain of(std::int32_t vertex) { return {{vertex}, {0}}; }
};

/// Divides the arc `level` of horizontal normals at a corner. A chain leads from `normal`
/// to each horizontal normal. The strips between neighbouring chains lie within
/// `tolerance` mm of the surface that the reference point follows. Near the axis the
/// bottom of a flat or bull-nose cutter turns fast, so that chains that pass the axis are
/// denser.
/// \param level the arc of horizontal normals.
/// \param normal the corner's own unit normal.
/// \param sampling cutter and tolerance.
/// \param least number of equal steps that the result contains in any case.
/// \return shares of `level` from 0 to 1.
std::vector<double> corner_shares(const NormalArc& level, const Vec3& normal,
                                  const ArcSampling& sampling, std::size_t least);

/// A chain to be computed: from vertex `from` over its contact point along `arc`.
struct ChainPlan {
    std::int32_t from;
    NormalArc arc;
};

/// A strip to be computed, by the numbers of its two chains.
struct StripPlan {
    std::size_t right;
    std::size_t left;
};

/// The normal at the end of an arc over a border, with z exactly 0.
Vec3 level_end(const NormalArc& arc);

/// An offset mesh under construction.
struct OffsetDraft {
    Cutter cutter;
    double arc_tolerance;
    std::size_t most_vertices;  ///< more throw LimitError
    std::vector<Vec3> points = {};
    std::vector<OffsetContact> contacts = {};
    std::vector<Triangle> triangles = {};

    /// Adds the vertex over the contact `point`. \return its number.
    std::int32_t add(const Vec3& point, const OffsetContact& contact);

    /// Adds the vertices of a chain that begins at vertex `from` and follows `arc` over
    /// the same contact point. The last vertex is `to`, or a new one.
    /// \return the chain.
    ContactChain add_chain(std::int32_t from, const NormalArc& arc, ContactKind kind,
                           std::optional<std::int32_t> to = std::nullopt);

    /// Adds several chains on all threads. Their last vertices are new. The result equals
    /// that of adding one after the other.
    /// \throws LimitError before it begins if they would have too many vertices.
    std::vector<ContactChain> add_chains(std::span<const ChainPlan> plans,
                                         ContactKind kind);

    /// Adds the triangles between two chains. Looking along both as seen from the tool,
    /// `left` is on the left. Degenerate triangles are left out.
    void add_strip(const ContactChain& right, const ContactChain& left);

    /// Adds the triangles of several strips, one after the other, on all threads.
    /// \pre the chains are from add_chains, so that two of them share at most their first
    ///     vertex.
    void add_strips(std::span<const ContactChain> chains,
                    std::span<const StripPlan> plans);

    /// The contact point of a vertex, in mm.
    Vec3 contact_point(std::int32_t vertex) const;

private:
    void require_room(double more) const;
    void fill_chain(const ChainPlan& plan, ContactKind kind, std::size_t first,
                    ContactChain& chain);
};

}  // namespace endmill
