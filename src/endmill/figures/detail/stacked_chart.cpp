// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/stacked_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

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

// The text of a multiple of a step, rounded to the digits of the step.
std::string tick_text(double tick, double step)
{
    const double digits = std::max(0.0, -std::floor(std::log10(step)));
    const double power = std::pow(10, digits);
    return to_text(std::round(tick * power) / power + 0.0);
}

// The distance of neighbouring ticks.
double step_of(const std::vector<double>& ticks)
{
    return ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
}

// The ticks of a panel: they cover all its values, or 0 to 1 if it has none.
std::vector<double> ticks_of(const ChartPanel& panel)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const ChartLine& line : panel.lines)
        for (const auto& value : line.values)
            if (value) {
                low = std::min(low, *value);
                high = std::max(high, *value);
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
void draw_line(SvgPicture& picture, const ChartLine& line, std::span<const double> places,
               const Scale& x, const Scale& y)
{
    std::vector<PixelPoint> points;
    PixelColumn column;
    const auto close = [&] {
        column.append_to(points);
        column = {};
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!line.values[i]) {
            close();
            picture.add_polyline(points, line.style);
            points.clear();
            continue;
        }
        const PixelPoint point{x.px(places[i]), y.px(*line.values[i])};
        if (!column.is_empty && std::floor(point.x()) != std::floor(column.first.x()))
            close();
        column.add(point);
    }
    close();
    picture.add_polyline(points, line.style);
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

// Checks the input, so that drawing need not.
void check(std::span<const double> places, std::span<const ChartPanel> panels)
{
    require(!panels.empty(), "stacked_chart: need a panel");
    for (std::size_t i = 0; i < places.size(); ++i)
        require(std::isfinite(places[i]) && (i == 0 || places[i - 1] <= places[i]),
                "stacked_chart: need finite, rising places");
    for (const ChartPanel& panel : panels)
        for (const ChartLine& line : panel.lines) {
            require(line.values.size() == places.size(),
                    "stacked_chart: need one value for each place");
            for (const auto& value : line.values)
                require(!value || std::isfinite(*value),
                        "stacked_chart: a number is not finite");
        }
}

}  // namespace

// Width of a range below which its ticks would differ only in the rounding of their
// labels, as a share of its largest number, or absolute for numbers below 1.
constexpr double least_range_share = 1e-9;

// The step is the smallest of 1, 2, 5, 10 times a power of ten that is at least the rough
// step. A range of zero width gets the least step.
std::vector<double> round_ticks(double low, double high, int count)
{
    const double least =
        std::max({std::abs(low), std::abs(high), 1.0}) * least_range_share;
    const double rough = std::max(high - low, least) / count;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough) {
            step = factor * power;
            break;
        }
    const double first = std::floor(low / step);
    const double last = std::max(std::ceil(high / step), first + 1);
    std::vector<double> ticks;
    for (double k = first; k <= last; ++k)
        ticks.push_back(k * step);
    return ticks;
}

std::string stacked_chart(const ChartFrame& frame, std::span<const double> places,
                          std::span<const ChartPanel> panels)
{
    check(places, panels);
    const double head = line_height * (2.5 + static_cast<double>(frame.captions.size()));
    const double count = static_cast<double>(panels.size());
    SvgPicture picture{width, head + count * (panel_height + panel_gap) + line_height,
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
    for (const ChartPanel& panel : panels) {
        const std::vector<double> ticks = ticks_of(panel);
        const Scale y{ticks.front(), ticks.back(), top + panel_height, top};
        picture.add_text({left, top - label_offset}, panel.label, small_text);
        draw_legend(picture, panel, top);
        draw_grid(picture, ticks, x, y);
        draw_abscissa(picture, abscissa, x, top + panel_height);
        for (const ChartLine& line : panel.lines)
            draw_line(picture, line, places, x, y);
        top += panel_height + panel_gap;
    }
    picture.add_text({width / 2, top - label_offset}, frame.abscissa,
                     {.size_px = 12, .centred = true});
    return picture.text();
}

}  // namespace endmill
