// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

/// \file
/// The topology of a net of samples. Samples at one place that belong together are twins:
/// the representative of each is the lowest of them.

namespace endmill {

/// A list of numbers for each sample.
class SampleLists {
public:
    SampleLists() = default;

    /// \param samples number of samples.
    /// \param entries sample and number; the lists keep this order.
    SampleLists(std::size_t samples, std::span<const MeshEdge> entries);

    /// The list of sample i.
    std::span<const std::int32_t> of(std::size_t i) const
    {
        return std::span{numbers_}.subspan(first_[i], first_[i + 1] - first_[i]);
    }

private:
    std::vector<std::size_t> first_;
    std::vector<std::int32_t> numbers_;
};

/// The samples that share an edge or a place with each sample.
SampleLists net_neighbours(std::span<const Triangle> triangles,
                           std::span<const std::int32_t> representatives);

/// The numbers of the triangles at each sample, rising.
SampleLists net_triangles_at(std::span<const Triangle> triangles, std::size_t samples);

/// The edges of one triangle at whose place no other triangle has an edge.
std::vector<MeshEdge> net_border(std::span<const Triangle> triangles,
                                 std::span<const std::int32_t> representatives);

/// The number of each sample along a curve that fills the box of the samples, so that
/// neighbours have near numbers and share cache lines.
std::vector<std::int32_t> numbers_by_place(std::span<const Vec3> points);

/// The samples in the middle of edges.
class EdgeMiddles {
public:
    /// An edge that has a middle already keeps it.
    void add(std::int32_t a, std::int32_t b, std::int32_t middle)
    {
        const auto size = static_cast<std::size_t>(std::max(a, b)) + 1;
        if (is_end_.size() < size)
            is_end_.resize(std::max(size, 2 * is_end_.size()), false);
        is_end_[a] = is_end_[b] = true;
        middles_.emplace(key(a, b), middle);
    }
    /// The middle of an edge, which may be changed; null if the edge is not divided.
    std::int32_t* find(std::int32_t a, std::int32_t b)
    {
        if (!are_ends(a, b))
            return nullptr;
        const auto found = middles_.find(key(a, b));
        return found == middles_.end() ? nullptr : &found->second;
    }
    /// Nothing if the edge is not divided.
    std::optional<std::int32_t> of(std::int32_t a, std::int32_t b) const
    {
        if (!are_ends(a, b))
            return std::nullopt;
        const auto found = middles_.find(key(a, b));
        return found == middles_.end() ? std::nullopt : std::optional{found->second};
    }

private:
    // Whether both are ends of divided edges: most edges are ruled out in this way.
    bool are_ends(std::int32_t a, std::int32_t b) const
    {
        const auto last = static_cast<std::size_t>(std::max(a, b));
        return last < is_end_.size() && is_end_[a] && is_end_[b];
    }

    static std::uint64_t key(std::int32_t a, std::int32_t b)
    {
        return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
               static_cast<std::uint64_t>(std::max(a, b));
    }

    std::unordered_map<std::uint64_t, std::int32_t> middles_;
    std::vector<bool> is_end_;  // by number
};

/// The triangles, divided at the middles of their edges into two to four.
std::vector<Triangle> divided_triangles(std::span<const Triangle> triangles,
                                        const EdgeMiddles& middles);

}  // namespace endmill
