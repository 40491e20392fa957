// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "endmill/offset/section_curve.h"
#include "endmill/trimming/trimming.h"

namespace endmill {

/// The curves of a plane that a method must trim together.
enum class CurveCoupling {
    None,         ///< each open curve by itself, closed ones with all that overlap them
    Overlapping,  ///< curves whose ranges of s overlap
    Plane         ///< all curves of the plane
};

/// A method that removes the loops from the curves of one plane.
struct TrimmingMethod {
    std::string_view name;   ///< the word for the command line
    std::string_view title;  ///< a short description for readers
    bool has_detection;      ///< whether the method uses TrimmingOptions::detection
    /// Trims the curves of one plane.
    /// \pre the curves satisfy the rules of SectionCurve, are finite, and are ordered by
    ///     their smallest s.
    /// \throws DomainError if an option of the method is outside its domain.
    Trimmed (*trim)(std::span<const SectionCurve> curves, const TrimmingOptions& options);
    /// Decides how the curves of a plane are divided among processes.
    CurveCoupling coupling = CurveCoupling::Plane;
};

/// All methods, in the order in which tables show them. A new method is one line in the
/// table of trimming_methods.cpp.
std::span<const TrimmingMethod> trimming_methods();

}  // namespace endmill
