// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/orientation/detail/mesh_shape.h"
#include "endmill/orientation/detail/oriented_part.h"
#include "endmill/orientation/detail/tool_clearance.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// Contacts of a pass on a mesh, in the order of cutting.
using ContactCurve = std::vector<CutterContact>;

/// The curves on which a path is in contact with the part without a break, in its order.
std::vector<ContactCurve> contact_curves(const ToolPath& path);

/// The passes along curves of contacts on a mesh.
///
/// Between two contacts the normal turns evenly. The centre of a ball moves straight, as it does
/// on the path that has the contacts. The contact of another cutter is the place of the mesh
/// that is nearest to the straight line between both.
class OrientedContacts : public OrientedPart {
public:
    /// \param shape  of the part; it must outlive the object, as cutter and options.
    /// \param curves each with a contact.
    /// \param height scallop height in mm that a ball of the same radius leaves between the
    ///        curves.
    OrientedContacts(const MeshShape& shape, std::span<const ContactCurve> curves,
                     double height, const Cutter& cutter, const OrientedOptions& options);

    std::vector<PassLine> passes() const override;
    PassPlace place(double along, const PassLine& line) const override;
    std::string name_of(const PassPlace& place) const override;

    /// A place of a pass with a feed, both near to the given ones.
    PassPlace place_at(const CutterContact& contact, const Vec3& feed) const;

private:
    struct CurvePoint {
        CutterContact contact;
        Vec3 centre;   // of the ball, mm
        Vec3 feed;     // unit
        double along;  // way of the centre from the start of the curve, mm
    };
    using Curve = std::vector<CurvePoint>;

    std::vector<double> fixed_rows(const PassLine& line) const override;
    double needed_strip(const PassPlace& place, const PassLine& line) const override;
    Curve curve_of(const ContactCurve& contacts) const;
    const Curve& curve(const PassLine& line) const
    {
        return curves_[static_cast<std::size_t>(line.across)];
    }
    CutterContact contact_between(const CurvePoint& from, const CurvePoint& to,
                                  double share) const;

    const MeshShape& shape_;
    double height_;
    std::vector<Curve> curves_;
};

/// A mesh on which passes are laid.
struct ContactTask {
    const MeshShape& shape;          ///< of the whole part
    const ToolClearance& clearance;  ///< of the whole part
    const Cutter& cutter;            ///< of the tool
    const OrientedOptions& options;  ///< of the path
};

/// The passes on a mesh, and how many the strategy laid. A curve may have several, as the tool
/// stays in contact between them.
struct LaidContacts {
    OrientedContacts part;
    std::size_t passes;
};

/// Lays passes on a mesh by the strategy of the options, for a ball of the cutter's radius.
///
/// Another cutter covers wider strips than the ball. So the passes are laid for the scallop
/// height at which the strips of the ball are nowhere wider than those of the cutter for the
/// asked height. They are continued on the mesh at both ends by the half strip of the ball,
/// because the ball covers as much ahead of its contact, and the other cutter does not.
/// Source: docs/methods/five-axis-planning.md, section 4.
/// \throws GeometryError, LimitError as covering_by_strategy.
LaidContacts oriented_contacts(const ContactTask& task);

}  // namespace endmill
