// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/cutter/cutter.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A ball and the scallop height that its passes may leave.
struct ScallopRequest {
    BallCutter ball;
    double scallop_height;  ///< mm
};

/// Travel in mm of idealised passes whose number need not be whole: the integral of 1 /
/// interval over the surface, with the path interval for the curvature across the feed.
/// The travel is measured along contacts, without links.
struct ContinuumTravel {
    double iso;  ///< iso-parametric passes, each as near as its narrowest sample requires
    double local;  ///< the same feed directions, each sample with its own interval
    /// As `local`, each sample with its best of 36 feed directions.
    double best_direction;
};

/// Integrates over `samples` by `samples` samples of the parameter domain.
/// \param direction of the iso-parametric passes.
/// \pre the ball fits everywhere on the surface.
/// \throws DomainError as `path_interval`.
ContinuumTravel continuum_travel(const Surface& surface, const ScallopRequest& request,
                                 Parameter direction, int samples);

/// The idealised travel along parallel drive planes, over the directions of the feed. The
/// distance of neighbouring planes is the one that the narrowest sample between them
/// requires.
struct PlanarExtremes {
    double least;         ///< mm
    double least_at_deg;  ///< direction of the feed with the least travel, from +x
    double greatest;      ///< mm
};

/// Tries feeds at the multiples of 180 degrees / `directions` in the xy plane.
/// \pre and \throws as `continuum_travel`.
PlanarExtremes planar_extremes(const Surface& surface, const ScallopRequest& request,
                               int directions, int samples);

}  // namespace endmill
