// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/planning/detail/contact_line.h"

namespace endmill {

/// Centres of a ball that rolls along a pass, u rising.
struct PassSamples {
    double v;
    std::vector<double> u;
    std::vector<Vec3> centres;  ///< mm
};

/// A place up to which a pass brings the surface down to the scallop height.
struct FrontPoint {
    SurfaceContact contact;  ///< on the surface; v is the range's end if all is covered
    double foot_u;           ///< where on the pass the ball is that reaches it
};

/// Where passes must lie so that balls rolling along them, without straight moves between
/// points, leave no more than the scallop height: found at samples of each pass that
/// lie R / 8 apart or less, 32 a patch at least and 1024 at most. Not bounds: `StripCover`
/// tells afterwards.
class CoverFront {
public:
    /// \param marched outlives this. \param scallop_height in mm, below R.
    CoverFront(const MarchedSurface& marched, const BallCutter& cutter,
               double scallop_height, Parameter direction);

    /// Distance in mm of a point from the centres of a pass, and where on it.
    struct Foot {
        double distance;
        double u;
    };

    /// The foot of `point` that lies downhill from the sample number `start`.
    static Foot foot(const PassSamples& pass, const Vec3& point, std::size_t start);

    /// The pass at `v`.
    PassSamples samples(double v) const;

    /// How far beyond its own v the pass alone covers, at each of its samples.
    /// \param guess width in v, to start from.
    std::vector<FrontPoint> front(const PassSamples& pass, double guess) const;

    /// The farthest pass after the one at `v` that reaches back to its front; to a
    /// 5000th of the distance.
    double next_pass(double v, std::span<const FrontPoint> front) const;

private:
    std::vector<double> sample_parameters() const;
    FrontPoint front_at(const PassSamples& pass, std::size_t sample, double guess) const;
    double excess(double v, std::span<const FrontPoint> front) const;
    Vec3 raised(const SurfaceContact& contact) const;

    const MarchedSurface* marched_;
    BallCutter cutter_;
    double scallop_height_;
    Parameter direction_;
    std::vector<double> parameters_;
};

}  // namespace endmill
