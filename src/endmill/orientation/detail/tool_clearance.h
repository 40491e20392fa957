// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/cutting_body.h"
#include "endmill/machine/tool_motion.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The gap between a part and a tool at rest: the least signed distance of the part's places
/// from a convex body. A tree of discs encloses the triangles of the part. A signed distance
/// is convex, so its tangent at the middle of a disc is a lower bound on the disc.
/// An immutable value; queries may run on several threads.
class ToolClearance {
public:
    /// \param mesh of the part, with at least one triangle.
    /// \param chord_error distance of the part from the mesh, mm.
    explicit ToolClearance(const TriangleMesh& mesh, double chord_error = 0);

    /// Triangles of surfaces, within `chord_tolerance` mm.
    /// \throws LimitError if there would be too many.
    ToolClearance(std::span<const Surface> surfaces, std::span<const double> sides,
                  double chord_tolerance);

    /// Whether the gap is at least `least` mm for certain. If not, it is less than `least` plus
    /// the chord error and `accuracy`.
    bool is_clear(const CuttingBody& body, const ToolFrame& tool, double least) const;

    /// Numbers of discs that enclose all places of the part which matter to the bodies that
    /// touch it at a contact.
    using Front = std::vector<std::int32_t>;

    /// The front at a contact. A body that touches there lies on the tool's side of the
    /// tangent plane, so that places deep enough below it have the gap `least` for every axis.
    Front front(const CutterContact& contact, double least) const;

    /// Whether a place of a front may be seen from its contact at an elevation in rad above the
    /// tangent plane. Facets at the contact count if they turn by more against that plane.
    bool rises_above(double elevation, const CutterContact& contact,
                     std::span<const std::int32_t> front) const;

    /// The same as `is_clear` for a body that touches at a contact, by its front.
    bool is_clear(const CuttingBody& body, const ToolFrame& tool, double least,
                  std::span<const std::int32_t> front) const;

    /// The gap in mm: negative if the body is in the part, or infinity if it is above `enough`
    /// mm. Absolute error at most the chord error and `accuracy`.
    double gap(const CuttingBody& body, const ToolFrame& tool, double enough) const;

    /// Error of a gap in mm, apart from the chord error. It is far below tolerances.
    static constexpr double accuracy = 1e-4;

private:
    // A disc that encloses triangles. The children follow: the first is the next node.
    struct Disc {
        Vec3 centre;
        Vec3 normal;
        double radius;          // mm
        double thickness;       // mm, half of it, along the normal
        std::int32_t second;    // number of the second child; 0: a single triangle
        std::int32_t triangle;  // its number
    };
    // What a search looks for: distances below `enough` by more than `slack`; it ends below
    // `stop`. In mm.
    struct SearchLimits {
        double enough = 0;
        double slack = 0;
        double stop = std::numeric_limits<double>::lowest();
    };

    void build(const TriangleMesh& mesh);
    std::int32_t add(std::span<std::int32_t> triangles, std::span<const Vec3> centroids);
    Disc enclosing(std::span<const std::int32_t> triangles) const;
    double searched(const CuttingBody& body, const ToolFrame& tool,
                    const SearchLimits& limits,
                    std::span<const std::int32_t> starts) const;

    std::vector<Disc> discs_;
    std::vector<std::array<Vec3, 3>> corners_;
    double chord_error_ = 0;
};

}  // namespace endmill
