// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <embree3/rtcore.h>

#include <Eigen/Geometry>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Embree's stream of rays as a baseline: one ray from each centroid, in single
/// precision. It starts slightly off its facet, so that it does not hit the facet itself.
class EmbreeShadows {
public:
    explicit EmbreeShadows(const TriangleMesh& part)
        : device_{rtcNewDevice("threads=1")},
          scene_{rtcNewScene(device_)}
    {
        double reach = 0;
        for (const Vec3& point : part.points())
            reach = std::max(reach, point.norm());
        offset_ = 2e-5 * reach;  // docs/methods/five-axis-setup.md, section 1
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
            part.points().size()));
        for (const Vec3& point : part.points())
            for (const double coordinate : point)
                *points++ = static_cast<float>(coordinate);
        auto* corners = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), part.triangles().size()));
        for (const Triangle& triangle : part.triangles())
            for (const std::int32_t corner : triangle)
                *corners++ = static_cast<std::uint32_t>(corner);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
        for (std::size_t k = 0; k < part.triangles().size(); ++k) {
            const auto [a, b, c] = part.corners(k);
            const Vec3 normal = (b - a).cross(c - a).normalized();
            starts_.push_back(((a + b + c) / 3 + offset_ * normal).cast<float>());
        }
    }
    EmbreeShadows(const EmbreeShadows&) = delete;
    EmbreeShadows& operator=(const EmbreeShadows&) = delete;
    ~EmbreeShadows()
    {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    /// Number of facets of a column that are visible along `direction`.
    std::size_t seen(const Vec3& direction, std::span<const std::uint64_t> column)
    {
        rays_.clear();
        for (std::size_t word = 0; word < column.size(); ++word)
            for (std::uint64_t rest = column[word]; rest != 0; rest &= rest - 1)
                rays_.push_back(
                    ray(starts_[64 * word + std::countr_zero(rest)], direction));
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
        rtcOccluded1M(scene_, &context, rays_.data(), static_cast<unsigned>(rays_.size()),
                      sizeof(RTCRay));
        std::size_t count = 0;
        for (const RTCRay& each : rays_)
            count += each.tfar > 0;
        return count;
    }

private:
    static RTCRay ray(const Eigen::Vector3f& start, const Vec3& direction)
    {
        RTCRay ray{};
        ray.org_x = start.x();
        ray.org_y = start.y();
        ray.org_z = start.z();
        ray.dir_x = static_cast<float>(direction.x());
        ray.dir_y = static_cast<float>(direction.y());
        ray.dir_z = static_cast<float>(direction.z());
        ray.tfar = std::numeric_limits<float>::infinity();
        ray.mask = ~0U;
        return ray;
    }

    RTCDevice device_;
    RTCScene scene_;
    double offset_;  // mm
    std::vector<Eigen::Vector3f> starts_;
    std::vector<RTCRay> rays_;
};

}  // namespace endmill
