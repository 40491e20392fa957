// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "endmill/cutter/cutting_body.h"
#include "endmill/machine/tool_motion.h"

namespace endmill {

/// A straight line in the part as seen from a moving tool. Places on it are given by their
/// signed distance s from its start.
///
/// Seen from the tool, a place of the part moves on a curve. Let F(s) be the least signed
/// distance from the cutter on the straight line between the ends of this curve, and e(s)
/// the error of that line. Where F <= -e the place is removed for certain, where F > e it
/// is not.
/// Source: docs/methods/five-axis-removal.md, sections 2 and 3.
class RayOnMotion {
public:
    /// A distance F, and bounds that hold for it.
    struct Distance {
        CuttingBody::Least least;  ///< F, with the pose where it is attained
        double error;              ///< e, mm

        double gap() const { return least.lower - error; }  ///< above 0: not removed
        /// For certain, and by more than a margin in mm.
        bool is_removed(double margin = 0) const
        {
            return least.value <= -error - margin;
        }
    };

    /// A place on the line.
    struct Place {
        double s;           ///< mm
        Distance distance;  ///< there
    };

    /// Motion and body must outlive the object.
    /// \param start mm. \param direction unit.
    RayOnMotion(const Vec3& start, const Vec3& direction, const ToolMotion& motion,
                const CuttingBody& body);

    /// Returns the distance at s.
    /// \param enough mm; a larger gap may be stated too small, but above this.
    Distance distance(double s,
                      double enough = std::numeric_limits<double>::infinity()) const;

    /// Returns the error e at s, mm. It is convex in s.
    double error(double s) const;

    /// The error at both ends of a stretch, and all between, with the largest change of it
    /// `beside` mm away from the line.
    double largest_error(const CuttingBody::Stretch& on, double beside) const;

    /// Uses an upper bound of the error instead, for all places that are asked for.
    /// \param accuracy mm, of the distance at which a search ends.
    void set_error(double error, double accuracy)
    {
        known_error_ = error;
        accuracy_ = accuracy;
    }

    /// Returns the rate at which F changes along the line.
    double rate(const CuttingBody::Least& least) const;

    /// Returns the distance from the cutter at s, in the straight approximation of the
    /// pose at u.
    double at_pose(double s, double u) const;

    /// Returns a stretch between two places outside which nothing is removed. It takes one
    /// chord of the cutter and is about as much too long as the motion is wide.
    /// \param beside mm; the same holds for parallel lines that start beside this one,
    ///               across it.
    /// \return nothing if the motion removes nothing between them.
    std::optional<CuttingBody::Stretch> near_stretch(double from, double to,
                                                     double beside = 0) const;

    /// Returns how far, at most, a place of the stretch is from the middle of its ends as
    /// seen from the tool, at any pose; mm. \param error largest error on the stretch.
    /// \param beside as above.
    double spread(const CuttingBody::Stretch& on, double error, double beside) const;

    /// Returns the parallel line whose start is moved, across the direction.
    /// \param seen_from_start the movement as seen from the tool at u = 0.
    /// \param seen_from_end the same at u = 1.
    RayOnMotion moved(const Vec3& movement, const Vec3& seen_from_start,
                      const Vec3& seen_from_end) const;

    /// Start and direction of the line, as seen from the tool: the middle of both ends of
    /// the motion.
    Vec3 middle_start() const { return (from_ + to_) / 2; }
    Vec3 middle_direction() const { return (along_from_ + along_to_) / 2; }  ///< as start

    /// Returns a place such that nothing from s up to it is removed, as close as possible
    /// to the first place that may be removed.
    /// \return nothing if it is not below `most`.
    std::optional<Place> first_entry(double s, double most) const;

    /// Returns the first place found from a place up that is removed for certain. Grazing
    /// lines may be missed.
    /// \param margin mm, by which F must be less than needed.
    /// \return nothing if none is found up to `most`.
    std::optional<Place> sure_entry(const Place& from, double most,
                                    double margin = 0) const;

    /// The place at s.
    Place place(double s) const { return {s, distance(s)}; }

    /// Returns the angle by which the direction turns as seen from the tool, at most; rad.
    double turn() const { return motion_->turn(); }

    /// The line in the opposite direction, from the same start.
    RayOnMotion reversed() const;

private:
    static constexpr double finest_accuracy = 1e-8;  // mm

    Vec3 start_;
    Vec3 direction_;
    const ToolMotion* motion_;
    const CuttingBody* body_;
    Vec3 from_;        // start, seen from the tool at u = 0
    Vec3 to_;          // the same at u = 1
    Vec3 along_from_;  // direction, seen from the tool at u = 0
    Vec3 along_to_;
    std::optional<double> known_error_ = {};
    double accuracy_ = finest_accuracy;
};

}  // namespace endmill
