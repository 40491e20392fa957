// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace endmill {

/// An end mill with a rounded corner: a flat bottom of radius R - r, a quarter torus of
/// radius r around it, and a cylinder of radius R above. r = R is the ball, r = 0 the flat
/// end mill. An immutable value. Shank and holder are no part of it.
class Cutter {
public:
    /// \param radius R in mm. \param corner_radius r in mm.
    /// \throws DomainError unless 0 < R is finite and 0 <= r <= R.
    Cutter(double radius, double corner_radius);

    static Cutter ball(double radius) { return {radius, radius}; }  ///< mm
    static Cutter flat(double radius) { return {radius, 0}; }       ///< mm

    double radius() const { return radius_; }                        ///< R, mm
    double corner_radius() const { return corner_radius_; }          ///< r, mm
    double flat_radius() const { return radius_ - corner_radius_; }  ///< R - r, mm
    bool is_ball() const { return corner_radius_ == radius_; }       ///< r = R
    bool is_flat() const { return corner_radius_ == 0; }             ///< r = 0

    /// Height in mm above the tip of the cutter's surface at `distance` from the axis:
    /// 0 up to R - r, then r - sqrt(r^2 - (distance - R + r)^2); infinite beyond R.
    /// Source: spec of the removal, section 1; a quarter circle.
    /// \pre distance >= 0. Relative error below 1e-15, also where the height is small.
    double profile(double distance) const;

    /// Whether both have the same radii.
    friend bool operator==(const Cutter&, const Cutter&) = default;

private:
    double radius_;
    double corner_radius_;
};

/// The word for `cutter` on the command line and in summaries: "ball:DIAMETER",
/// "flat:DIAMETER" or "bull:DIAMETER:CORNER_RADIUS", in mm.
std::string cutter_word(const Cutter& cutter);

/// The cutter that `word` spells.
/// \return nothing if it is no such word, or its numbers are out of range.
std::optional<Cutter> cutter_from_word(std::string_view word);

/// For messages: what is expected where `word` stands, from which `cutter_from_word` makes
/// no cutter. It is the number that is out of range, or how such a word is spelled.
std::string expected_cutter(std::string_view word);

}  // namespace endmill
