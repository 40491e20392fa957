// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/dexel_gaps.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "endmill/core/detail/widest_registers.h"

// A ray without a known gap has an empty one at 0 without material around it. No chord fits
// there, so that it goes through the sets.

namespace endmill {
namespace {

constexpr int rays_at_once = 8;

[[gnu::always_inline]] inline std::int32_t lesser(std::int32_t a, std::int32_t b)
{
    return a < b ? a : b;
}

[[gnu::always_inline]] inline std::int32_t greater(std::int32_t a, std::int32_t b)
{
    return a > b ? a : b;
}

[[gnu::always_inline]] inline std::int32_t chosen(bool is_first, std::int32_t first,
                                                  std::int32_t second)
{
    return is_first ? first : second;
}

// What chords do to the gaps of all rows.
struct GapCuts {
    alignas(32) EightWhole deepest{};  // as in DexelCut, by columns
    alignas(32) EightWhole most_deep{};
    alignas(64) std::array<std::int64_t, rays_at_once> removed{};
    alignas(32) EightWhole from{};  // free on all rows
    alignas(32) EightWhole to{};
    std::array<EightWhole, rays_at_once> excess;  // above 0 where a chord does not fit
    std::array<bool, rays_at_once> is_left;       // whether one in the row does not
};

// Length of the material beside a gap within an interval.
[[gnu::always_inline]] inline std::int32_t length_beside(const EightGaps& gaps, int i,
                                                         std::int32_t from,
                                                         std::int32_t to)
{
    const std::int32_t below = lesser(gaps.from[i], to) - greater(gaps.below[i], from);
    const std::int32_t above = lesser(gaps.above[i], to) - greater(gaps.to[i], from);
    return greater(below, 0) + greater(above, 0);
}

// By how much an interval reaches past the material beside a gap, or misses the gap.
[[gnu::always_inline]] inline std::int32_t excess_of(const EightGaps& gaps, int i,
                                                     std::int32_t from, std::int32_t to)
{
    const std::int32_t past = greater(gaps.below[i] - from, to - gaps.above[i]);
    const std::int32_t beside = greater(from - gaps.to[i], gaps.from[i] - to);
    return greater(past, beside);
}

// Widens the gaps of a row by all chords that fit. An empty chord is replaced by the gap.
[[gnu::always_inline]] inline void cut_row(RowGaps& gaps, const EightWholeChords& chords,
                                           EightWhole& excesses, GapCuts& cuts)
{
    auto& [upper, lower] = gaps;
    const auto& [may, sure, is_grazing] = chords;
    ENDMILL_INDEPENDENT
    for (int i = 0; i < rays_at_once; ++i) {
        const bool is_cut = may.from[i] < may.to[i];
        const bool is_sure = sure.from[i] < sure.to[i];
        const std::int32_t from = chosen(is_cut, may.from[i], lower.from[i]);
        const std::int32_t to = chosen(is_cut, may.to[i], lower.to[i]);
        const std::int32_t sure_from = chosen(is_sure, sure.from[i], upper.from[i]);
        const std::int32_t sure_to = chosen(is_sure, sure.to[i], upper.to[i]);
        // Of the upper set the possible chord is measured, so it must not reach past the
        // material either.
        const std::int32_t past =
            greater(upper.below[i] - may.from[i], may.to[i] - upper.above[i]);
        const std::int32_t excess = greater(
            excess_of(lower, i, from, to),
            greater(excess_of(upper, i, sure_from, sure_to), chosen(is_cut, past, 0)));
        const std::int32_t depth = length_beside(lower, i, sure.from[i], sure.to[i]);
        const std::int32_t most = length_beside(upper, i, may.from[i], may.to[i]);
        const std::int32_t lower_from =
            chosen(excess > 0, lower.from[i], lesser(lower.from[i], from));
        const std::int32_t lower_to =
            chosen(excess > 0, lower.to[i], greater(lower.to[i], to));
        const std::int32_t upper_from =
            chosen(excess > 0, upper.from[i], lesser(upper.from[i], sure_from));
        const std::int32_t upper_to =
            chosen(excess > 0, upper.to[i], greater(upper.to[i], sure_to));
        cuts.removed[i] +=
            std::int64_t{lower.from[i] - lower_from + lower_to - lower.to[i]} +
            (upper.from[i] - upper_from + upper_to - upper.to[i]);
        cuts.deepest[i] = greater(cuts.deepest[i], chosen(excess > 0, 0, depth));
        cuts.most_deep[i] = greater(cuts.most_deep[i], chosen(excess > 0, 0, most));
        cuts.from[i] = greater(cuts.from[i], greater(upper_from, lower_from));
        cuts.to[i] = lesser(cuts.to[i], lesser(upper_to, lower_to));
        lower.from[i] = lower_from;
        lower.to[i] = lower_to;
        upper.from[i] = upper_from;
        upper.to[i] = upper_to;
        excesses[i] = excess;
    }
}

[[gnu::always_inline]] inline bool is_any_positive(const EightWhole& numbers)
{
    std::int32_t most = 0;
    for (int i = 0; i < rays_at_once; ++i)
        most = greater(most, numbers[i]);
    return most > 0;
}

ENDMILL_WIDEST_REGISTERS
void cut_rows(std::span<RowGaps> rows, std::span<const EightWholeChords> chords,
              GapCuts& cuts)
{
    const std::size_t step = chords.size() > 1 ? 1 : 0;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        cut_row(rows[row], chords[step * row], cuts.excess[row], cuts);
        cuts.is_left[row] = is_any_positive(cuts.excess[row]);
    }
}

// The gap of a set that contains an interval without material.
void take_gap(EightGaps& gaps, std::size_t ray, const std::vector<DexelInterval>& set,
              const DexelInterval& interval, std::int32_t units)
{
    const auto above = std::ranges::find_if(
        set, [&](const DexelInterval& one) { return one.from >= interval.to; });
    gaps.to[ray] = above == set.end() ? units : above->from;
    gaps.above[ray] = above == set.end() ? units : above->to;
    gaps.below[ray] = above == set.begin() ? 0 : (above - 1)->from;
    gaps.from[ray] = above == set.begin() ? 0 : (above - 1)->to;
}

// Writes a gap into its set. Only the two intervals beside it change.
void put_gap(const EightGaps& gaps, std::size_t ray, std::vector<DexelInterval>& set)
{
    for (auto one = set.begin(); one != set.end();) {
        if (one->from == gaps.below[ray] && one->from < gaps.from[ray])
            one->to = std::min(one->to, gaps.from[ray]);
        else if (one->to == gaps.above[ray] && one->to > gaps.to[ray])
            one->from = std::max(one->from, gaps.to[ray]);
        else if (one->from >= gaps.below[ray] && one->to <= gaps.above[ray]) {
            one = set.erase(one);
            continue;
        }
        ++one;
    }
}

// Sets the gap of a ray that has none, or does not exist.
void clear_gap(EightGaps& gaps, std::size_t ray, std::int32_t to)
{
    gaps.below[ray] = gaps.from[ray] = 0;
    gaps.to[ray] = gaps.above[ray] = to;
}

}  // namespace

DexelGaps::DexelGaps(std::size_t columns, std::size_t rows, std::int32_t units)
    : columns_{columns},
      units_{units},
      rows_(rows)
{
    for (RowGaps& row : rows_)
        for (std::size_t ray = 0; ray < rays_at_once; ++ray)
            for (EightGaps* gaps : {&row.upper, &row.lower})
                clear_gap(*gaps, ray, ray < columns ? 0 : units);
}

DexelCut DexelGaps::cut(std::span<Dexel> dexels, std::span<const EightWholeChords> chords)
{
    GapCuts cuts;
    cuts.to.fill(units_);
    cut_rows(rows_, chords, cuts);
    DexelCut done;
    common_ = {0, units_};
    for (std::size_t i = 0; i < rays_at_once; ++i) {
        done.add({cuts.removed[i], cuts.deepest[i], cuts.most_deep[i]});
        common_ = {std::max(common_.from, cuts.from[i]),
                   std::min(common_.to, cuts.to[i])};
    }
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        if (!cuts.is_left[row])
            continue;
        const EightWholeChords& of = chords.size() > 1 ? chords[row] : chords.front();
        for (std::size_t i = 0; i < columns_; ++i)
            if (cuts.excess[row][i] > 0)
                done.add(cut_one(
                    dexels, row * columns_ + i,
                    {{of.may.from[i], of.may.to[i]}, {of.sure.from[i], of.sure.to[i]}}));
        common_ = {0, 0};
    }
    return done;
}

// Removes a chord through the sets, and takes the gap around it.
DexelCut DexelGaps::cut_one(std::span<Dexel> dexels, std::size_t ray,
                            const DexelChord& chord)
{
    store(dexels, ray);
    Dexel& dexel = dexels[ray];
    const DexelCut done = cut_dexel(dexel, chord);
    if (chord.sure.from >= chord.sure.to)
        return done;
    const auto [row, column] = place_of(ray);
    take_gap(rows_[row].upper, column, dexel.upper, chord.sure, units_);
    take_gap(rows_[row].lower, column, dexel.lower, chord.may, units_);
    is_known_.set(ray);
    return done;
}

void DexelGaps::store(std::span<Dexel> dexels, std::size_t ray)
{
    if (!is_known_[ray])
        return;
    const auto [row, column] = place_of(ray);
    put_gap(rows_[row].upper, column, dexels[ray].upper);
    put_gap(rows_[row].lower, column, dexels[ray].lower);
    clear_gap(rows_[row].upper, column, 0);
    clear_gap(rows_[row].lower, column, 0);
    is_known_.reset(ray);
    common_ = {0, 0};
}

void DexelGaps::store(std::span<Dexel> dexels)
{
    for (std::size_t ray = 0; ray < dexels.size(); ++ray)
        store(dexels, ray);
}

}  // namespace endmill
