// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/planning/detail/verified_pass.h"
#include "endmill/strategy/detail/ball_on_mesh.h"
#include "endmill/strategy/detail/mesh_net.h"
#include "endmill/strategy/detail/part_samples.h"
#include "endmill/strategy/protected_part.h"
#include "endmill/surface/part.h"

namespace endmill {

/// What tests of moves keep between calls to save time. It never changes an answer. Each
/// thread has its own.
struct MoveTestState {
    FinerPieces finer;  ///< pieces of surfaces
};

/// Width in mm of the strip that a pass of a ball leaves below `height` mm on a plane.
inline double strip_width(const BallCutter& cutter, double height)
{
    return 2 * std::sqrt(height * (2 * cutter.radius() - height));
}

/// The length of passes for one height, from their length for another height: the same area
/// in strips of another width.
/// \param travel of the passes for the height `from`, mm.
inline double scaled_travel(double travel, const BallCutter& cutter, double from,
                            double to)
{
    return travel * strip_width(cutter, from) / strip_width(cutter, to);
}

/// What a path over a part must keep.
struct CoverLimits {
    double tolerance;  ///< greatest depth of a gouge, mm; above 0 and below the radius
    double scallop_height;  ///< greatest height of remaining stock, mm
};

/// The part for which a strategy plans: it gives samples on which passes are laid, and
/// tests the moves of the ball. An immutable value that refers to the part; all threads may
/// use it.
class CoveredPart {
public:
    /// \param part   the part; it must outlive this object.
    /// \param cutter the ball, held along +z.
    /// \param limits see there.
    /// \param guard  a part that the ball must not enter, for the same ball; empty: none.
    /// \throws GeometryError with the place where N . z <= 0 or where there is no normal; for
    ///         a mesh only if no facet faces the tool.
    CoveredPart(const Part& part, const BallCutter& cutter, const CoverLimits& limits,
                std::shared_ptr<const ProtectedPart> guard = {});

    /// Samples of the part. Places of a mesh, or beside a protected part, that the ball cannot
    /// come within half the scallop height of need not be covered.
    /// \throws GeometryError if the protected part bars all of it.
    /// \param spacing      greatest distance of neighbours along the part, mm.
    /// \param most_samples a denser net throws LimitError.
    PartSamples samples(double spacing, std::size_t most_samples) const;

    /// Whether a straight move is proved to enter the part nowhere by more than the
    /// tolerance, and the protected part nowhere at all.
    /// \param from, to centres of the ball, mm.
    /// \param state    of this thread.
    bool is_clear(const Vec3& from, const Vec3& to, MoveTestState& state) const;

    /// Whether the contacts of samples are points of the part, as they are on surfaces that
    /// no protected part holds them off.
    bool has_contacts_on_part() const { return !guard_ && !surfaces().empty(); }

    /// The height in mm at which strategies aim so that no more than `height` mm is left. On a
    /// mesh it is less, because places near its edges are not raised along the normals of
    /// their facets.
    double aimed_height(double height) const;

    /// The area by the first net of each patch, or by the mesh, mm^2. Places that a protected
    /// part bars count.
    double rough_area(std::size_t most_samples) const;

    const BallCutter& cutter() const { return cutter_; }  ///< the ball
    double tolerance() const { return tolerance_; }  ///< greatest depth of a gouge, mm
    std::span<const Surface> surfaces() const;  ///< of the part; none if it is a mesh

private:
    struct CoveredSurfaces {
        const std::vector<Surface>* surfaces;
        std::vector<double> sides;
        ClearMoves clear;
    };
    struct CoveredMesh {
        MeshNet net;
        std::shared_ptr<const BallOnMesh> ball;
    };
    using Source = std::variant<CoveredSurfaces, CoveredMesh>;

    PartSamples samples(const PartSampling& sampling, std::size_t most_samples) const;
    static Source source_of(const Part& part, const BallCutter& cutter,
                            const CoverLimits& limits);

    BallCutter cutter_;
    double tolerance_;
    double accessible_distance_;
    std::shared_ptr<const ProtectedPart> guard_;
    Source source_;
};

/// Refuses a part of so large an area that samples at this distance would be too many.
/// \throws LimitError. A part that passes may still need too many.
void require_possible(const CoveredPart& part, double spacing, std::size_t most_samples);

/// Samples for trials, and the scallop height for which they are dense enough.
struct FewSamples {
    PartSamples samples;
    double height;  ///< mm
};

/// How many samples trials have.
struct FewSamplesLimits {
    double across;             ///< samples across a strip
    std::size_t most_samples;  ///< that the part may have at the wanted height
};

/// Few samples of a part. A low height is doubled until few suffice, at most to a fifth of
/// the radius. At that height the part may have more of them than wanted.
/// \param limits       number of samples.
/// \param height       wanted scallop height, mm.
/// \param most_samples a part that needs more throws LimitError.
FewSamples few_samples(const CoveredPart& part, const FewSamplesLimits& limits,
                       double height, std::size_t most_samples);

}  // namespace endmill
