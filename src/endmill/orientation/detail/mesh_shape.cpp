// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/mesh_shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/strategy/detail/mesh_net.h"

namespace endmill {
namespace {

using Corners = std::array<Vec3, 3>;

Vec3 facet_normal(const Corners& corners)
{
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
}

double facet_area(const Corners& corners)
{
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2;
}

double angle_at(const Corners& corners, std::size_t k)
{
    const Vec3 a = corners[(k + 1) % 3] - corners[k];
    const Vec3 b = corners[(k + 2) % 3] - corners[k];
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Corners of facets that are joined to sets.
class JoinedCorners {
public:
    explicit JoinedCorners(std::size_t count) : parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    std::size_t root(std::size_t k)
    {
        while (parent_[k] != k) {
            parent_[k] = parent_[parent_[k]];
            k = parent_[k];
        }
        return k;
    }

    void join(std::size_t a, std::size_t b)
    {
        const std::size_t root_a = root(a);
        const std::size_t root_b = root(b);
        parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    }

private:
    std::vector<std::size_t> parent_;
};

// An edge of a facet, from its corner `corner` to the next one.
struct FacetEdge {
    MeshEdge ends;  // the lower number first
    std::size_t facet;
    std::size_t corner;
};

std::vector<FacetEdge> sorted_edges(const TriangleMesh& mesh)
{
    std::vector<FacetEdge> edges;
    edges.reserve(3 * mesh.triangles().size());
    for (std::size_t facet = 0; facet < mesh.triangles().size(); ++facet)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(mesh.triangles()[facet][k],
                                                 mesh.triangles()[facet][(k + 1) % 3]);
            edges.push_back({{low, high}, facet, k});
        }
    std::ranges::sort(edges, [](const FacetEdge& a, const FacetEdge& b) {
        return a.ends != b.ends ? a.ends < b.ends : a.facet < b.facet;
    });
    return edges;
}

// The tensor that changes the corners' normals along the edges of a facet.
Eigen::Matrix3d facet_tensor(const Corners& corners, const std::array<Vec3, 3>& normals)
{
    const Vec3 first = (corners[1] - corners[0]).normalized();
    Eigen::Matrix<double, 3, 2> basis;
    basis << first, facet_normal(corners).cross(first);
    Eigen::Matrix<double, 6, 3> system;
    Eigen::Matrix<double, 6, 1> change;
    for (Eigen::Index k = 0; k < 3; ++k) {
        const auto from = static_cast<std::size_t>(k);
        const std::size_t to = (from + 1) % 3;
        const Eigen::Vector2d edge = basis.transpose() * (corners[to] - corners[from]);
        system.row(2 * k) << edge.x(), edge.y(), 0;
        system.row(2 * k + 1) << 0, edge.x(), edge.y();
        change.segment<2>(2 * k) = basis.transpose() * (normals[to] - normals[from]);
    }
    const Eigen::Vector3d found = system.colPivHouseholderQr().solve(change);
    Eigen::Matrix2d tensor;
    tensor << found[0], found[1], found[1], found[2];
    if (!tensor.allFinite())
        return Eigen::Matrix3d::Zero();
    return basis * tensor * basis.transpose();
}

// Barycentric coordinates of a point in the plane of a facet.
Vec3 shares_of(const Corners& corners, const Vec3& point)
{
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double square = normal.squaredNorm();
    Vec3 shares{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = corners[(k + 1) % 3];
        const Vec3& b = corners[(k + 2) % 3];
        shares[static_cast<Eigen::Index>(k)] =
            std::max(0.0, normal.dot((b - a).cross(point - a)) / square);
    }
    return shares / shares.sum();
}

}  // namespace

MeshShape::MeshShape(const TriangleMesh& mesh) : mesh_{&mesh}, tree_{mesh}
{
    require(!mesh.triangles().empty(), "MeshShape: need a facet");
    find_fans();
    find_normals();
    find_tensors();
}

void MeshShape::find_fans()
{
    const std::size_t facets = mesh_->triangles().size();
    const std::vector<FacetEdge> edges = sorted_edges(*mesh_);
    const double least = std::cos(crease_angle);
    JoinedCorners joined{3 * facets};
    // the corner of a facet with a point
    const auto corner = [&](const FacetEdge& edge, std::int32_t point) {
        const std::size_t next = (edge.corner + 1) % 3;
        const bool is_first = mesh_->triangles()[edge.facet][edge.corner] == point;
        return 3 * edge.facet + (is_first ? edge.corner : next);
    };
    for (std::size_t k = 0; k < edges.size();) {
        std::size_t end = k + 1;
        while (end < edges.size() && edges[end].ends == edges[k].ends)
            ++end;
        if (end == k + 2) {
            const Vec3 a = facet_normal(mesh_->corners(edges[k].facet));
            const Vec3 b = facet_normal(mesh_->corners(edges[k + 1].facet));
            for (const std::int32_t point : edges[k].ends)
                if (a.dot(b) >= least)
                    joined.join(corner(edges[k], point), corner(edges[k + 1], point));
        }
        k = end;
    }
    constexpr std::int32_t unknown = -1;
    std::vector<std::int32_t> number_of_root(3 * facets, unknown);
    std::int32_t count = 0;
    fans_.resize(facets);
    for (std::size_t k = 0; k < 3 * facets; ++k) {
        std::int32_t& number = number_of_root[joined.root(k)];
        if (number == unknown)
            number = count++;
        fans_[k / 3][k % 3] = number;
    }
    normals_.assign(static_cast<std::size_t>(count), Vec3::Zero());
    tensors_.assign(static_cast<std::size_t>(count), Eigen::Matrix3d::Zero());
}

void MeshShape::find_normals()
{
    for (std::size_t facet = 0; facet < fans_.size(); ++facet) {
        const Corners corners = mesh_->corners(facet);
        const Vec3 normal = facet_normal(corners);
        for (std::size_t k = 0; k < 3; ++k)
            normals_[static_cast<std::size_t>(fans_[facet][k])] +=
                angle_at(corners, k) * normal;
    }
    for (Vec3& normal : normals_)
        normal.normalize();
}

void MeshShape::find_tensors()
{
    std::vector<double> areas(normals_.size(), 0);
    for (std::size_t facet = 0; facet < fans_.size(); ++facet) {
        const Corners corners = mesh_->corners(facet);
        std::array<Vec3, 3> normals;
        for (std::size_t k = 0; k < 3; ++k)
            normals[k] = normals_[static_cast<std::size_t>(fans_[facet][k])];
        const Eigen::Matrix3d tensor = facet_tensor(corners, normals);
        const double area = facet_area(corners);
        for (const std::int32_t fan : fans_[facet]) {
            tensors_[static_cast<std::size_t>(fan)] += area * tensor;
            areas[static_cast<std::size_t>(fan)] += area;
        }
    }
    for (std::size_t fan = 0; fan < areas.size(); ++fan)
        if (areas[fan] > 0)
            tensors_[fan] /= areas[fan];
}

ShapePlace MeshShape::at(std::size_t facet, const Vec3& point) const
{
    const Corners corners = mesh_->corners(facet);
    const Vec3 shares = shares_of(corners, point);
    ShapePlace place{point, Vec3::Zero(), Eigen::Matrix3d::Zero(), facet};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto fan = static_cast<std::size_t>(fans_[facet][k]);
        const double share = shares[static_cast<Eigen::Index>(k)];
        place.normal += share * normals_[fan];
        place.tensor += share * tensors_[fan];
    }
    place.normal.normalize();
    return place;
}

ShapePlace MeshShape::nearest(const Vec3& place) const
{
    const auto found = tree_.nearest(place);
    assert(found);
    return at(found->triangle, found->point);
}

ShapePlace MeshShape::middle(std::size_t facet) const
{
    const Corners corners = mesh_->corners(facet);
    return at(facet, (corners[0] + corners[1] + corners[2]) / 3);
}

}  // namespace endmill
