// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/trimming/trimming.h"

namespace endmill {

/// Where two segments of a chain cross, or are taken to.
struct ChainCrossing {
    std::int32_t segment_a;  ///< by its first vertex, on the chain before `segment_b`
    std::int32_t segment_b;
    SectionPoint at;
    bool lies_on_both = true;  ///< but for rounding; if not, it is near them
};

/// An open section curve from which stretches are cut and in which crossings are set. Its
/// vertices have numbers: those of the input their own, crossings the next ones. A segment
/// is told by its first vertex. Each change takes a time that does not depend on its size.
class SectionChain {
public:
    /// \param curve number of the curve in its plane. \pre `input` outlives the chain and
    /// has two points.
    SectionChain(std::span<const SectionPoint> input, std::int32_t curve);

    std::int32_t first() const { return first_; }  ///< vertex
    std::int32_t last() const { return last_; }    ///< vertex

    /// The vertex behind `vertex`. \pre it is not the last.
    std::int32_t next(std::int32_t vertex) const { return next_[vertex]; }

    /// The vertex in front of `vertex`. \pre it is not the first.
    std::int32_t previous(std::int32_t vertex) const { return previous_[vertex]; }

    /// Where `vertex` is: s and z in mm.
    const SectionPoint& at(std::int32_t vertex) const
    {
        return vertex < input_count() ? input_[vertex]
                                      : crossings_[vertex - input_count()].at;
    }

    /// The points that the chain began with: those of its vertices below their number.
    std::span<const SectionPoint> input() const { return input_; }

    /// Cuts out what lies between the vertices `left` and `right` and sets `crossing`
    /// there, unless one of the two is just there. `left` is in front of `right`.
    /// \return the vertex at the crossing.
    std::int32_t join(std::int32_t left, std::int32_t right,
                      const ChainCrossing& crossing, std::string_view rule);

    void cut_before(std::int32_t vertex, std::string_view rule);
    void cut_behind(std::int32_t vertex, std::string_view rule);

    /// What is left; no points if that is only one.
    TrimmedCurve curve() const;

    /// What was cut out, in order.
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
