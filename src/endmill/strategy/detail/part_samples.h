// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A contact of the ball at which a strategy lays a pass.
struct PassContact {
    SurfaceContact at;         ///< parameters, point and normal
    int surface;               ///< number of its surface
    std::int32_t near;         ///< number of a sample beside it
    bool is_required = false;  ///< whether a move must begin or end here
};

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

/// A part, sampled by a triangle net with a normal at each sample. The distance between
/// neighbours is limited along the surface, so that a steep wall has as many samples as a
/// level place of the same area. Samples at one place, such as those on both sides of the
/// seam of a closed surface, are twins: they are neighbours, and lines continue from one
/// to the other. An immutable value that refers to the surfaces.
class PartSamples {
public:
    /// \param surfaces     the part; they must outlive this object.
    /// \param sides        from tool_side_signs, one for each surface.
    /// \param spacing      greatest distance of neighbours along the surface, mm.
    /// \param most_samples a denser net throws LimitError.
    /// \throws GeometryError with the place where a surface has no normal.
    PartSamples(std::span<const Surface> surfaces, std::span<const double> sides,
                double spacing, std::size_t most_samples);

    std::size_t size() const { return points_.size(); }            ///< number of samples
    double spacing() const { return spacing_; }                    ///< as given, mm
    const Vec3& point(std::size_t i) const { return points_[i]; }  ///< mm
    const Vec3& normal(std::size_t i) const { return normals_[i]; }  ///< unit
    std::span<const Triangle> triangles() const { return triangles_; }

    /// Numbers of the samples that share an edge or a place with sample i.
    std::span<const std::int32_t> neighbours(std::size_t i) const
    {
        return std::span{neighbours_}.subspan(
            first_neighbour_[i], first_neighbour_[i + 1] - first_neighbour_[i]);
    }

    /// Numbers of the triangles at sample i, rising.
    std::span<const std::int32_t> triangles_at(std::size_t i) const
    {
        return std::span{at_samples_}.subspan(
            first_at_sample_[i], first_at_sample_[i + 1] - first_at_sample_[i]);
    }

    /// The lowest number of the samples at the place of sample i.
    std::int32_t representative(std::size_t i) const { return representatives_[i]; }

    /// Edges on the border of the part: those of one triangle that have no twin.
    std::span<const MeshEdge> border() const { return border_; }

    /// The contact at a place between samples, on the surface itself.
    PassContact contact(const SampleEdge& place) const;

    /// The contact at the parameters `at` of a surface.
    /// \param near number of a sample beside it, on the same surface.
    PassContact contact(const SurfacePoint& at, std::int32_t near) const;

    /// The contact at a share of the way from one contact to another, on the part itself.
    /// \pre is_joined(from, to)
    PassContact between(const PassContact& from, const PassContact& to,
                        double share) const;

    /// Whether the straight way between the parameters of two contacts is short: they lie
    /// on one surface and not on different sides of a seam.
    bool is_joined(const PassContact& from, const PassContact& to) const;

    const SurfacePoint& parameters(std::size_t i) const { return parameters_[i]; }
    int surface(std::size_t i) const { return surface_of_[i]; }

private:
    void add_surface(const Surface& surface, int number);
    std::int32_t add_sample(const SurfacePoint& at, int number);
    void find_twins();
    void require_enough(std::size_t most_samples) const;
    bool refine(std::size_t most_samples);
    void number_by_place();
    void find_neighbours();
    void find_triangles();

    std::span<const Surface> surfaces_;
    std::vector<double> sides_;
    double spacing_;
    std::vector<Vec3> points_;
    std::vector<Vec3> normals_;
    std::vector<SurfacePoint> parameters_;
    std::vector<int> surface_of_;
    std::vector<Triangle> triangles_;
    std::vector<std::int32_t> representatives_;
    std::vector<std::size_t> first_neighbour_;
    std::vector<std::int32_t> neighbours_;
    std::vector<std::size_t> first_at_sample_;
    std::vector<std::int32_t> at_samples_;
    std::vector<MeshEdge> border_;
};

}  // namespace endmill
