// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/figures/detail/round_ticks.h"
#include "endmill/figures/section_svg.h"

// The chart has three columns: names and medians, times, differences. Each method has one
// row. Both axes stand below the last row. Where several planes fall on one column of
// pixels, the largest difference is drawn, and it is drawn as wrong if one of them is.

namespace endmill {
namespace {

// Layout of the page, in px.
constexpr double width = 900;
constexpr double margin = 24;
constexpr double line_height = 20;
constexpr double row_height = 62;
constexpr double row_gap = 10;
constexpr double times_left = 150;
constexpr double times_right = 380;
constexpr double planes_left = 450;
constexpr double planes_right = 876;
constexpr double axis_height = 46;
constexpr double legend_height = 30;
constexpr double median_radius = 5;
constexpr double least_ms = 1e-6;  // a nanosecond, the resolution of the clock
constexpr int plane_ticks = 6;
constexpr std::size_t longest_text = 110;

constexpr LineStyle frame_style{"#444444", 1, ""};
constexpr LineStyle grid_style{"#dddddd", 1, ""};
constexpr LineStyle spread_style{"#111111", 2, ""};
constexpr std::string_view time_colour = "#1d4f91";
constexpr std::string_view right_colour = "#1d4f91";
constexpr std::string_view wrong_colour = "#d55e00";
constexpr TextStyle small_text{.size_px = 12};
constexpr TextStyle centred_text{.size_px = 12, .centred = true};

// The powers of ten between which values are drawn on a logarithmic scale.
struct Decades {
    int low;
    int high;

    // Decades that contain both values.
    Decades(double least, double greatest)
        : low{static_cast<int>(std::floor(std::log10(least)))},
          high{std::max(static_cast<int>(std::ceil(std::log10(greatest))), low + 1)}
    {
    }

    // The share of the scale up to which a value reaches.
    double share(double value) const
    {
        return std::clamp((std::log10(value) - low) / (high - low), 0.0, 1.0);
    }
};

double largest_difference(std::span<const MethodRow> rows, double tolerance)
{
    double largest = tolerance;
    for (const MethodRow& row : rows)
        for (const double distance : row.distances_mm)
            largest = std::max(largest, distance);
    return largest;
}

void check(std::span<const MethodRow> rows, const MethodsChart& chart)
{
    require(!rows.empty(), "methods_chart_svg: need a row");
    require(chart.tolerance_mm > 0 && std::isfinite(chart.tolerance_mm),
            "methods_chart_svg: need 0 < tolerance");
    for (const MethodRow& row : rows) {
        require(row.distances_mm.size() == rows.front().distances_mm.size() &&
                    row.is_right.size() == row.distances_mm.size(),
                "methods_chart_svg: need one distance and verdict for each plane");
        for (const double time : {row.lower_ms, row.median_ms, row.upper_ms})
            require(std::isfinite(time) && time >= 0,
                    "methods_chart_svg: need times from 0");
        for (const double distance : row.distances_mm)
            require(std::isfinite(distance), "methods_chart_svg: need finite distances");
    }
}

void add_line(SvgPicture& picture, const PixelPoint& from, const PixelPoint& to,
              const LineStyle& style)
{
    picture.add_polyline(std::array{from, to}, style);
}

// The times, on a logarithmic scale because methods differ by factors of hundreds.
class TimeColumn {
public:
    explicit TimeColumn(std::span<const MethodRow> rows) : decades_{decades_of(rows)} {}

    void draw_row(SvgPicture& picture, const MethodRow& row, double top) const
    {
        const double middle = top + row_height / 2;
        for (int decade = decades_.low; decade <= decades_.high; ++decade) {
            const double x = px(std::pow(10, decade));
            add_line(picture, {x, top}, {x, top + row_height}, grid_style);
        }
        add_line(picture, {px(row.lower_ms), middle}, {px(row.upper_ms), middle},
                 spread_style);
        for (const double end : {row.lower_ms, row.upper_ms})
            add_line(picture, {px(end), middle - 7}, {px(end), middle + 7}, spread_style);
        picture.add_disc({px(row.median_ms), middle}, median_radius, time_colour);
    }

    void draw_axis(SvgPicture& picture, double height) const
    {
        for (int decade = decades_.low; decade <= decades_.high; ++decade)
            picture.add_text({px(std::pow(10, decade)), height + line_height},
                             to_text(std::pow(10, decade)), centred_text);
        picture.add_text({(times_left + times_right) / 2, height + 2 * line_height},
                         "measured time of trimming, ms", centred_text);
    }

private:
    static Decades decades_of(std::span<const MethodRow> rows)
    {
        double least = std::numeric_limits<double>::infinity();
        double greatest = least_ms;
        for (const MethodRow& row : rows) {
            least = std::min({least, row.median_ms, row.lower_ms});
            greatest = std::max({greatest, row.median_ms, row.upper_ms});
        }
        return {std::max(least, least_ms), greatest};
    }

    double px(double ms) const
    {
        return times_left +
               decades_.share(std::max(ms, least_ms)) * (times_right - times_left);
    }

    Decades decades_;
};

// The differences of one method over the planes.
class PlaneColumn {
public:
    PlaneColumn(std::span<const MethodRow> rows, double tolerance)
        : decades_{tolerance, largest_difference(rows, tolerance)},
          tolerance_{tolerance},
          planes_{std::max<std::size_t>(rows.front().distances_mm.size(), 1)}
    {
    }

    void draw_row(SvgPicture& picture, const MethodRow& row, double top) const
    {
        const double bottom = top + row_height;
        if (!has_difference(row))
            picture.add_text({(planes_left + planes_right) / 2, top + row_height / 2 + 4},
                             "no difference beyond the tolerance", centred_text);
        else
            draw_scale(picture, top);
        draw_boxes(picture, row, bottom);
        add_line(picture, {planes_left, bottom}, {planes_right, bottom}, frame_style);
    }

    void draw_axis(SvgPicture& picture, double height) const
    {
        for (const double tick :
             round_ticks(0, static_cast<double>(planes_ - 1), plane_ticks))
            if (tick == std::floor(tick) && tick < static_cast<double>(planes_))
                picture.add_text(
                    {(left_of(tick) + left_of(tick + 1)) / 2, height + line_height},
                    to_text(tick), centred_text);
        picture.add_text({(planes_left + planes_right) / 2, height + 2 * line_height},
                         "drive plane; distance from the exact curve, mm", centred_text);
    }

private:
    double left_of(double plane) const
    {
        return planes_left +
               plane / static_cast<double>(planes_) * (planes_right - planes_left);
    }

    bool differs(double distance, bool is_right) const
    {
        return distance > tolerance_ || !is_right;
    }

    bool has_difference(const MethodRow& row) const
    {
        for (std::size_t k = 0; k < row.distances_mm.size(); ++k)
            if (differs(row.distances_mm[k], row.is_right[k]))
                return true;
        return false;
    }

    void draw_scale(SvgPicture& picture, double top) const
    {
        for (int decade = decades_.low; decade <= decades_.high; ++decade) {
            const double height =
                top + (1 - decades_.share(std::pow(10, decade))) * row_height;
            add_line(picture, {planes_left, height}, {planes_right, height}, grid_style);
            if (decade == decades_.low || decade == decades_.high)
                picture.add_text(
                    {planes_left - 50, height + (decade == decades_.low ? 1 : 10)},
                    to_text(std::pow(10, decade)), small_text);
        }
    }

    // Draws a bar for each column of pixels with a difference.
    void draw_boxes(SvgPicture& picture, const MethodRow& row, double bottom) const
    {
        std::vector<PixelBox> right;
        std::vector<PixelBox> wrong;
        for (std::size_t k = 0; k < row.distances_mm.size();) {
            const int x = static_cast<int>(left_of(static_cast<double>(k)));
            double distance = 0;
            bool is_right = true;
            std::size_t next = k;
            do {
                distance = std::max(distance, row.distances_mm[next]);
                is_right = is_right && row.is_right[next];
                ++next;
            } while (next < row.distances_mm.size() &&
                     static_cast<int>(left_of(static_cast<double>(next))) == x);
            const int end = static_cast<int>(left_of(static_cast<double>(next)));
            if (differs(distance, is_right)) {
                const int height =
                    std::max(2, static_cast<int>(decades_.share(distance) * row_height));
                (is_right ? right : wrong)
                    .push_back({x, static_cast<int>(bottom) - height,
                                std::max(1, end - x - (end - x > 2 ? 1 : 0)), height});
            }
            k = next;
        }
        picture.add_boxes(right, right_colour);
        picture.add_boxes(wrong, wrong_colour);
    }

    Decades decades_;
    double tolerance_;
    std::size_t planes_;
};

// Three significant digits; all digits before the point.
std::string shown_ms(double ms)
{
    const double size = ms > 0 ? std::floor(std::log10(ms)) : 0;
    const double scale = std::pow(10, std::clamp(2 - size, 0.0, 9.0));
    return to_text(std::round(ms * scale) / scale) + " ms";
}

void add_legend(SvgPicture& picture, double height)
{
    const auto add = [&](double x, std::string_view colour, std::string_view text) {
        const PixelBox sample{static_cast<int>(x), static_cast<int>(height) - 10, 14, 12};
        picture.add_boxes(std::array{sample}, colour);
        picture.add_text({x + 20, height}, text, small_text);
    };
    picture.add_disc({margin + 7, height - 4}, median_radius, time_colour);
    picture.add_text({margin + 20, height},
                     "median; the line goes from the lower to the upper quartile",
                     small_text);
    add(planes_left, wrong_colour, "wrong by the exact curve");
    add(planes_left + 190, right_colour, "right, but not the exact curve");
}

}  // namespace

std::string methods_chart_svg(std::span<const MethodRow> rows, const MethodsChart& chart)
{
    check(rows, chart);
    const double head =
        line_height * (2.5 + static_cast<double>(chart.captions.size())) + row_gap;
    const double body = static_cast<double>(rows.size()) * (row_height + row_gap);
    SvgPicture picture{width, head + body + axis_height + legend_height + margin,
                       printable(chart.title, longest_text)};
    picture.add_text({margin, 1.5 * line_height}, printable(chart.title, longest_text),
                     {.size_px = 18, .bold = true});
    double height = 2.5 * line_height;
    for (const std::string& caption : chart.captions) {
        picture.add_text({margin, height}, printable(caption, longest_text), {});
        height += line_height;
    }
    const TimeColumn times{rows};
    const PlaneColumn planes{rows, chart.tolerance_mm};
    double top = head;
    for (const MethodRow& row : rows) {
        picture.add_text({margin, top + row_height / 2 - 2}, row.name,
                         {.size_px = 14, .bold = true});
        picture.add_text({margin, top + row_height / 2 + 16}, shown_ms(row.median_ms),
                         small_text);
        times.draw_row(picture, row, top);
        planes.draw_row(picture, row, top);
        top += row_height + row_gap;
    }
    times.draw_axis(picture, top - row_gap);
    planes.draw_axis(picture, top - row_gap);
    add_legend(picture, top - row_gap + axis_height + legend_height);
    return picture.text();
}

}  // namespace endmill
