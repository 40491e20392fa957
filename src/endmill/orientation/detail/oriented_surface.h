// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "endmill/orientation/detail/oriented_part.h"
#include "endmill/surface/surface.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// The passes along the parameter lines of one surface.
class OrientedSurface : public OrientedPart {
public:
    /// \param surface must outlive the object, as cutter and options.
    /// \param side from tool_side_signs. \param number of the surface, from 0.
    OrientedSurface(const Surface& surface, double side, std::size_t number,
                    const Cutter& cutter, const OrientedOptions& options);

    std::vector<PassLine> passes() const override;
    PassPlace place(double along, const PassLine& line) const override;
    std::string name_of(const PassPlace& place) const override;

private:
    Parameter across() const
    {
        return options().along == Parameter::U ? Parameter::V : Parameter::U;
    }
    std::vector<double> fixed_rows(const PassLine& line) const override;
    double needed_strip(const PassPlace& place, const PassLine& line) const override;
    std::vector<double> examined() const;
    double reach(double across, const std::vector<double>& places) const;

    const Surface& surface_;
    double side_;
    std::size_t number_;
};

}  // namespace endmill
