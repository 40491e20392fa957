// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/bound/detail/contact_frame.h"
#include "endmill/bound/detail/tool_reach.h"

namespace endmill {

/// A piece of the boundary of the covered set D(x), for the density g = 1.
struct BoundaryFlow {
    std::size_t surface;  ///< number of the surface
    SurfacePoint at;      ///< a point of the piece
    /// The inflow per mm of travel in the tangent direction t is max(0, flow . t), in mm,
    /// where t has components along e1 and e2 of the contact.
    Eigen::Vector2d flow;
};

/// A piece of the covered set D(x).
struct CoveredPiece {
    std::size_t surface;  ///< number of the surface
    SurfacePoint at;      ///< a point of the piece
    double area;          ///< mm^2
};

/// The flow through a piece of boundary.
/// \param frame of the contact.
/// \param problem decides between contact and tip.
/// \param away e: unit, from the half-line to the raised point.
/// \param rate length of the piece divided by |grad Phi|, in mm.
Eigen::Vector2d boundary_flow(const ContactFrame& frame, const BoundProblem& problem,
                              const Vec3& away, double rate);

/// The component of D(x) about the contact, along straight rays of the parameters.
///
/// The rays leave the contact at equal steps of the angle psi of the second-order ellipse
/// of D(x): u and v change by r (cos psi, sin psi) in half axes. With the area element J
/// of the surface and the factor s from (X, Y) to the parameters, the integral over the
/// boundary is
///
///     sum over psi of  step . J s r / (d Phi / d r) . max(0, e . c'),
///
/// which for smooth boundaries converges faster than any power of the step, up to the
/// corner of max. Where the set reaches the border of the surface, the integral ends at
/// the ray that meets both, found by bisection.
class CoverRays {
public:
    /// Solves for the boundary on every ray.
    /// \param part its surfaces must outlive this.
    /// \param problem the tool.
    /// \param frame of the contact.
    /// \param rays number of rays, at least 8.
    CoverRays(const BoundedPart& part, const BoundProblem& problem,
              const ContactFrame& frame, int rays);

    /// Whether every ray met the boundary of D(x) or the border of the surface.
    bool is_complete() const { return is_complete_; }

    /// The greatest length of a ray to the boundary divided by the least one, both in half
    /// axes; 1 if no ray ends at the boundary. It is large where the flank covers a wall.
    double elongation() const;

    /// The boundary inside the surface.
    const std::vector<BoundaryFlow>& boundary() const { return boundary_; }

    /// Whether the rays have passed the parameters `at` of the same surface before they
    /// ended, with a margin of a fifth of the radius.
    bool contains(const SurfacePoint& at) const;

    /// The covered set in pieces, two on each ray, by Gauss's rule in r^2.
    std::vector<CoveredPiece> covered() const;

private:
    // A direction in the parameters, per unit of r.
    struct Ray {
        double u;
        double v;
    };

    // The surface at one point of a ray.
    struct Probe {
        SurfacePoint at;
        double r;
        double excess;  // |y - n|^2 - reach^2, mm^2; n is the nearest point of the tool
        double slope;   // of the excess in r, mm^2
        Vec3 away;      // y - n, mm
        double area;    // J
    };

    // The end of a ray.
    struct End {
        Probe probe;     // at the end, up to the accuracy of the root
        double r;        // after the last step of Newton's method
        bool is_inside;  // whether it is the boundary of D(x), not the border
    };

    double guess_at(std::size_t number) const;
    double angle_of(double number) const;
    Ray ray_at(double angle) const;
    double border(const Ray& ray) const;
    Probe probe(const Ray& ray, double r) const;
    static double change_of_square(const Probe& here);
    End end_of(const Ray& ray, double guess);
    void add_boundary();
    void add_last(std::size_t inside, bool is_ahead);
    void add(const Probe& probe, double step);

    const BoundedPart& part_;
    const BoundProblem& problem_;
    const ContactFrame& frame_;
    ToolReach tool_;
    double scale_;  // units of u and v per unit of X and Y
    std::vector<End> ends_;
    std::vector<BoundaryFlow> boundary_;
    bool is_complete_ = true;
};

}  // namespace endmill
