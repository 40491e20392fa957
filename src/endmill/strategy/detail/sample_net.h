// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
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

/// The samples in the middle of edges. A table with open addressing, several times quicker
/// than a map of the standard library.
class EdgeMiddles {
public:
    /// An edge that has a middle already keeps it.
    void add(std::int32_t a, std::int32_t b, std::int32_t middle)
    {
        if (2 * (count_ + 1) > table_.size())
            grow();
        Entry& entry = table_[place_of(key(a, b))];
        if (entry.key == no_edge) {
            entry = {key(a, b), middle};
            ++count_;
        }
    }
    /// The middle of an edge, which may be changed; null if the edge is not divided.
    std::int32_t* find(std::int32_t a, std::int32_t b)
    {
        if (table_.empty())
            return nullptr;
        Entry& entry = table_[place_of(key(a, b))];
        return entry.key == no_edge ? nullptr : &entry.middle;
    }
    /// Nothing if the edge is not divided.
    std::optional<std::int32_t> of(std::int32_t a, std::int32_t b) const
    {
        if (table_.empty())
            return std::nullopt;
        const Entry& entry = table_[place_of(key(a, b))];
        return entry.key == no_edge ? std::nullopt : std::optional{entry.middle};
    }

private:
    // No edge has this key: numbers of samples are not negative.
    static constexpr std::uint64_t no_edge = ~std::uint64_t{0};

    struct Entry {
        std::uint64_t key = no_edge;
        std::int32_t middle = 0;
    };

    static std::uint64_t key(std::int32_t a, std::int32_t b)
    {
        return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
               static_cast<std::uint64_t>(std::max(a, b));
    }

    // The entry of a key, or the free entry in which it belongs. Keys are spread by a
    // multiplication; its upper bits depend on all bits of the key.
    std::size_t place_of(std::uint64_t key) const
    {
        constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15;
        constexpr int upper_bits = 32;
        const std::size_t mask = table_.size() - 1;
        std::size_t place = (key * golden_ratio >> upper_bits) & mask;
        while (table_[place].key != no_edge && table_[place].key != key)
            place = (place + 1) & mask;
        return place;
    }

    void grow()
    {
        constexpr std::size_t first_size = 1024;
        const std::vector<Entry> old = std::exchange(
            table_, std::vector<Entry>(std::max(first_size, 2 * table_.size())));
        for (const Entry& entry : old)
            if (entry.key != no_edge)
                table_[place_of(entry.key)] = entry;
    }

    std::vector<Entry> table_;  // its size is a power of two
    std::size_t count_ = 0;
};

/// The triangles, divided at the middles of their edges into two to four.
/// \param may_be_divided by triangle; 0 only where no edge has a middle. Empty: all may be.
std::vector<Triangle> divided_triangles(std::span<const Triangle> triangles,
                                        const EdgeMiddles& middles,
                                        std::span<const char> may_be_divided = {});

}  // namespace endmill
