// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/linking.h"

#include <cstddef>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// The same location at the safe height.
CutterLocation lifted(const CutterLocation& location, const LinkOptions& options)
{
    const double height = location.tip.dot(options.axis);
    if (height > options.safe_height)
        throw GeometryError{"the safe height " + to_text(options.safe_height) +
                            " mm lies below the path, which reaches " + to_text(height) +
                            " mm"};
    return {location.tip + (options.safe_height - height) * options.axis, location.axis};
}

class PathBuilder {
public:
    PathBuilder(const BallCutter& cutter, const LinkOptions& options, std::size_t points)
        : cutter_{cutter},
          options_{options}
    {
        path_.points.reserve(points);
    }

    void start_pass() { point_ = 0, ++pass_; }

    void add(Move move, const SurfaceContact& contact)
    {
        add(move, locate(cutter_, contact.contact, options_.axis), contact);
    }

    // From the end of the path so far to above `contact`, where a plunge may follow.
    void lift_over(const SurfaceContact& contact)
    {
        const CutterLocation next = locate(cutter_, contact.contact, options_.axis);
        add(Move::Retract, lifted(path_.points.back().location, options_), std::nullopt);
        add(Move::Rapid, lifted(next, options_), std::nullopt);
    }

    ToolPath take() { return std::move(path_); }

private:
    void add(Move move, const CutterLocation& location,
             const std::optional<SurfaceContact>& contact)
    {
        path_.points.push_back({pass_, point_++, move, location, contact});
    }

    const BallCutter& cutter_;
    const LinkOptions& options_;
    ToolPath path_;
    int pass_ = -1;
    int point_ = 0;
};

}  // namespace

ToolPath link_passes(std::span<const Pass> passes, const BallCutter& cutter,
                     const LinkOptions& options)
{
    const bool one_way = options.order == PassOrder::OneWay;
    std::size_t points = one_way ? 2 * passes.size() : 0;
    for (const Pass& pass : passes)
        points += pass.size();
    PathBuilder builder{cutter, options, points};
    for (std::size_t number = 0; number < passes.size(); ++number) {
        const Pass& pass = passes[number];
        const bool backwards = !one_way && number % 2 == 1;
        const auto contact = [&](std::size_t k) -> const SurfaceContact& {
            return backwards ? pass[pass.size() - 1 - k] : pass[k];
        };
        builder.start_pass();
        const bool lift = one_way && number > 0;
        if (lift)
            builder.lift_over(contact(0));
        builder.add(lift || number == 0 ? Move::Plunge : Move::Link, contact(0));
        for (std::size_t k = 1; k < pass.size(); ++k)
            builder.add(Move::Cut, contact(k));
    }
    return builder.take();
}

LinkedPath link_pieces(std::span<const PassPiece> pieces, const BallCutter& cutter,
                       const LinkOptions& options,
                       const std::function<bool(const SurfaceContact& from,
                                                const SurfaceContact& to)>& is_clear)
{
    std::size_t points = 2 * pieces.size();
    for (const PassPiece& piece : pieces)
        points += piece.contacts.size();
    PathBuilder builder{cutter, options, points};
    std::size_t lifted_links = 0;
    const PassPiece* previous = nullptr;
    for (const PassPiece& piece : pieces) {
        const SurfaceContact& first = piece.contacts.front();
        const bool is_new = !previous || previous->pass != piece.pass;
        if (is_new)
            builder.start_pass();
        Move move = Move::Plunge;
        if (previous) {
            const bool returns = is_new && options.order == PassOrder::OneWay;
            const bool lift = returns || !is_clear(previous->contacts.back(), first);
            if (lift && !returns)
                ++lifted_links;
            if (lift)
                builder.lift_over(first);
            else
                move = Move::Link;
        }
        builder.add(move, first);
        for (std::size_t k = 1; k < piece.contacts.size(); ++k)
            builder.add(Move::Cut, piece.contacts[k]);
        previous = &piece;
    }
    return {builder.take(), lifted_links};
}

ToolPath join_paths(std::span<const ToolPath> paths, const LinkOptions& options)
{
    ToolPath joined;
    int passes = 0;
    for (std::size_t number = 0; number < paths.size(); ++number) {
        const auto& points = paths[number].points;
        if (points.empty())
            continue;
        const int patch = static_cast<int>(number);
        int lifts = 0;  // rows before the first pass of this path, which they count to
        if (!joined.points.empty()) {
            const CutterLocation from = lifted(joined.points.back().location, options);
            const CutterLocation to = lifted(points.front().location, options);
            joined.points.push_back({passes, 0, Move::Retract, from, {}, patch});
            joined.points.push_back({passes, 1, Move::Rapid, to, {}, patch});
            lifts = 2;
        }
        for (PathPoint point : points) {
            if (point.pass == 0)
                point.point += lifts;
            point.pass += passes;
            point.patch = patch;
            joined.points.push_back(point);
        }
        passes = joined.points.back().pass + 1;
    }
    return joined;
}

}  // namespace endmill
