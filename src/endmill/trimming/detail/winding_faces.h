// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace endmill {

/// A step from a face of an arrangement over an edge into the next, faces by number.
struct FaceStep {
    std::int32_t from;
    std::int32_t to;
    std::int32_t fall;  ///< by how much the index falls on the way
};

/// Which faces method `winding` keeps: those of index >= 0.
struct FaceRule {
    std::int32_t count;            ///< of all faces
    std::int32_t outer;            ///< the unbounded one
    std::int32_t index_outside;    ///< its index
    bool must_be_joined_to_outer;  ///< through such faces; so where there are open curves
};

/// Whether each face is kept. A face that no step leads to has index 0.
/// \param steps both ways over each edge, so that indices agree on all ways to a face.
std::vector<bool> kept_faces(std::span<const FaceStep> steps, const FaceRule& rule);

}  // namespace endmill
