// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/planning/detail/contact_line.h"

namespace endmill {

/// Sampled centres of a ball that rolls along a pass.
struct PassSamples {
    double v;                   ///< parameter of the pass
    std::vector<double> u;      ///< parameters of the samples, rising
    std::vector<Vec3> centres;  ///< of the ball at the samples, mm
};

/// The farthest point beside a pass that the pass alone cuts down to the scallop height.
struct FrontPoint {
    /// The point; v is the end of the range if the pass cuts all.
    SurfaceContact contact;
    double foot_u;  ///< u of the place on the pass from which the ball reaches it
};

/// Computes the distance between passes such that balls which roll along them leave no
/// more than the scallop height.
///
/// A surface point r is cut down to the height h if r + h N lies within R of a ball
/// centre. The points that a pass cuts in this sense end at its *front*. The next pass
/// lies as far away as possible with its ball still reaching every point of that front.
/// Balls that roll at a height t above the surface cut down to h + t instead.
///
/// Passes are sampled at most R / 8 apart, with 32 to 1024 samples a patch. The results
/// are therefore not bounds; `StripCover` checks them afterwards.
class CoverFront {
public:
    /// \param marched        the surface; must outlive this.
    /// \param cutter         the ball, radius R.
    /// \param scallop_height h in mm, below R.
    /// \param direction      for the parameters in an error message.
    /// \param offset         t in mm: the balls roll at this height above the surface.
    CoverFront(const MarchedSurface& marched, const BallCutter& cutter,
               double scallop_height, Parameter direction, double offset = 0);

    /// The point on the centre line of a pass that is nearest to a given point.
    struct Foot {
        double distance;  ///< from the given point, mm
        double u;         ///< its parameter
    };

    /// The foot of `point`: the local minimum of the distance next to a sample.
    /// \param pass  samples of the pass.
    /// \param point in mm.
    /// \param start number of the sample from which the search descends.
    static Foot foot(const PassSamples& pass, const Vec3& point, std::size_t start);

    /// Samples of the pass at `v`.
    PassSamples samples(double v) const;

    /// The front of a pass, at each of its samples.
    /// \param pass  samples of the pass.
    /// \param guess first step of the search in v.
    std::vector<FrontPoint> front(const PassSamples& pass, double guess) const;

    /// Parameter of the farthest pass that reaches back to `front`, to a 5000th of the
    /// distance between the passes.
    /// \param v     parameter of the pass of the front.
    /// \param front from `front`.
    double next_pass(double v, std::span<const FrontPoint> front) const;

private:
    std::vector<double> sample_parameters() const;
    FrontPoint front_at(const PassSamples& pass, std::size_t sample, double guess) const;
    double excess(double v, std::span<const FrontPoint> front) const;
    Vec3 raised(const SurfaceContact& contact) const;

    const MarchedSurface* marched_;
    BallCutter cutter_;
    double height_;  // of the points that the balls reach
    double scallop_height_;
    double offset_;
    Parameter direction_;
    std::vector<double> parameters_;
};

}  // namespace endmill
