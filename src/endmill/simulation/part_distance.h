// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <mutex>
#include <optional>

#include "endmill/mesh/triangle_tree.h"
#include "endmill/simulation/part_cell.h"

namespace endmill {

/// Answers how far a place is from the part: a mesh itself, or a triangulation of the
/// surfaces, which is made when the first question comes. Refers to the charts and their
/// part, which must outlive it. May be asked by any number of threads.
class PartDistance {
public:
    /// \param chord_tolerance of the triangulation, in mm.
    PartDistance(const PartCharts& charts, double chord_tolerance);

    /// Distance in mm of `place` from the part, never less than it is, and more by at most
    /// twice the chord tolerance. Sooner where `hint` is what the question for a place
    /// nearby left there.
    double operator()(const Vec3& place, std::optional<std::size_t>& hint) const;

private:
    void build() const;

    const PartCharts& charts_;
    double chord_tolerance_;
    mutable std::once_flag is_built_;
    mutable TriangleMesh sampled_;
    mutable double chord_error_ = 0;
    mutable std::optional<TriangleTree> tree_;
};

}  // namespace endmill
