// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/stacked_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/detail/large_pages.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/figures/detail/round_ticks.h"

// A chart is drawn panel by panel. Each panel has its own ordinate, from ticks that cover
// all its values; all panels share the abscissa.
// A path may have millions of moves, but the chart has fewer than a thousand columns of
// pixels. The points that fall on one column are reduced to the first, the last and the
// two extremes. The drawn line covers the same pixels as the full curve would.

namespace endmill {
namespace {

// Layout of the page, in px.
constexpr double width = 900;
constexpr double left = 80;
constexpr double right = 20;
constexpr double line_height = 20;
constexpr double panel_height = 150;
constexpr double panel_gap = 46;
constexpr double label_offset = 8;
constexpr double legend_step = 180;
constexpr double legend_dash = 24;
constexpr double number_width = 60;
constexpr int strip_thickness = 14;
constexpr double strip_height = 66;  // of a strip with its label and its legend
constexpr double letter_width = 7;   // of the legend of a strip

constexpr int abscissa_ticks = 8;
constexpr int ordinate_ticks = 4;
constexpr std::size_t longest_text = 150;

// Values that differ by less than this share of their size count as constant, since they
// differ by rounding only. The scale then has room on both sides of the value.
constexpr double constant_share = 1e-6;
constexpr double constant_room = 0.1;

// A value that is nearer to the last tick than this share of a step is drawn on the frame.
constexpr double frame_share = 0.02;

constexpr LineStyle frame_style{"#444444", 1, ""};
constexpr LineStyle grid_style{"#dddddd", 1, ""};
constexpr TextStyle small_text{.size_px = 12};

// A linear scale from values to px.
struct Scale {
    double from;  // value
    double to;    // value above `from`
    double from_px;
    double to_px;

    // The place of a value.
    double px(double value) const
    {
        return from_px + (value - from) / (to - from) * (to_px - from_px);
    }
};

// The values of a curve; NaN in its gaps.
using Values = std::vector<double>;

// Computes the values of a curve, each once. `values` may be used again for one curve after
// the other.
void evaluate(const ChartLine& line, Values& values)
{
    reserve_in_large_pages(values, line.values.size());
    values.resize(line.values.size());
    parallel_for(values.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::optional<double> value = line.values[i];
            require(!value || std::isfinite(*value),
                    "stacked_chart: a number is not finite");
            values[i] = value.value_or(std::numeric_limits<double>::quiet_NaN());
        }
    });
}

// The ticks of a panel: they cover all its values, or 0 to 1 if it has none.
std::vector<double> ticks_of(std::span<const Values> lines)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Values& values : lines)
        for (const double value : values)
            if (!std::isnan(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
    if (low > high)
        return round_ticks(0, 1, ordinate_ticks);
    const double size = std::max(std::abs(low), std::abs(high));
    if (high - low > constant_share * size) {
        std::vector<double> ticks = round_ticks(low, high, ordinate_ticks);
        // A curve that runs along the frame, such as a feed at its cap, would be hidden. Only 0
        // is a natural end of a scale.
        const double step = step_of(ticks);
        if (ticks.back() - high < frame_share * step)
            ticks.push_back(ticks.back() + step);
        if (ticks.front() != 0 && low - ticks.front() < frame_share * step)
            ticks.insert(ticks.begin(), ticks.front() - step);
        return ticks;
    }
    const double room = size > 0 ? constant_room * size : 1;
    return round_ticks(low - room, high + room, ordinate_ticks);
}

// The points of a curve in one column of pixels, reduced to the first, last, lowest and
// highest.
struct PixelColumn {
    PixelPoint first = PixelPoint::Zero();
    PixelPoint last = PixelPoint::Zero();
    PixelPoint low = PixelPoint::Zero();
    PixelPoint high = PixelPoint::Zero();
    bool is_empty = true;

    // Adds the next point of the curve.
    void add(const PixelPoint& point)
    {
        if (is_empty)
            first = low = high = point;
        last = point;
        low = point.y() > low.y() ? point : low;
        high = point.y() < high.y() ? point : high;
        is_empty = false;
    }

    // Appends the points in the order of the curve: the lower extreme first if it comes
    // first.
    void append_to(std::vector<PixelPoint>& points) const
    {
        if (is_empty)
            return;
        const bool is_low_first = low.x() <= high.x();
        for (const PixelPoint& point :
             {first, is_low_first ? low : high, is_low_first ? high : low, last})
            if (points.empty() || points.back() != point)
                points.push_back(point);
    }
};

// Draws a curve column by column; a gap ends the current polyline and starts a new one.
void draw_line(SvgPicture& picture, const LineStyle& style,
               std::span<const double> values, std::span<const double> places,
               const Scale& x, const Scale& y)
{
    std::vector<PixelPoint> points;
    PixelColumn column;
    const auto close = [&] {
        column.append_to(points);
        column = {};
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (std::isnan(values[i])) {
            close();
            picture.add_polyline(points, style);
            points.clear();
            continue;
        }
        const PixelPoint point{x.px(places[i]), y.px(values[i])};
        if (!column.is_empty && std::floor(point.x()) != std::floor(column.first.x()))
            close();
        column.add(point);
    }
    close();
    picture.add_polyline(points, style);
}

// The legend of a panel is on one line above it.
void draw_legend(SvgPicture& picture, const ChartPanel& panel, double top)
{
    double place = left + width / 2 - label_offset;
    for (const ChartLine& line : panel.lines) {
        const double height = top - label_offset;
        const std::vector<PixelPoint> dash{{place, height - 4},
                                           {place + legend_dash, height - 4}};
        picture.add_polyline(dash, line.style);
        picture.add_text({place + legend_dash + 4, height}, line.label, small_text);
        place += legend_step;
    }
}

// Draws the ticks of the ordinate with their numbers, and the frame of the panel.
void draw_grid(SvgPicture& picture, const std::vector<double>& ticks, const Scale& x,
               const Scale& y)
{
    const double step = step_of(ticks);
    for (const double tick : ticks) {
        const std::vector<PixelPoint> line{{x.from_px, y.px(tick)},
                                           {x.to_px, y.px(tick)}};
        picture.add_polyline(line, grid_style);
        picture.add_text({left - number_width, y.px(tick) + 4}, tick_text(tick, step),
                         small_text);
    }
    const std::vector<PixelPoint> box{{x.from_px, y.from_px},
                                      {x.to_px, y.from_px},
                                      {x.to_px, y.to_px},
                                      {x.from_px, y.to_px},
                                      {x.from_px, y.from_px}};
    picture.add_polyline(box, frame_style);
}

// Draws the ticks of the abscissa with their numbers.
void draw_abscissa(SvgPicture& picture, const std::vector<double>& ticks, const Scale& x,
                   double height)
{
    const double step = step_of(ticks);
    for (const double tick : ticks)
        if (tick <= x.to) {
            const std::vector<PixelPoint> mark{{x.px(tick), height},
                                               {x.px(tick), height + 4}};
            picture.add_polyline(mark, frame_style);
            picture.add_text({x.px(tick), height + line_height}, tick_text(tick, step),
                             {.size_px = 12, .centred = true});
        }
}

// The cause that holds for the largest part of each column of pixels.
std::vector<std::size_t> causes_of_columns(const ChartStrip& strip,
                                           std::span<const double> places, const Scale& x)
{
    const auto columns = static_cast<std::size_t>(x.to_px - x.from_px);
    std::vector<std::vector<double>> covered(columns,
                                             std::vector<double>(strip.causes.size()));
    double from = x.from_px;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double to = std::clamp(x.px(places[i]), from, x.to_px);
        for (auto column = static_cast<std::size_t>(from - x.from_px);
             column < columns && x.from_px + static_cast<double>(column) < to; ++column) {
            const double left_side = x.from_px + static_cast<double>(column);
            covered[column][strip.cause[i]] +=
                std::min(to, left_side + 1) - std::max(from, left_side);
        }
        from = to;
    }
    std::vector<std::size_t> causes;
    causes.reserve(columns);
    for (const std::vector<double>& parts : covered)
        causes.push_back(
            static_cast<std::size_t>(std::ranges::max_element(parts) - parts.begin()));
    return causes;
}

// The last place of the abscissa that has data, as a number of columns of pixels.
std::size_t used_columns(std::span<const double> places, const Scale& x)
{
    return places.empty()
               ? 0
               : static_cast<std::size_t>(std::ceil(x.px(places.back()) - x.from_px));
}

// Draws a strip and, below it, its legend.
void draw_strip(SvgPicture& picture, const ChartStrip& strip,
                std::span<const double> places, const Scale& x, double top)
{
    picture.add_text({left, top - label_offset}, strip.label, small_text);
    std::vector<std::size_t> causes = causes_of_columns(strip, places, x);
    causes.resize(std::min(causes.size(), used_columns(places, x)));
    double place = left;
    const double legend = top + strip_thickness + line_height;
    for (std::size_t k = 0; k < strip.causes.size(); ++k) {
        std::vector<PixelBox> boxes;
        for (std::size_t begin = 0; begin < causes.size();) {
            std::size_t end = begin + 1;
            while (end < causes.size() && causes[end] == causes[begin])
                ++end;
            if (causes[begin] == k)
                boxes.push_back({static_cast<int>(x.from_px) + static_cast<int>(begin),
                                 static_cast<int>(top), static_cast<int>(end - begin),
                                 strip_thickness});
            begin = end;
        }
        if (boxes.empty())
            continue;
        picture.add_boxes(boxes, strip.causes[k].colour);
        const PixelBox sample{static_cast<int>(place), static_cast<int>(legend) - 10, 12,
                              12};
        picture.add_boxes(std::span{&sample, 1}, strip.causes[k].colour);
        picture.add_text({place + 18, legend}, strip.causes[k].label, small_text);
        place += 40 + letter_width * static_cast<double>(strip.causes[k].label.size());
    }
}

// Checks the input, so that drawing need not.
void check(std::span<const double> places, std::span<const ChartPanel> panels,
           std::span<const ChartStrip> strips)
{
    for (const ChartStrip& strip : strips) {
        require(strip.cause.size() == places.size(),
                "stacked_chart: need one cause for each place");
        parallel_for(places.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                require(strip.cause[i] < strip.causes.size(),
                        "stacked_chart: need a known cause");
        });
    }
    require(!panels.empty(), "stacked_chart: need a panel");
    for (std::size_t i = 0; i < places.size(); ++i)
        require(std::isfinite(places[i]) && (i == 0 || places[i - 1] <= places[i]),
                "stacked_chart: need finite, rising places");
    for (const ChartPanel& panel : panels)
        for (const ChartLine& line : panel.lines)
            require(line.values.size() == places.size(),
                    "stacked_chart: need one value for each place");
}

}  // namespace

std::string stacked_chart(const ChartFrame& frame, std::span<const double> places,
                          std::span<const ChartPanel> panels,
                          std::span<const ChartStrip> strips)
{
    check(places, panels, strips);
    const double head = line_height * (2.5 + static_cast<double>(frame.captions.size()));
    const double count = static_cast<double>(panels.size());
    const double below = strip_height * static_cast<double>(strips.size()) + line_height;
    SvgPicture picture{width, head + count * (panel_height + panel_gap) + below,
                       printable(frame.title, longest_text)};
    picture.add_text({left, 1.5 * line_height}, printable(frame.title, longest_text),
                     {.size_px = 18, .bold = true});
    double height = 2.5 * line_height;
    for (const std::string& caption : frame.captions) {
        picture.add_text({left, height}, printable(caption, longest_text), {});
        height += line_height;
    }
    const double end = places.empty() || places.back() <= 0 ? 1 : places.back();
    const Scale x{0, end, left, width - right};
    const std::vector<double> abscissa = round_ticks(0, end, abscissa_ticks);
    double top = head + line_height / 2;
    std::vector<Values> lines;
    for (const ChartPanel& panel : panels) {
        lines.resize(panel.lines.size());
        for (std::size_t k = 0; k < lines.size(); ++k)
            evaluate(panel.lines[k], lines[k]);
        const std::vector<double> ticks = ticks_of(lines);
        const Scale y{ticks.front(), ticks.back(), top + panel_height, top};
        picture.add_text({left, top - label_offset}, panel.label, small_text);
        draw_legend(picture, panel, top);
        draw_grid(picture, ticks, x, y);
        draw_abscissa(picture, abscissa, x, top + panel_height);
        for (std::size_t k = 0; k < lines.size(); ++k)
            draw_line(picture, panel.lines[k].style, lines[k], places, x, y);
        top += panel_height + panel_gap;
    }
    picture.add_text({width / 2, top - label_offset}, frame.abscissa,
                     {.size_px = 12, .centred = true});
    for (const ChartStrip& strip : strips) {
        draw_strip(picture, strip, places, x, top + line_height);
        top += strip_height;
    }
    return picture.text();
}

}  // namespace endmill
