// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "cli/command.h"
#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/page/page.h"

namespace endmill {

/// A box of all that a page shows.
struct ViewBox {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());  ///< mm
    Vec3 high = -low;                                                    ///< mm

    void add(const Vec3& point);  ///< makes the box hold `point`
    Vec3 centre() const;          ///< mm; the origin for an empty box
    double size() const;          ///< mm, of the diagonal; 0 for an empty box
};

/// What the views of a page share.
struct ViewFrame {
    Vec3 origin{0, 0, 0};  ///< mm; numbers in single precision are relative to it
    double size_mm = 0;    ///< diagonal of all that is shown
    PageNumbers numbers = {};
};

/// The reference of the page to one of its arrays.
Json array_json(const PageArray& array);

/// A mesh: `points` and `triangles`.
Json mesh_json(ViewFrame& frame, const TriangleMesh& mesh, const Vec3& origin);

}  // namespace endmill
