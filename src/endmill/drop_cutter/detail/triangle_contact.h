// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

#include "endmill/core/vec.h"

namespace endmill {

/// The part of a triangle that a cutter touches.
enum class TouchKind : std::uint8_t { Facet, Edge, Vertex };

/// The contact of a cutter that was lowered along -z onto a triangle.
struct TriangleContact {
    /// mm; minus infinity: no contact
    double tip_z = -std::numeric_limits<double>::infinity();
    /// mm, the contact point; one of them if there are several.
    Vec3 point = Vec3::Zero();
    /// What the cutter touches.
    TouchKind kind = TouchKind::Facet;
};

}  // namespace endmill
