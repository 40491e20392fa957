// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/offset/slicer.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// On what a cutter whose reference point is a vertex of an offset mesh touches the part.
enum class ContactKind : std::uint8_t {
    Face,           ///< inside a surface, or on its border, with its normal
    ConvexCrease,   ///< on an edge over which the part turns down
    ConcaveCrease,  ///< on an edge over which the part turns up
    Border,         ///< on the part's border, the normal turned outwards about it
};

/// The contact of a vertex. Its point is `contact_point`.
struct OffsetContact {
    /// Leaves all members as they are: of millions that are filled in afterwards.
    OffsetContact() {}
    OffsetContact(const SurfacePoint& place, const Vec3& unit_normal,
                  std::int32_t surface_number, ContactKind touched)
        : at{place},
          normal{unit_normal},
          surface{surface_number},
          kind{touched}
    {
    }

    SurfacePoint at;
    Vec3 normal;           ///< unit, N_z >= 0; turned, where an edge or corner is touched
    std::int32_t surface;  ///< number of the surface
    ContactKind kind;
};

/// Whether the border and the creases of the part are touched, too.
enum class BoundaryContact : std::uint8_t {
    Contact,  ///< strips around them: a trimmed path is right up to the part's end
    None,     ///< each surface by itself, as in the paper; smooth joints closed only
};

/// What `offset_mesh` may be told.
struct OffsetOptions {
    int grid_lines = 200;  ///< along each parameter of each surface, at least 2
    BoundaryContact boundary = BoundaryContact::Contact;
    double allowance = 0;  ///< mm of stock to leave between part and cutter
    /// Greatest chord error in mm of an arc in a strip, along the normal, less than the 1e-3
    /// of the spec: it should not exceed that of sheets of 400 grid lines. Over corners of a
    /// part up to (1 + 1 / N_z)^2 times as much, N_z the corner's own: 4 on level ground. For
    /// a triangle errs there by l^2 / 8R, l its longest edge, a step a along a chain and what
    /// parts two chains, at most a / N_z: those from a tilted normal part where they pass
    /// over the top. In z it is 1 / N_z of the contact as much.
    double arc_tolerance = 1.25e-4;
    std::size_t most_vertices = 100'000'000;  ///< of all sheets
};

/// The offset of a part for a cutter: reference points over contacts, folds kept.
struct OffsetMesh {
    TriangleMesh mesh;                    ///< outer side where the tool is
    std::vector<OffsetContact> contacts;  ///< of each vertex
    Cutter cutter;                        ///< with the allowance in its radii
    std::size_t sheet_triangles;          ///< these come first: of the surfaces
    /// Then the strips over creases; from here on those along the border.
    std::size_t own_triangles;
    /// The vertices along each side of a surface, and along its creases.
    std::vector<std::vector<std::int32_t>> outlines;
};

/// The offset of `surfaces` by all of their contacts, eq. (3) to (5):
///
///     p' = p + r N + (R - r) H.
///
/// Each surface is taken at grid_lines by grid_lines parameters i / (grid_lines - 1) of
/// its range, and at the borders between its patches where it is not continuously
/// differentiable. Cells between (i, j) and (i + 1, j + 1) become the triangles a b d and
/// a d c with a = (i, j), b = (i + 1, j), c = (i, j + 1), d = (i + 1, j + 1). Over a level
/// place the centre of the disc is taken, see `control_offset`: over a lone crest a flat
/// or bull-nose cutter then comes out too low by an error of order 1.5 in the cell's size.
///
/// With BoundaryContact::Contact strips are added whose contacts stay on an edge while the
/// normal turns: at a crease from that of the one side to that of the other, along a great
/// arc; at the border outwards about the edge until N_z = 0; at corners over all normals
/// between. Surfaces meet where sides have the same points, to 1e-6 of the largest
/// diagonal, at the same grid lines; sides that do not are borders, which closes gaps with
/// a margin. Vertices nearer than that are made one across smooth joints.
/// Source: [JangKimJeong, eq. (3) to (5)]; strips and level places are the spec's,
/// section 2.4 and 2.5.
/// \throws DomainError unless grid_lines >= 2, 0 <= allowance and 0 < arc_tolerance are
/// finite, and there is a surface. \throws LimitError beyond `most_vertices`.
/// \throws GeometryError, with the place, if N_z <= 0 anywhere or a normal is missing.
OffsetMesh offset_mesh(std::span<const Surface> surfaces, const Cutter& cutter,
                       const OffsetOptions& options = {});

/// Where the cutter touches the part when its reference point is at `vertex`, in mm; to a
/// few roundings.
Vec3 contact_point(const OffsetMesh& offset, std::int32_t vertex);

/// The part as the offset samples it: the contacts inside and at the ends of its surfaces,
/// joined as the offset's triangles are. Its chords err by the cells' size squared.
TriangleMesh contact_mesh(const OffsetMesh& offset);

/// The range of s over which the path of each plane stays over the part: the smallest that
/// holds the plane's section of the part, as sampled, and of the offset without its strips
/// along the border; nothing where the plane meets neither.
/// \param sections of offset.mesh, sliced with its `own_triangles`.
std::vector<std::optional<Interval>> path_ranges(const OffsetMesh& offset,
                                                 const DrivePlanes& planes,
                                                 std::span<const PlaneSection> sections);

}  // namespace endmill
