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
#include "endmill/offset/offset_contact.h"
#include "endmill/offset/slicer.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Whether the offset contains the contacts on the border and the creases of the part.
enum class BoundaryContact : std::uint8_t {
    /// The offset has strips of triangles over borders and creases. A trimmed path is
    /// correct up to the border.
    Contact,
    /// No strips, as in the paper. Each surface is offset separately; only smooth joints
    /// are closed.
    None,
};

/// Options of offset_mesh.
struct OffsetOptions {
    int grid_lines = 200;  ///< along each parameter of each surface, at least 2
    /// Whether the border and the creases count as contacts.
    BoundaryContact boundary = BoundaryContact::Contact;
    double allowance = 0;  ///< mm, stock to leave between part and cutter
    /// Largest chord error in mm of the arc of normals in a strip, measured along the
    /// normal. With the default, strips are as accurate as grids of 400 lines. At a
    /// corner of the part the error is up to (1 + 1/N_z)^2 times as large, with N_z of
    /// the corner's own normal; the factor is 4 if this normal is vertical. In z the
    /// error is 1/N_z times as large, with N_z of the contact.
    /// Source: docs/methods/interference.md, section 2.5.
    double arc_tolerance = 1.25e-4;
    /// Upper limit of the number of vertices of all grids and strips.
    std::size_t most_vertices = 100'000'000;
};

/// The offset mesh of a part for a cutter. Its vertices are the reference points of the
/// cutter over the contacts of the part. Its folds are not removed.
struct OffsetMesh {
    TriangleMesh mesh;  ///< the outer side of its triangles is the tool's side
    std::vector<OffsetContact> contacts;  ///< one for each vertex
    Cutter cutter;  ///< the cutter with the allowance added to its radii
    /// Number of triangles of the surfaces, which come first.
    std::size_t surface_triangles;
    /// Number of triangles of the surfaces and of the strips over creases. The strips
    /// along the border follow.
    std::size_t part_triangles;
    /// The vertices along each side of each grid, which are those on borders and creases.
    std::vector<std::vector<std::int32_t>> outlines;
};

/// The offset of `surfaces` for `cutter`: every vertex is the reference point
///
///     p' = p + r N + (R - r) H
///
/// over a contact p with unit normal N, where H is the unit vector along (N_x, N_y, 0).
///
/// Each surface is sampled at grid_lines by grid_lines equidistant parameters of its
/// range, and also at the borders between its patches where it is not continuously
/// differentiable. The cell between (i, j) and (i + 1, j + 1) becomes the triangles a b d
/// and a d c with a = (i, j), b = (i + 1, j), c = (i, j + 1), d = (i + 1, j + 1). If N is
/// vertical, H is not defined. The vertex is then the centre of the disc of reference
/// points (control_offset). Over an isolated crest, the offset for a flat or bull-nose
/// cutter is therefore too low, by an error of the order O(cell size^1.5).
///
/// With BoundaryContact::Contact strips of triangles are added. The contacts of a strip
/// stay on an edge while the normal turns. At a crease it turns from the normal of one
/// side to that of the other along a great arc; at the border it turns outwards about the
/// edge until N_z = 0; at a corner it takes all directions between. Two sides of surfaces
/// are joined if they have the same points, to 1e-6 of the largest diagonal, at the same
/// grid lines. Unmatched sides count as borders; their strips cover small gaps. At smooth
/// joints, vertices within that distance are merged.
/// Source: [JangKimJeong, eq. (3) to (5)]; strips and vertical normals:
/// docs/methods/interference.md, section 2.4 and section 2.5.
/// \param surfaces the part.
/// \param cutter the cutter.
/// \param options sampling, contacts on the boundary, allowance and limits.
/// \throws DomainError unless there is a surface, grid_lines >= 2, and 0 <= allowance and
///     0 < arc_tolerance are finite.
/// \throws LimitError if the grids may have more than `most_vertices` vertices, or have more
///     with the strips.
/// \throws GeometryError with the place where N_z <= 0 or the surface has no normal.
OffsetMesh offset_mesh(std::span<const Surface> surfaces, const Cutter& cutter,
                       const OffsetOptions& options = {});

/// The point of the part that the cutter touches when its reference point is at `vertex`,
/// in mm. It is accurate to a few roundings.
Vec3 contact_point(const OffsetMesh& offset, std::int32_t vertex);

/// The part as the offset samples it: the contacts of the surfaces, with the triangles of
/// their grids. Its chord errors are proportional to the square of the size of the cells.
TriangleMesh contact_mesh(const OffsetMesh& offset);

/// For each plane, the range of s in which the cutter is above the part. It is the
/// smallest interval that contains the plane's section of the sampled part and its
/// section of the offset without the strips along the border. It is empty for a plane
/// that meets neither.
/// \param offset the offset of the part.
/// \param planes the planes that sliced it.
/// \param sections of offset.mesh, sliced with its `part_triangles`, one for each plane.
std::vector<std::optional<Interval>> path_ranges(const OffsetMesh& offset,
                                                 const DrivePlanes& planes,
                                                 std::span<const PlaneSection> sections);

}  // namespace endmill
