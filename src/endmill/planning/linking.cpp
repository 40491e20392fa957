// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/linking.h"

#include <cstddef>

#include "endmill/core/error.h"
#include "endmill/core/numbers.h"

namespace endmill {
namespace {

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
        add(Move::Retract, lifted(path_.points.back().location), std::nullopt);
        add(Move::Rapid, lifted(next), std::nullopt);
    }

    ToolPath take() { return std::move(path_); }

private:
    CutterLocation lifted(const CutterLocation& location) const
    {
        const double height = location.tip.dot(options_.axis);
        if (height > options_.safe_height)
            throw GeometryError{"the safe height " + to_text(options_.safe_height) +
                                " mm lies below the path, which reaches " +
                                to_text(height) + " mm"};
        return {location.tip + (options_.safe_height - height) * options_.axis,
                location.axis};
    }

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

}  // namespace endmill
