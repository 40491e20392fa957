// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/mesh_segments.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "endmill/core/parallel.h"

namespace endmill {
namespace {

using Index = std::int32_t;
// The number of planes of a batch below a vertex; the vertex is above plane k if it is
// larger than k. It has 16 bits, so that the numbers of a million vertices fit into the
// cache.
using PlaneCount = std::uint16_t;

static_assert(most_planes_a_batch == std::numeric_limits<PlaneCount>::max());

// Counts the planes below a position t: a guess from the mean pitch is checked, and a
// binary search follows if it was wrong.
class PlaneCounter {
public:
    explicit PlaneCounter(std::span<const double> positions)
        : count_{static_cast<double>(positions.size())},
          first_{positions.front()}
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const double width = positions.back() - first_;
        planes_a_mm_ = width > 0 ? (count_ - 1) / width : 0;
        fenced_.push_back(-infinity);
        fenced_.insert(fenced_.end(), positions.begin(), positions.end());
        fenced_.push_back(infinity);
    }

    PlaneCount below(double t) const
    {
        const double guess = std::clamp((t - first_) * planes_a_mm_ + 1, 0.0, count_);
        const auto number = static_cast<std::size_t>(guess);
        if (fenced_[number] < t && t <= fenced_[number + 1])
            return static_cast<PlaneCount>(number);
        const auto found = std::ranges::lower_bound(fenced_, t);
        return static_cast<PlaneCount>(found - fenced_.begin() - 1);
    }

private:
    double count_;
    double first_;
    double planes_a_mm_;
    std::vector<double> fenced_;
};

std::vector<PlaneCount> planes_below(std::span<const Vec3> points,
                                     const DriveFrame& frame,
                                     std::span<const double> positions)
{
    const PlaneCounter counter{positions};
    std::vector<PlaneCount> counts(points.size());
    parallel_for(points.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            counts[k] = counter.below(frame.across(points[k]));
    });
    return counts;
}

// The first and the last plane (exclusive) that cross a triangle.
std::pair<PlaneCount, PlaneCount> planes_across(const Triangle& triangle,
                                                const std::vector<PlaneCount>& below)
{
    const PlaneCount a = below[triangle[0]];
    const PlaneCount b = below[triangle[1]];
    const PlaneCount c = below[triangle[2]];
    return {std::min(std::min(a, b), c), std::max(std::max(a, b), c)};
}

// Which corners bound the edge that a segment comes from and the edge that it goes to.
// The index of the table has bit k set if corner k is above the plane.
struct SegmentCorners {
    std::array<int, 2> from;  // the corner below the plane, then the one above
    std::array<int, 2> to;
};
constexpr std::array<SegmentCorners, 7> segment_corners{{{},
                                                         {{1, 0}, {2, 0}},
                                                         {{2, 1}, {0, 1}},
                                                         {{2, 1}, {2, 0}},
                                                         {{0, 2}, {1, 2}},
                                                         {{1, 0}, {1, 2}},
                                                         {{0, 2}, {0, 1}}}};

// Cuts a mesh by a batch of planes into segments:
// 1. The number of planes below each vertex is computed.
// 2. Each chunk of triangles lists its crossed triangles and counts their segments for
//    each plane.
// 3. Prefix sums give each chunk its place in the list of each plane.
// 4. Each chunk writes its segments there. The order is that of the triangles, for any
//    number of threads.
class Cutting {
public:
    Cutting(const TriangleMesh& mesh, const DriveFrame& frame,
            std::span<const double> positions)
        : points_{mesh.points()},
          triangles_{mesh.triangles()},
          positions_{positions},
          below_{planes_below(points_, frame, positions)},
          chunk_size_{std::max(least_chunk, triangles_.size() / most_chunks + 1)},
          chunks_((triangles_.size() + chunk_size_ - 1) / chunk_size_)
    {
    }

    MeshSegments segments()
    {
        for_each_chunk([&](std::size_t chunk) { find_crossed(chunk); });
        MeshSegments segments;
        segments.first.push_back(0);
        for (std::size_t plane = 0; plane < positions_.size(); ++plane) {
            std::size_t next = segments.first.back();
            for (Chunk& chunk : chunks_)
                next += std::exchange(chunk.places[plane], next);
            segments.first.push_back(next);
        }
        segments.from.resize(segments.first.back());
        segments.to.resize(segments.first.back());
        segments.triangle.resize(segments.first.back());
        for_each_chunk([&](std::size_t chunk) { cut(chunks_[chunk], segments); });
        return segments;
    }

private:
    // Triangles that a thread takes at a time. Each chunk has one counter for each plane.
    static constexpr std::size_t least_chunk = 32768;
    static constexpr std::size_t most_chunks = 64;

    struct Chunk {
        std::vector<Index> crossed;  // crossed by any plane
        // for each plane the number of segments, later the next free place
        std::vector<std::size_t> places;
    };

    template <class Use>
    void for_each_chunk(const Use& use)
    {
        parallel_for(chunks_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t chunk = begin; chunk < end; ++chunk)
                use(chunk);
        });
    }

    void find_crossed(std::size_t number)
    {
        Chunk& chunk = chunks_[number];
        const std::size_t begin = number * chunk_size_;
        const std::size_t end = std::min(begin + chunk_size_, triangles_.size());
        chunk.crossed.resize(end - begin);
        std::size_t count = 0;
        for (std::size_t k = begin; k < end; ++k) {
            const auto [low, high] = planes_across(triangles_[k], below_);
            chunk.crossed[count] = static_cast<Index>(k);
            count += low != high ? 1 : 0;
        }
        chunk.crossed.resize(count);
        chunk.places.assign(positions_.size(), 0);
        for (const Index k : chunk.crossed) {
            const auto [low, high] = planes_across(triangles_[k], below_);
            for (std::size_t plane = low; plane < high; ++plane)
                ++chunk.places[plane];
        }
    }

    void cut(Chunk& chunk, MeshSegments& segments) const
    {
        for (const Index k : chunk.crossed) {
            const Triangle& triangle = triangles_[k];
            const auto [low, high] = planes_across(triangle, below_);
            for (std::size_t plane = low; plane < high; ++plane) {
                const auto is_above = [&](int corner) -> unsigned {
                    return below_[triangle[corner]] > plane ? 1 : 0;
                };
                const auto& [from, to] =
                    segment_corners[is_above(0) | is_above(1) << 1 | is_above(2) << 2];
                const std::size_t place = chunk.places[plane]++;
                segments.from[place] = {triangle[from[0]], triangle[from[1]]};
                segments.to[place] = {triangle[to[0]], triangle[to[1]]};
                segments.triangle[place] = k;
            }
        }
    }

    std::span<const Vec3> points_;
    std::span<const Triangle> triangles_;
    std::span<const double> positions_;
    std::vector<PlaneCount> below_;
    std::size_t chunk_size_;
    std::vector<Chunk> chunks_;
};

}  // namespace

MeshSegments mesh_segments(const TriangleMesh& mesh, const DriveFrame& frame,
                           std::span<const double> positions)
{
    return Cutting{mesh, frame, positions}.segments();
}

}  // namespace endmill
