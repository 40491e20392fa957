// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/upper_envelope.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace endmill {
namespace {

// A chain is merged into an envelope if it overlaps at most this many pieces for each of
// its segments, or this many in total. Then the work is proportional to the length of the
// chain.
constexpr std::size_t pieces_per_segment = 4;
constexpr std::size_t pieces_at_least = 64;

// Consecutive segments whose ds has the same sign, from vertex `first` to vertex `last`.
struct Chain {
    std::int32_t first;
    std::int32_t last;
    bool is_rightwards;
};

// An upper envelope as two stacks that meet at the split, the place of the last change.
// The top of each stack is the piece nearest to the split; a piece over the split is in
// both. In the right stack EnvelopePiece::from is the end of a piece, so that in both
// stacks it is the end farther from the split.
struct OpenEnvelope {
    std::vector<EnvelopePiece> left;
    std::vector<EnvelopePiece> right;
    std::int32_t split = 0;

    std::size_t size() const { return left.size() + right.size(); }
};

// The source of a merge: the segments of a chain.
class ChainFeed {
public:
    explicit ChainFeed(const Chain& chain) : next_{chain.first}, last_{chain.last} {}

    bool is_done() const { return next_ == last_; }
    std::int32_t segment() const { return next_; }
    std::int32_t end() const { return next_ + 1; }  // of the current segment
    void advance() { ++next_; }

private:
    std::int32_t next_;
    std::int32_t last_;
};

// The source of a merge: the pieces right of another envelope's split, which are
// consumed.
class EnvelopeFeed {
public:
    explicit EnvelopeFeed(std::vector<EnvelopePiece>& pieces) : pieces_{pieces} {}

    bool is_done() const { return pieces_.empty(); }
    std::int32_t segment() const { return pieces_.back().segment; }
    std::int32_t end() const { return pieces_.back().from; }
    void advance() { pieces_.pop_back(); }

private:
    std::vector<EnvelopePiece>& pieces_;
};

// Number of segments that are tested together for lying below the envelope. A larger
// block needs fewer tests, but the envelope over it deviates more from a line.
constexpr std::int32_t block_size = 8;

// Largest slope of the line of a ShearedRange, so that no product overflows.
constexpr double largest_slope = 0x1p+100;

// The range of points in s, and of their heights above a line through the origin.
struct ShearedRange {
    double slope;  // of the line
    double least_s = std::numeric_limits<double>::infinity();
    double largest_s = -std::numeric_limits<double>::infinity();
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    double size = 0;  // largest sum of the terms of a height

    void add(const SectionPoint& point)
    {
        const double line = slope * point[0];
        const double height = point[1] - line;
        least_s = std::min(least_s, point[0]);
        largest_s = std::max(largest_s, point[0]);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
        size = std::max(size, std::abs(line) + std::abs(point[1]));
    }

    // Whether all points certainly lie lower than all points of `other`.
    bool is_below(const ShearedRange& other) const
    {
        // With u = 2^-53, 2u of the size covers the rounding of a height. 8u also covers
        // the rounding of `size` and of this sum.
        constexpr double height_error = 0x1p-50;
        constexpr double underflow = std::numeric_limits<double>::min();
        return highest + height_error * (size + other.size) + underflow < other.lowest;
    }
};

void append(std::vector<EnvelopePiece>& half, std::int32_t segment, std::int32_t outer)
{
    if (half.empty() || half.back().segment != segment)
        half.push_back({segment, outer});
}

bool touches(std::int32_t segment, std::int32_t vertex)
{
    return segment == vertex || segment + 1 == vertex;
}

// Builds the envelope (see upper_envelope.h):
// 1. A curve is cut into chains at its vertical segments and wherever ds changes its
//    sign.
// 2. A chain begins where the chain before it ended, which is the split of the current
//    envelope. It is merged from there (walk): the pieces that it passes move from one
//    stack to the other. For a curve with short folds this takes O(1) per segment.
// 3. Before a chain is built, blocks of segments that lie below the envelope are skipped
//    by one comparison for each block (skip_buried). In the folds of an offset most
//    segments are such.
// 4. A chain that would pass many more pieces than it has segments begins an envelope of
//    its own (is_costly). Envelopes are merged when the last one is at least half as
//    large as the one before it, as the runs of a natural merge sort are, so that the
//    total is O(n log n).
// 5. At the end all envelopes are merged into one.
class Builder {
public:
    explicit Builder(const SectionPoints& section) : section_{section}, order_{section}
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        crossings_.push_back({-infinity, 0, 0, no_segment, no_segment});
    }

    UpperEnvelope build()
    {
        std::int32_t begin = 0;
        for (const std::int32_t end : section_.ends) {
            add_curve(begin, end);
            begin = end;
        }
        while (open_.size() > 1)
            merge_last();
        return result();
    }

private:
    static constexpr std::int32_t left_of_all = ~std::int32_t{0};

    void add_curve(std::int32_t begin, std::int32_t end)
    {
        bool is_new = true;
        for (std::int32_t first = begin; first + 1 < end;) {
            const double s = order_.s(first);
            double next = order_.s(first + 1);
            if (s == next) {
                verticals_.push_back(first);
                ++first;
                continue;
            }
            const bool is_rightwards = s < next;
            std::int32_t last = first + 1;
            while (last + 1 < end) {
                const double after = order_.s(last + 1);
                if (is_rightwards ? after <= next : after >= next)
                    break;
                next = after;
                ++last;
            }
            add_chain({first, last, is_rightwards}, is_new);
            is_new = false;
            first = skip_buried(last, end);
        }
    }

    // Skips the blocks of segments from `vertex` on that lie below the envelope, and
    // returns the vertex behind them. If a block does not lie below it, the next
    // `block_size` segments are not tested.
    std::int32_t skip_buried(std::int32_t vertex, std::int32_t end)
    {
        while (vertex >= next_test_ && vertex + block_size < end) {
            if (!is_buried(vertex)) {
                next_test_ = vertex + block_size;
                break;
            }
            vertex += block_size;
            move_split(vertex);
        }
        return vertex;
    }

    // Whether the next `block_size` segments certainly lie below the last open envelope,
    // whose split is at `vertex`. Heights are measured from a line with the slope of the
    // piece above the split. Proof: paper/notes/envelope-filters.md, section 9.
    bool is_buried(std::int32_t vertex) const
    {
        const OpenEnvelope& envelope = open_.back();
        if (envelope.left.empty() || envelope.right.empty())
            return false;
        const std::int32_t over = envelope.right.back().segment;
        if (over == no_segment || touches(over, vertex))
            return false;
        const auto& points = section_.points;
        const double slope = (points[over + 1][1] - points[over][1]) /
                             (points[over + 1][0] - points[over][0]);
        if (!(std::abs(slope) < largest_slope) || !order_.is_filtered())
            return false;
        ShearedRange block{slope};
        for (std::int32_t k = vertex; k <= vertex + block_size; ++k)
            block.add(points[k]);
        ShearedRange above{slope};
        above.add(points[over]);
        // The last comparison implies the first one, which ends many tests early.
        return block.is_below(above) &&
               add_pieces(envelope.left, -1, -block.least_s, above) &&
               add_pieces(envelope.right, 1, block.largest_s, above) &&
               block.is_below(above);
    }

    // Adds the segments of the pieces of `half` from the split to `end`, a value of s.
    // Both are negated if `direction` is -1. Returns false if the pieces do not reach it,
    // or if there are so many that the test would take longer than it saves.
    bool add_pieces(const std::vector<EnvelopePiece>& half, double direction, double end,
                    ShearedRange& range) const
    {
        const auto most = std::min<std::size_t>(half.size(), 2 * block_size);
        for (std::size_t k = 1; k <= most; ++k) {
            const auto [segment, from] = half[half.size() - k];
            if (segment == no_segment)
                return false;
            range.add(section_.points[segment]);
            range.add(section_.points[segment + 1]);
            const double error = from < 0 ? crossings_[~from].error : 0;
            if (direction * place_s(from) - end >= bound_margin * error)
                return true;
        }
        return false;
    }

    // Moves the split of the last open envelope to a vertex below that envelope.
    void move_split(std::int32_t vertex)
    {
        OpenEnvelope& envelope = open_.back();
        if (order_.s(vertex) > order_.s(envelope.split))
            move_pieces<true>(envelope, vertex);
        else
            move_pieces<false>(envelope, vertex);
    }

    template <bool is_rightwards>
    void move_pieces(OpenEnvelope& envelope, std::int32_t vertex)
    {
        auto& behind = is_rightwards ? envelope.left : envelope.right;
        auto& ahead = is_rightwards ? envelope.right : envelope.left;
        std::int32_t place = envelope.split;
        int farther = -1;
        while (farther < 0) {
            const auto [p, p_end] = ahead.back();
            farther =
                is_rightwards ? place_order(p_end, vertex) : place_order(vertex, p_end);
            append(behind, p, place);
            place = p_end;
            if (farther <= 0)
                ahead.pop_back();
        }
        envelope.split = vertex;
    }

    void add_chain(const Chain& chain, bool is_new)
    {
        if (is_new || is_costly(chain)) {
            while (open_.size() > 1 &&
                   2 * open_.back().size() >= open_[open_.size() - 2].size())
                merge_last();
            open_.emplace_back();
            if (open_.size() == 1)  // in most cases the only one
                open_.back().left.reserve(section_.points.size());
        }
        OpenEnvelope& envelope = open_.back();
        envelope.split = chain.first;
        if (chain.is_rightwards)
            walk<true>(envelope, ChainFeed{chain});
        else
            walk<false>(envelope, ChainFeed{chain});
    }

    bool is_costly(const Chain& chain) const
    {
        const auto& ahead = chain.is_rightwards ? open_.back().right : open_.back().left;
        const auto segments = static_cast<std::size_t>(chain.last - chain.first);
        const std::size_t pieces = pieces_per_segment * segments + pieces_at_least;
        if (ahead.size() <= pieces)
            return false;
        const double reached = place_s(ahead[ahead.size() - 1 - pieces].from);
        const double end = order_.s(chain.last);
        return chain.is_rightwards ? reached < end : reached > end;
    }

    // Merges the last open envelope into the one before it.
    void merge_last()
    {
        OpenEnvelope last = std::move(open_.back());
        open_.pop_back();
        rewind(last);
        rewind(open_.back());
        walk<true>(open_.back(), EnvelopeFeed{last.right});
    }

    // Moves the split to -infinity.
    static void rewind(OpenEnvelope& envelope)
    {
        while (!envelope.left.empty()) {
            const EnvelopePiece piece = envelope.left.back();
            append(envelope.right, piece.segment, envelope.split);
            envelope.split = piece.from;
            envelope.left.pop_back();
        }
        if (envelope.split != left_of_all) {
            append(envelope.right, no_segment, envelope.split);
            envelope.split = left_of_all;
        }
    }

    UpperEnvelope result()
    {
        UpperEnvelope envelope;
        envelope.verticals = std::move(verticals_);
        if (open_.empty())
            return envelope;
        OpenEnvelope& whole = open_.back();
        std::int32_t from = whole.split;
        for (; !whole.right.empty(); whole.right.pop_back()) {
            append(whole.left, whole.right.back().segment, from);
            from = whole.right.back().from;
        }
        envelope.pieces = std::move(whole.left);
        envelope.end = from;
        envelope.crossings = std::move(crossings_);
        return envelope;
    }

    // Merges the segments of `feed` into `envelope`, from the split on, and moves the
    // split along. Between two places where either changes its segment, both are linear,
    // so that the signs of their difference at both ends decide which is above and
    // whether they cross.
    template <bool is_rightwards, typename Feed>
    void walk(OpenEnvelope& envelope, Feed feed)
    {
        auto& behind = is_rightwards ? envelope.left : envelope.right;
        auto& ahead = is_rightwards ? envelope.right : envelope.left;
        std::int32_t place = envelope.split;
        // Whether the feed lies above the envelope (1), on it (0) or below it (-1), just
        // ahead.
        int above = 0;
        if (!ahead.empty() && place >= 0)
            above = order_at(feed.segment(), ahead.back().segment, place);
        while (!feed.is_done()) {
            const std::int32_t q = feed.segment();
            const std::int32_t q_end = feed.end();
            if (ahead.empty()) {
                append(behind, q, place);
                place = q_end;
                feed.advance();
                continue;
            }
            const auto [p, p_end] = ahead.back();
            const FirstEnd first = first_end<is_rightwards>({p, p_end}, {q, q_end});
            append_upper(behind, {q, p, place}, above, first.above);
            place = first.place;
            above = first.above;
            bool is_continuous = true;
            if (first.farther <= 0) {
                ahead.pop_back();
                is_continuous =
                    p_end < 0 ||
                    (!ahead.empty() && is_joined({p, p_end}, ahead.back().segment));
            }
            if (first.farther >= 0) {
                feed.advance();
                if (feed.is_done())
                    break;
                is_continuous = is_continuous && is_joined({q, q_end}, feed.segment());
            }
            if (!is_continuous)
                above = order_ahead(feed.segment(), ahead, place);
        }
        envelope.split = place;
    }

    // A segment and the place at which it ends.
    struct EndingSegment {
        std::int32_t segment;
        std::int32_t end;
    };

    // Whether `next` goes on where a segment ends: at a crossing, or at a vertex of both.
    static bool is_joined(const EndingSegment& ended, std::int32_t next)
    {
        return ended.end < 0 ||
               (touches(ended.segment, ended.end) && touches(next, ended.end));
    }

    // Whether q runs above the envelope `ahead` of a vertex (1), meets it (0) or runs
    // below it (-1) there.
    int order_ahead(std::int32_t q, const std::vector<EnvelopePiece>& ahead,
                    std::int32_t vertex) const
    {
        return ahead.empty() ? 1 : order_at(q, ahead.back().segment, vertex);
    }

    // Where the first of two segments ends.
    struct FirstEnd {
        std::int32_t place;
        int farther;  // as for order_at_end
        int above;  // whether q runs above p (1), meets it (0) or runs below it (-1) there
    };

    template <bool is_rightwards>
    FirstEnd first_end(const EndingSegment& p, const EndingSegment& q) const
    {
        const int farther =
            is_rightwards ? place_order(p.end, q.end) : place_order(q.end, p.end);
        std::int32_t place = farther < 0 || (farther == 0 && q.end < 0) ? p.end : q.end;
        const int above = order_at_end(q.segment, p.segment, place, farther);
        if (place < 0 && farther == 0 && above > 0)
            place = q.end;  // of two coincident crossings, the one on the envelope
        return {place, farther, above};
    }

    // Two segments from a place on.
    struct SegmentPair {
        std::int32_t q;
        std::int32_t p;
        std::int32_t from;
    };

    // Appends the upper one of two segments, and the other one from their crossing on, if
    // there is one. `above` and `above_at_end` are their orders at both ends.
    void append_upper(std::vector<EnvelopePiece>& pieces, const SegmentPair& pair,
                      int above, int above_at_end)
    {
        const auto [q, p, from] = pair;
        const bool is_above =
            above > 0 ||
            (above == 0 && (above_at_end > 0 || (above_at_end == 0 && is_before(q, p))));
        append(pieces, is_above ? q : p, from);
        if (above * above_at_end < 0) {
            crossings_.push_back(order_.crossing(p, q));
            append(pieces, is_above ? p : q,
                   ~static_cast<std::int32_t>(crossings_.size() - 1));
        }
    }

    // Whether q counts as the carrier where q and p coincide: the one with the smaller
    // number.
    static bool is_before(std::int32_t q, std::int32_t p)
    {
        return static_cast<std::uint32_t>(q) < static_cast<std::uint32_t>(p);
    }

    double place_s(std::int32_t place) const
    {
        return place >= 0 ? order_.s(place) : crossings_[~place].s;
    }

    // Whether x has a larger s than y (1), the same (0) or a smaller one (-1).
    int place_order(std::int32_t x, std::int32_t y) const
    {
        if (x >= 0 && y >= 0) {
            const double difference_sign = order_.s(x) - order_.s(y);
            return (difference_sign > 0) - (difference_sign < 0);
        }
        if (x >= 0)
            return -order_.order(crossings_[~y], order_.s(x));
        if (y >= 0)
            return order_.order(crossings_[~x], order_.s(y));
        return order_.order(crossings_[~x], crossings_[~y]);
    }

    // Whether q runs above p (1), meets it (0) or runs below it (-1) at `end`, where the
    // first of them ends: q if `farther` > 0, p if `farther` < 0, both if 0.
    int order_at_end(std::int32_t q, std::int32_t p, std::int32_t end, int farther) const
    {
        if (end >= 0 || p == no_segment || q == no_segment)
            return order_at(q, p, end);
        return farther > 0 ? order_.side(p, crossings_[~end])
                           : -order_.side(q, crossings_[~end]);
    }

    // The same at a vertex. If one of them is no_segment, the other is above it
    // everywhere.
    int order_at(std::int32_t q, std::int32_t p, std::int32_t vertex) const
    {
        if (p == no_segment || q == no_segment)
            return (p == no_segment) - (q == no_segment);
        if (touches(q, vertex))
            return touches(p, vertex) ? 0 : order_.side(p, vertex);
        if (touches(p, vertex))
            return -order_.side(q, vertex);
        return order_.height_order(q, p, order_.s(vertex));
    }

    const SectionPoints& section_;
    SectionOrder order_;
    std::vector<EnvelopeCrossing> crossings_;
    std::vector<OpenEnvelope> open_;
    std::vector<std::int32_t> verticals_;
    std::int32_t next_test_ = 0;  // first vertex at which skip_buried tests a block
};

}  // namespace

UpperEnvelope upper_envelope(const SectionPoints& section)
{
    return Builder{section}.build();
}

}  // namespace endmill
