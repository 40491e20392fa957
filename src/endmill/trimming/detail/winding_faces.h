// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace endmill {

/// A step over an edge of an arrangement, from one face into the next. Faces are numbers.
struct FaceStep {
    std::int32_t from;  ///< the face that it leaves
    std::int32_t to;    ///< the face that it enters
    std::int32_t fall;  ///< decrease of the index by the step
};

/// The rule by which method `winding` keeps faces: those of index >= 0.
struct FaceRule {
    std::int32_t count;          ///< number of faces
    std::int32_t outer;          ///< the unbounded face
    std::int32_t index_outside;  ///< index of the unbounded face
    /// only faces joined to `outer` through kept ones; true if there are open curves
    bool must_be_joined_to_outer;
};

/// Whether each face is kept. A face that no step leads to has index 0.
/// \param steps both steps over each edge. The indices must agree on all paths to a face.
/// \param rule the faces and the rule.
std::vector<bool> kept_faces(std::span<const FaceStep> steps, const FaceRule& rule);

}  // namespace endmill
