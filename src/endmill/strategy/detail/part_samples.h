// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/path/tool_path.h"
#include "endmill/strategy/detail/ball_on_mesh.h"
#include "endmill/strategy/detail/mesh_net.h"
#include "endmill/strategy/detail/sample_net.h"
#include "endmill/strategy/protected_part.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A contact of the ball at which a strategy lays a pass.
struct PassContact {
    /// Parameters, point and normal; on a mesh u and v are x and y of the point, mm.
    SurfaceContact at;
    int surface;               ///< number of its surface; 0 on a mesh
    std::int32_t near;         ///< number of a sample beside it
    bool is_required = false;  ///< whether a move must begin or end here
};

/// Whether the ball has the same place at both contacts. At a corner of a mesh the ball can
/// touch one point in many places.
inline bool is_same_place(const PassContact& a, const PassContact& b)
{
    return a.at.contact.point == b.at.contact.point &&
           a.at.contact.normal == b.at.contact.normal;
}

/// A pass of a strategy, before it is divided into moves.
struct LaidPass {
    std::vector<PassContact> contacts;  ///< in order, at least one
    bool is_closed = false;             ///< whether it ends where it begins
};

/// A place between two neighbouring samples.
struct SampleEdge {
    std::int32_t from;  ///< number of a sample
    std::int32_t to;    ///< number of a neighbour, or the same number
    double share;       ///< 0 at `from`, 1 at `to`
};

/// How a part is sampled.
struct PartSampling {
    double spacing;  ///< greatest distance of neighbours, mm
    /// A place of a mesh, or beside a protected part, need not be covered if the ball cannot
    /// come this near to it, mm.
    double accessible_distance = 0;
    /// A part that the ball must not enter; empty: none.
    std::shared_ptr<const ProtectedPart> guard = {};
};

/// \throws LimitError with a message that says how many samples a part would need, and how
///         many are allowed.
[[noreturn]] void throw_too_many_samples(double needed, std::size_t most_samples);

/// A part, sampled by a triangle net with a normal at each sample. The distance between
/// neighbours is limited along the surface, so that a steep wall has as many samples as a
/// level place of the same area. Samples at one place, such as those on both sides of the
/// seam of a closed surface, are twins: they are neighbours, and lines continue from one
/// to the other. An immutable value that refers to the surfaces or the mesh.
class PartSamples {
public:
    /// \param surfaces     the part; they must outlive this object.
    /// \param sides        from tool_side_signs, one for each surface.
    /// \param spacing      greatest distance of neighbours along the surface, mm.
    /// \param most_samples a denser net throws LimitError.
    /// \throws GeometryError with the place where a surface has no normal.
    PartSamples(std::span<const Surface> surfaces, std::span<const double> sides,
                double spacing, std::size_t most_samples);

    /// The same beside a protected part. Contacts are held off it by at most the accessible
    /// distance.
    PartSamples(std::span<const Surface> surfaces, std::span<const double> sides,
                const PartSampling& sampling, std::size_t most_samples);

    /// Samples of a mesh. Contacts are where the ball does not enter it.
    /// \param net          from mesh_net.
    /// \param ball         on the same mesh.
    /// \param sampling     see there.
    /// \param most_samples a denser net throws LimitError.
    PartSamples(const MeshNet& net, std::shared_ptr<const BallOnMesh> ball,
                const PartSampling& sampling, std::size_t most_samples);

    std::size_t size() const { return points_.size(); }            ///< number of samples
    double spacing() const { return spacing_; }                    ///< as given, mm
    const Vec3& point(std::size_t i) const { return points_[i]; }  ///< mm
    const Vec3& normal(std::size_t i) const { return normals_[i]; }  ///< unit
    std::span<const Triangle> triangles() const { return triangles_; }

    /// Centre of a ball of `radius` mm at sample i, mm. On a mesh, or beside a protected part,
    /// it is the centre of the ball for which the part was sampled, moved to where it does
    /// not enter the mesh or the protected part.
    Vec3 centre(std::size_t i, double radius) const
    {
        const Vec3& point = seats_.empty() ? points_[i] : seats_[i].point;
        const Vec3& normal = seats_.empty() ? normals_[i] : seats_[i].normal;
        return point + radius * normal;
    }

    /// Whether sample i must be covered. Samples that the ball cannot reach because of the
    /// mesh or a protected part need not be.
    bool is_wanted(std::size_t i) const { return is_wanted_.empty() || is_wanted_[i]; }

    /// Whether the part is a mesh.
    bool is_mesh() const { return std::holds_alternative<SampledMesh>(source_); }

    /// Area in mm^2 of the triangles with a sample that need not be covered.
    double unwanted_area() const;

    /// Numbers of the samples that share an edge or a place with sample i.
    std::span<const std::int32_t> neighbours(std::size_t i) const
    {
        return neighbours_.of(i);
    }

    /// Numbers of the triangles at sample i, rising.
    std::span<const std::int32_t> triangles_at(std::size_t i) const
    {
        return at_samples_.of(i);
    }

    /// The lowest number of the samples at the place of sample i.
    std::int32_t representative(std::size_t i) const { return representatives_[i]; }

    /// Edges on the border of the part: those of one triangle that have no twin.
    std::span<const MeshEdge> border() const { return border_; }

    /// The contact at a place between samples, on the surface itself. On a mesh it is the
    /// nearest contact at which the ball does not enter the mesh.
    PassContact contact(const SampleEdge& place) const;

    /// Point and normal of the part at sample i. On a mesh the ball may enter it there.
    CutterContact place_at(std::size_t i) const { return {points_[i], normals_[i]}; }

    /// Point and normal of the part between two places in one triangle, by the places alone.
    /// It is close to the part and much quicker than a contact on it. \see near_contact
    CutterContact near_place(const CutterContact& from, const CutterContact& to,
                             double share) const;
    CutterContact near_place(const SampleEdge& place) const;

    /// Centre of a ball of `radius` mm at a place between samples, mm, to the accuracy of
    /// near_place. \see centre
    Vec3 near_centre(const SampleEdge& place, double radius) const
    {
        if (is_mesh() || is_held_off(place.from) || is_held_off(place.to))
            return (1 - place.share) * centre(place.from, radius) +
                   place.share * centre(place.to, radius);
        const CutterContact at = near_place(place);
        return at.point + radius * at.normal;
    }

    /// The contact at the parameters `at` of a surface.
    /// \pre the part is not a mesh.
    /// \param near number of a sample beside it, on the same surface.
    PassContact contact(const SurfacePoint& at, std::int32_t near) const;

    /// The contact at a share of the way from one contact to another, on the part itself.
    /// \pre is_joined(from, to)
    PassContact between(const PassContact& from, const PassContact& to,
                        double share) const;

    /// Whether the way between two contacts is short: they lie on one surface or mesh and
    /// not on different sides of a seam.
    bool is_joined(const PassContact& from, const PassContact& to) const;

    const SurfacePoint& parameters(std::size_t i) const { return parameters_[i]; }
    int surface(std::size_t i) const { return surface_of_[i]; }

private:
    struct SampledSurfaces {
        std::span<const Surface> surfaces;
        std::vector<double> sides;
    };
    struct SampledMesh {
        std::shared_ptr<const BallOnMesh> ball;
        bool is_coarser;  // whether the net lies beside the mesh between its points
    };

    void add_surface(const Surface& surface, int number);
    std::int32_t add_sample(const SurfacePoint& at, int number);
    std::int32_t add_sample(const Vec3& point, const Vec3& normal);
    std::int32_t add_middle(std::int32_t a, std::int32_t b, double share);
    void find_twins(std::span<const Surface> surfaces);
    void require_enough() const;
    void refine();
    std::vector<MeshEdge> longest_edges() const;
    bool divide_edges(
        std::span<const MeshEdge> edges,
        const std::function<std::int32_t(std::int32_t a, std::int32_t b)>& add_between);
    CutterContact on_surface(const SurfacePoint& at, int number) const;
    std::int32_t add_at(std::int32_t a, std::int32_t b, double share);
    CutterContact exact_place(const SampleEdge& at) const;
    bool is_reached(const CutterContact& place) const;
    bool is_held_off(std::size_t i) const
    {
        return !seats_.empty() && seats_[i].point != points_[i];
    }
    CutterContact seated(const CutterContact& place) const;
    void find_accessible();
    void number_by_place();
    void join();
    void seat();
    static CutterContact mesh_place(const SampledMesh& mesh, const CutterContact& from,
                                    const CutterContact& to, double share);
    CutterContact mesh_place(const SampledMesh& mesh, const SampleEdge& at) const;

    std::variant<SampledSurfaces, SampledMesh> source_;
    double spacing_;
    double accessible_distance_;
    std::shared_ptr<const ProtectedPart> guard_;
    std::size_t most_samples_;
    std::vector<Vec3> points_;
    std::vector<Vec3> normals_;
    // contacts of the ball; of a mesh, and where a protected part is near
    std::vector<CutterContact> seats_;
    std::vector<SurfacePoint> parameters_;
    std::vector<int> surface_of_;
    std::vector<bool> is_wanted_;  // empty: all are
    std::vector<Triangle> triangles_;
    std::vector<std::int32_t> representatives_;
    SampleLists neighbours_;
    SampleLists at_samples_;
    std::vector<MeshEdge> border_;
};

}  // namespace endmill
