// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/offset/section_curve.h"

namespace endmill {

/// The upper envelope of sections as a function of s.
class EnvelopeHeight {
public:
    /// \throws DomainError, LimitError as envelope_trimming.
    explicit EnvelopeHeight(std::span<const SectionCurve> curves);

    /// z in mm at `s`, on a vertical step its upper end; nothing where no curve is.
    std::optional<double> at(double s) const;

private:
    struct Point {
        SectionPoint at;
        bool is_joined;  ///< to the one before
    };

    std::vector<Point> points_;  // s rising
};

}  // namespace endmill
