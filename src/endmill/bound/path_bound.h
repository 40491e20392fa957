// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/bound/bound_problem.h"
#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/surface/surface.h"

/// \file
/// A lower bound of the length, and one of the number of points, of every path of a ball-end
/// mill that covers a part. Implemented in `path_bound.cpp` and `points_bound.cpp`.

namespace endmill {

/// How certain a bound is.
enum class BoundGrade {
    Closed,     ///< a closed form, proved; certain up to rounding
    Certified,  ///< the condition of the bound was proved by intervals, up to rounding
    Estimated,  ///< the condition of the bound was tested at many places, not proved
};

/// The name of a grade: "closed", "certified" or "estimated".
std::string_view bound_grade_name(BoundGrade grade);

/// A cell of the grid on which a density was computed.
struct DensityCorners {
    std::array<Vec3, 4> points;  ///< corners in order around the cell, mm
    double mean_per_mm;          ///< mean of the density at them, 1/mm
};

/// A lower bound of path length, with the numbers behind it.
struct PathBound {
    double density_mm;  ///< integral of the density g over the part
    double disc_mm;     ///< G: greatest integral of g over the set that one place covers
    /// The bound, density_mm - m disc_mm, for paths of at most m pieces; nothing if that
    /// is not positive, which happens on parts little larger than a disc.
    std::optional<double> bound_mm;
    BoundGrade grade;  ///< how certain it is
    /// Greatest inflow at the random places of the last test, before the density was
    /// divided by it; 1 for closed forms. It says how well the density was known.
    double greatest_inflow = 1;
    std::size_t places = 0;       ///< places that limited the density; 0 for closed forms
    std::size_t test_places = 0;  ///< random places of the last test
    std::size_t boxes = 0;        ///< boxes of contacts of a certificate
    double node_spacing_mm = 0;   ///< of the density's nodes; 0 for closed forms
    /// The density g; empty for closed forms. Of a bound of tips it is the density before
    /// it is lowered for what the ball strays from contact.
    std::vector<DensityCorners> density = {};
};

/// How a bound is estimated. The defaults take a few seconds on 200 x 120 mm.
struct EstimateOptions {
    /// Spacing in mm of the density's nodes. On meshes the default is 0.6 of the width that the
    /// ball covers on a plane. On surfaces it is 0.7 of the
    /// width that the ball covers on a plane; on parts that then have fewer than 4000
    /// nodes it is smaller, down to half of that. Smaller ones give larger bounds, by
    /// 0.6 % at most on the surfaces tried, and need time and memory as one over the
    /// square.
    std::optional<double> node_spacing = std::nullopt;
    /// Random places of each of four tests, from fixed seeds; at least 1000.
    std::size_t random_places = 20000;
    /// Grade of `path_bound` where no closed form is known: Estimated or Certified.
    BoundGrade grade = BoundGrade::Estimated;
    /// Called with the share of the work that is done, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// The bound for a part: in closed form if the part is one plane, sphere or circular
/// cylinder, recognised to 1e-9 of its size, on which the flank of the tool plays no role
/// or whose slope is constant; else estimated.
///
/// The bound holds for paths with these properties:
/// - Each of at most m pieces keeps the ball in contact with the part, its centre within
///   gamma of the place above the contact. A link that is lifted by less than h counts as
///   a cut.
/// - The path leaves no more than h anywhere, up to an area of zero.
///
/// \param surfaces of the part. Places that the ball does not fit are not contacts; what
///        only such places could cover does not count.
/// \param sides from tool_side_signs, one for each surface.
/// \param problem cutter, tolerances, and which length is bounded.
/// \param options of the estimate.
/// \throws DomainError if there are no surfaces, the numbers of surfaces and sides differ,
///         or the problem or an option is out of range.
/// \throws GeometryError for contacts of a part that is not smooth (G1): at a crease the
///         ball pivots, and contacts do not move. Bounds of tips are not offered there
///         either.
/// \return the same numbers for any number of threads.
PathBound path_bound(std::span<const Surface> surfaces, std::span<const double> sides,
                     const BoundProblem& problem, const EstimateOptions& options = {});

/// The bound by the estimate, also where a closed form is known.
PathBound estimated_bound(std::span<const Surface> surfaces,
                          std::span<const double> sides, const BoundProblem& problem,
                          const EstimateOptions& options = {});

/// The bound with a certificate, also where a closed form is known: the density of the
/// estimate, divided so that its inflow is at most 1 at all contacts and in all directions,
/// which interval arithmetic proves. Rounding is not included. The bound is about 4 % below
/// the estimate, and takes five to ten times as long.
///
/// \throws GeometryError also where there is no certificate for a fifth of the density: where
///         covered sets may have several components, as near other surfaces and seams, where
///         they may end beyond 0.8 widths outside the part, or where the ball may not fit.
PathBound certified_bound(std::span<const Surface> surfaces,
                          std::span<const double> sides, const BoundProblem& problem,
                          const EstimateOptions& options = {});

/// The bound of tips for a mesh. Contacts have none: at a crease the ball pivots, and the
/// contact does not move.
///
/// The bound is for the facets that face the tool, N.z > 0, where the ball comes within half the
/// scallop height and enters the mesh by at most gamma and a twentieth of that height. Parts of
/// facets that are too large to be covered at once have no weight. It holds for paths as for path_bound, with the
/// centre of the ball at most gamma below a place where it touches the mesh. A path that is lifted
/// in concave places may be shorter, by gamma times the angle of its turns there. Where facets meet
/// at less than 30 degrees the mesh stands for a smooth part, whose normals are the means of
/// those around; elsewhere it has a crease, about which the ball pivots.
///
/// Of the saddle, D 15, h 0.5, the bound is 0.2 % below that of the surface with a chord error of
/// 0.001 mm, and 0.4 % with 0.01 mm.
///
/// The grade is Estimated. The cells of the density are triangles, whose last two corners
/// coincide; on a mesh that needs more than 20 000 of them there are none.
/// \param mesh consistently oriented.
/// \param problem its length is Tip.
/// \param options as for path_bound; `grade` is ignored.
/// \throws DomainError if the length is not Tip, or the problem or an option is out of range.
/// \throws GeometryError if no facet faces the tool, or the ball fits nowhere.
/// \return the same numbers for any number of threads.
PathBound mesh_bound(const TriangleMesh& mesh, const BoundProblem& problem,
                     const EstimateOptions& options = {});

/// A lower bound of the numbers of moves and points of a path.
struct PointsBound {
    /// Straight moves at feed. A place that is plunged to and left again counts as one.
    double moves;
    double points;     ///< ends of these moves; retracts and rapids have none
    BoundGrade grade;  ///< Closed: certain up to rounding; Estimated: it may be too large
};

/// How few straight moves and points a path that covers a part can have. Its moves may leave
/// contact, and gouge the part by at most gamma.
///
/// The bound is certain in two cases, as far as the flank of the tool covers no more than
/// the ball:
/// - The part is one plane with a convex outline of straight sides, of least width W. The
///   cover of a move lies in a strip of the width w = 2 sqrt((R + gamma)^2 - (R - h)^2), and
///   strips that cover a convex set are together as wide as it (Bang). So there are at
///   least W / w moves.
/// - The part is one convex sphere of radius rho. The centre of the ball is at most rho + R + h
///   from that of the sphere if it covers anything, and at least rho + R - gamma. A straight
///   line is between both over an angle of 2 beta at most, with cos(beta) = (rho + R -
///   gamma) / (rho + R + h), so that a move covers at most 4 rho^2 beta sin(alpha) + 2 pi
///   rho^2 (1 - cos(alpha)), with alpha the half angle of the disc that the ball covers.
///
/// On other surfaces it is estimated: the integral of one over the greatest area that a move
/// covers at each place, by the curvatures there. A move is then no longer than the diagonal
/// of the part.
/// Source: docs/methods/path-length-bound.md, section 10.
/// \param surfaces, sides, problem as for path_bound; length and most_pieces play no role.
/// \throws DomainError as path_bound.
PointsBound points_bound(std::span<const Surface> surfaces, std::span<const double> sides,
                         const BoundProblem& problem);

/// The estimate, also where the bound is certain.
PointsBound estimated_points_bound(std::span<const Surface> surfaces,
                                   std::span<const double> sides,
                                   const BoundProblem& problem);

}  // namespace endmill
