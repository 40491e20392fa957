// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/section_chain.h"

#include <numeric>

#include "endmill/core/orientation.h"

namespace endmill {

SectionChain::SectionChain(std::span<const SectionPoint> input, std::int32_t curve)
    : input_{input},
      curve_{curve},
      last_{input_count() - 1},
      next_(input.size()),
      previous_(input.size())
{
    std::iota(next_.begin(), next_.end(), 1);
    std::iota(previous_.begin(), previous_.end(), -1);
}

std::int32_t SectionChain::join(std::int32_t left, std::int32_t right,
                                const ChainCrossing& crossing, std::string_view rule)
{
    const SegmentNumber on{curve_, input_segment_behind(crossing.segment_a)};
    const SegmentNumber across{curve_, input_segment_behind(crossing.segment_b)};
    record(first_cut_behind(left), last_cut_before(right), rule);

    const bool is_at_left = crossing.at == at(left);
    if (is_at_left || crossing.at == at(right)) {
        next_[left] = right;
        previous_[right] = left;
        return is_at_left ? left : right;
    }
    const auto vertex = static_cast<std::int32_t>(next_.size());
    crossings_.push_back({crossing.at, on, across, TrimmedKind::Crossing});
    next_.push_back(right);
    previous_.push_back(left);
    next_[left] = vertex;
    previous_[right] = vertex;
    return vertex;
}

void SectionChain::cut_before(std::int32_t vertex, std::string_view rule)
{
    record(0, last_cut_before(vertex), rule);
    first_ = vertex;
}

void SectionChain::cut_behind(std::int32_t vertex, std::string_view rule)
{
    record(first_cut_behind(vertex), input_count() - 1, rule);
    last_ = vertex;
}

TrimmedCurve SectionChain::curve() const
{
    TrimmedCurve result;
    if (first_ == last_)
        return result;
    result.points.reserve(next_.size());
    for (std::int32_t vertex = first_;; vertex = next_[vertex]) {
        if (vertex < input_count()) {
            const std::int32_t end = end_of_stretch(vertex);
            append_input(vertex, end, result);
            vertex = end;
        } else {
            result.points.push_back(crossings_[vertex - input_count()]);
        }
        if (vertex == last_)
            return result;
    }
}

// The last vertex of the unchanged stretch of the input that begins at `vertex`.
std::int32_t SectionChain::end_of_stretch(std::int32_t vertex) const
{
    const std::int32_t* next = next_.data();
    const std::int32_t end =
        vertex <= last_ && last_ < input_count() ? last_ : input_count() - 1;
    while (vertex < end && next[vertex] == vertex + 1)
        ++vertex;
    return vertex;
}

void SectionChain::append_input(std::int32_t first, std::int32_t last,
                                TrimmedCurve& result) const
{
    const std::int32_t curve = curve_;
    const SectionPoint* from = &input_[first];
    const std::size_t before = result.points.size();
    result.points.resize(before +
                         // entries are written twice, but allocated once
                         (last - first + 1));
    TrimmedPoint* to = &result.points[before];
    for (std::int32_t vertex = first; vertex <= last; ++vertex, ++from, ++to) {
        to->at = *from;
        to->on.curve = to->across.curve = curve;
        to->on.point = to->across.point = vertex;
        to->kind = TrimmedKind::Vertex;
    }
}

// The segment of the input that carries the chain's segment behind `vertex`.
std::int32_t SectionChain::input_segment_behind(std::int32_t vertex) const
{
    const std::int32_t next = next_[vertex];
    if (next >= input_count())
        return crossings_[next - input_count()].on.point;
    if (vertex >= input_count())
        return crossings_[vertex - input_count()].across.point;
    // Two vertices of the input that were joined because one of them lies on the other's
    // segment.
    const bool is_on_first =
        next == vertex + 1 ||
        orientation(input_[vertex], input_[vertex + 1], input_[next]) == 0;
    return is_on_first ? vertex : next - 1;
}

void SectionChain::record(std::int32_t first_cut, std::int32_t last_cut,
                          std::string_view rule)
{
    if (first_cut <= last_cut)
        rules_.push_back({curve_, first_cut, last_cut, rule});
}

std::int32_t SectionChain::first_cut_behind(std::int32_t vertex) const
{
    return 1 + (vertex < input_count() ? vertex
                                       : crossings_[vertex - input_count()].across.point);
}

std::int32_t SectionChain::last_cut_before(std::int32_t vertex) const
{
    return vertex < input_count() ? vertex - 1
                                  : crossings_[vertex - input_count()].on.point;
}

}  // namespace endmill
