// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/trimming/trimming.h"

namespace endmill {

/// A crossing of two segments of a chain.
struct ChainCrossing {
    std::int32_t segment_a;  ///< first vertex; in front of `segment_b` on the chain
    std::int32_t segment_b;  ///< first vertex
    SectionPoint at;         ///< s and z in mm
    /// up to rounding; if false, the crossing is only near them
    bool lies_on_both = true;
};

/// An open section curve from which stretches are cut and into which crossings are
/// inserted. It is a doubly linked list of vertices with numbers: vertices of the input
/// keep their own, crossings get the next ones. A segment is denoted by its first vertex.
/// Each change takes constant time.
class SectionChain {
public:
    /// \param input the points of the curve, at least two. They must outlive the chain.
    /// \param curve number of the curve in its plane.
    SectionChain(std::span<const SectionPoint> input, std::int32_t curve);

    std::int32_t first() const { return first_; }  ///< first vertex
    std::int32_t last() const { return last_; }    ///< last vertex

    /// The vertex behind `vertex`. \pre `vertex` is not the last.
    std::int32_t next(std::int32_t vertex) const { return next_[vertex]; }

    /// The vertex in front of `vertex`. \pre `vertex` is not the first.
    std::int32_t previous(std::int32_t vertex) const { return previous_[vertex]; }

    /// The position of `vertex`: s and z in mm.
    const SectionPoint& at(std::int32_t vertex) const
    {
        return vertex < input_count() ? input_[vertex]
                                      : crossings_[vertex - input_count()].at;
    }

    /// The points of the original curve; point k is vertex k.
    std::span<const SectionPoint> input() const { return input_; }

    /// Cuts out everything between the vertices `left` and `right` and inserts `crossing`
    /// there. If `left` or `right` is exactly at the crossing, no vertex is inserted.
    /// \param left in front of `right`.
    /// \param right behind `left`.
    /// \param crossing where the chain continues.
    /// \param rule the reason for the cut.
    /// \return the vertex at the crossing.
    std::int32_t join(std::int32_t left, std::int32_t right,
                      const ChainCrossing& crossing, std::string_view rule);

    /// Cuts off everything in front of `vertex`, for the reason `rule`.
    void cut_before(std::int32_t vertex, std::string_view rule);
    /// Cuts off everything behind `vertex`, for the reason `rule`.
    void cut_behind(std::int32_t vertex, std::string_view rule);

    /// The curve that remains; without points if only one vertex remains.
    TrimmedCurve curve() const;

    /// The cuts, in the order in which they were made.
    const std::vector<AppliedRule>& rules() const { return rules_; }

private:
    std::int32_t input_count() const { return static_cast<std::int32_t>(input_.size()); }
    std::int32_t end_of_stretch(std::int32_t vertex) const;
    void append_input(std::int32_t first, std::int32_t last, TrimmedCurve& result) const;
    std::int32_t input_segment_behind(std::int32_t vertex) const;
    void record(std::int32_t first_cut, std::int32_t last_cut, std::string_view rule);
    std::int32_t first_cut_behind(std::int32_t vertex) const;
    std::int32_t last_cut_before(std::int32_t vertex) const;

    std::span<const SectionPoint> input_;
    std::int32_t curve_;
    std::int32_t first_ = 0;
    std::int32_t last_;
    std::vector<std::int32_t> next_;
    std::vector<std::int32_t> previous_;
    std::vector<TrimmedPoint> crossings_;
    std::vector<AppliedRule> rules_;
};

}  // namespace endmill
