// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/deviation_svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/figures/detail/deviation_raster.h"
#include "endmill/figures/detail/round_ticks.h"

// The map has three layers: the squares of the raster, each in the colour of its class;
// the marks of the deepest gouge and the largest remaining stock; and beside them a scale
// with all classes. Classes are shares of the limits, so the same colours mean the same
// verdict in every map.

namespace endmill {
namespace {

constexpr double margin_px = 24;
constexpr double title_px = 20;
constexpr double caption_px = 13;
constexpr double line_px = 20;              // distance between captions
constexpr double legend_px = 228;           // width of the scale to the right of the map
constexpr double number_px = 57;            // width of the numbers of the scale
constexpr double left_px = 68;              // left of the map, with the ticks of y
constexpr double tick_px = 5;               // length of a tick
constexpr double tick_distance = 70;        // of neighbouring ticks, at least about
constexpr int swatch_px = 22;               // height of a colour on the scale
constexpr std::size_t shown_caption = 150;  // largest number of characters
// Mean width of a letter of wide fonts, as a share of the font size.
constexpr double letter_width = 0.62;
constexpr double bold_letter_width = 0.72;
constexpr LineStyle frame_style{"#9aa2ab", 1, ""};
constexpr LineStyle mark_style{"#000000", 1.5, ""};
constexpr double mark_radius_px = 7;
constexpr int mark_corners = 24;
constexpr double label_shift_px = 11;
constexpr int label_room_px = 130;  // least width of the map with its labels
// Smaller deviations are rounding errors and are shown as 0.
constexpr double least_shown = 1e-6;  // mm

// Colours of the classes, from the deepest gouge to the most remaining stock. Class k + 1
// begins above edge k of `class_edges`.
constexpr std::array<std::string_view, 12> colours{
    "#5c0a5c", "#c2259f", "#2456b0", "#6f9fdc", "#bcd6f2", "#ececec",
    "#c9e6b4", "#86c76b", "#f6e04b", "#f29a2e", "#c0241c", "#6b0d0d"};
constexpr std::size_t neutral = 5;  // class of deviations below a tenth of a limit

// Names of neighbouring classes on the scale.
struct ClassName {
    std::string_view name;
    std::size_t first;
    std::size_t last;
};

constexpr std::array class_names{
    ClassName{"excessive stock", 10, 11}, ClassName{"remaining stock", 6, 9},
    ClassName{"on size", neutral, neutral}, ClassName{"tolerated gouge", 2, 4},
    ClassName{"excessive gouge", 0, 1}};

// Edges of the classes in mm. The edges at the limits include the slack of the verdict.
std::array<double, colours.size() - 1> class_edges(const DeviationLimits& limits)
{
    const double gouge = limits.tolerance + verdict_slack;
    const double excess = limits.scallop + verdict_slack;
    return {-2 * gouge,   -gouge,       -0.6 * gouge, -0.3 * gouge,
            -0.1 * gouge, 0.1 * excess, 0.3 * excess, 0.6 * excess,
            0.8 * excess, excess,       2 * excess};
}

// The class of a deviation. A deviation equal to an edge belongs to the class nearer to
// zero.
std::size_t class_of(double left, const DeviationLimits& limits)
{
    const auto edges = class_edges(limits);
    const auto above = left < 0 ? std::ranges::upper_bound(edges, left)
                                : std::ranges::lower_bound(edges, left);
    return static_cast<std::size_t>(above - edges.begin());
}

// A length with three significant digits.
std::string shown(double mm)
{
    if (std::abs(mm) < least_shown)
        return "0";
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), mm,
                                   std::chars_format::general, 3);
    return {digits.data(), end.ptr};
}

// Number of letters of this width (px) that fit between the margins.
std::size_t letters_in(double picture_px, double letter_px)
{
    return static_cast<std::size_t>((picture_px - 2 * margin_px) / letter_px);
}

// Appends `text` to `lines`, broken at blanks into lines of at most `most` letters. A
// longer word is cut.
void add_wrapped(std::vector<std::string>& lines, const std::string& text,
                 std::size_t most)
{
    std::string line;
    std::istringstream words{text};
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 1 + word.size() > most)
            lines.push_back(printable(std::exchange(line, ""), most));
        line += (line.empty() ? "" : " ") + word;
    }
    lines.push_back(printable(line, most));
}

// The first caption is the verdict with both maxima and their limits.
std::vector<std::string> caption_lines(const Deviation& deviation,
                                       const DeviationFigure& figure)
{
    const DeviationLimits& limits = figure.limits;
    const std::size_t most = letters_in(figure.width_px, letter_width * caption_px);
    std::vector<std::string> lines;
    add_wrapped(lines,
                std::string{verdict_name(verdict(deviation, limits))} + ": gouge " +
                    shown(deviation.max_gouge_mm) + " mm (tolerance " +
                    shown(limits.tolerance) + " mm), remaining stock " +
                    shown(deviation.max_scallop_mm) + " mm (limit " +
                    shown(limits.scallop) + " mm)",
                most);
    for (const std::string& caption : figure.captions)
        add_wrapped(lines, printable(caption, shown_caption), most);
    return lines;
}

// Positions and sizes in px. Squares have whole px, so that their sides are sharp.
struct Layout {
    double width;   // of the picture
    double height;  // of the picture
    int left;       // of the map
    int top;        // of the map
    int square;     // side of a square
    int map_width;
    int map_height;
    int scale_left;

    Layout(const DeviationFigure& figure, const DeviationRaster& raster,
           std::size_t captions)
        : width{figure.width_px}
    {
        const double room = width - left_px - margin_px - legend_px;
        square =
            std::max(1, static_cast<int>(room / std::max(raster.columns, raster.rows)));
        left = static_cast<int>(left_px);
        // The name of the y axis stands above the map.
        top =
            static_cast<int>(margin_px + title_px +
                             line_px * static_cast<double>(captions + 1) + margin_px / 2);
        // The last column and row may reach beyond the part; the map does not.
        const auto across = [&](double mm) {
            return std::max(square,
                            static_cast<int>(std::lround(square * mm / raster.side)));
        };
        map_width = across(raster.high.x() - raster.low.x());
        map_height = across(raster.high.y() - raster.low.y());
        const int scale = swatch_px * static_cast<int>(colours.size() + 4);
        height = top + std::max(map_height + static_cast<int>(4.5 * line_px), scale) +
                 margin_px;
        scale_left =
            left + std::max(map_width, label_room_px) + static_cast<int>(margin_px);
        width = std::max(width, scale_left + legend_px);
    }
};

// Draws the map, its frame, the scale and the marks.
class DeviationMap {
public:
    DeviationMap(const Deviation& deviation, const DeviationFigure& figure,
                 const DeviationRaster& raster)
        : deviation_{deviation},
          figure_{figure},
          raster_{raster},
          captions_{caption_lines(deviation, figure)},
          layout_{figure, raster, captions_.size()},
          picture_{layout_.width, layout_.height, figure.title}
    {
    }

    // The whole picture. The marks are last, so that they cover the squares.
    std::string text()
    {
        add_heading();
        add_squares();
        add_frame();
        add_scale();
        add_unjudged();
        add_marks();
        return picture_.text();
    }

private:
    // Draws the title and the captions.
    void add_heading()
    {
        double y = margin_px + title_px / 2;
        const std::size_t most = letters_in(layout_.width, bold_letter_width * title_px);
        picture_.add_text({margin_px, y}, printable(figure_.title, most),
                          {title_px, "#222222", true, false});
        for (const std::string& line : captions_)
            picture_.add_text({margin_px, y += line_px}, line,
                              {caption_px, "#222222", false, false});
    }

    // Neighbouring squares of one colour in a row are drawn as one box, cut at the border of
    // the part.
    void add_squares()
    {
        std::array<std::vector<PixelBox>, colours.size()> boxes;
        const int bottom = layout_.top + layout_.map_height;
        const int right = layout_.left + layout_.map_width;
        for (int row = 0; row < raster_.rows; ++row) {
            const int low = bottom - layout_.square * row;
            const int high = std::max(low - layout_.square, layout_.top);
            for (int column = 0; column < raster_.columns;) {
                const auto kind = class_at(column, row);
                int end = column + 1;
                while (end < raster_.columns && class_at(end, row) == kind)
                    ++end;
                const int from = layout_.left + layout_.square * column;
                const int to = std::min(layout_.left + layout_.square * end, right);
                if (kind && from < to && high < low)
                    boxes[*kind].push_back({from, high, to - from, low - high});
                column = end;
            }
        }
        for (std::size_t k = 0; k < colours.size(); ++k)
            picture_.add_boxes(boxes[k], colours[k]);
    }

    // The class of a square; nothing if the part is not visible there.
    std::optional<std::size_t> class_at(int column, int row) const
    {
        const float left = raster_.at(column, row);
        if (left == DeviationRaster::nothing)
            return std::nullopt;
        return class_of(left, figure_.limits);
    }

    // Draws the frame of the map with ticks in mm, and states below how it is read.
    void add_frame()
    {
        const double x = layout_.left;
        const double y = layout_.top;
        const double right = x + layout_.map_width;
        const double bottom = y + layout_.map_height;
        const std::array<PixelPoint, 4> frame{PixelPoint{x, y}, PixelPoint{right, y},
                                              PixelPoint{right, bottom},
                                              PixelPoint{x, bottom}};
        picture_.add_polygon(frame, "none", frame_style);
        add_ticks();
        const TextStyle style{caption_px, "#555555", false, false};
        picture_.add_text({x, bottom + 3 * line_px},
                          "seen from above, along -z; each square, " +
                              shown(raster_.side) + " mm wide,",
                          style);
        picture_.add_text({x, bottom + 4 * line_px},
                          "shows its worst place as a share of its limit", style);
    }

    // Draws the ticks and names of both axes.
    void add_ticks()
    {
        const double left = layout_.left;
        const double bottom = layout_.top + layout_.map_height;
        const double px_per_mm = layout_.square / raster_.side;
        const TextStyle style{caption_px, "#444444", false, true};
        const auto ticks_of = [&](int axis, int length) {
            return ticks_within(raster_.low[axis], raster_.low[axis] + length / px_per_mm,
                                std::max(1, static_cast<int>(length / tick_distance)));
        };
        const std::vector<double> across = ticks_of(0, layout_.map_width);
        for (const double tick : across) {
            const double x = left + px_per_mm * (tick - raster_.low.x());
            picture_.add_polyline(
                std::array<PixelPoint, 2>{PixelPoint{x, bottom}, {x, bottom + tick_px}},
                frame_style);
            picture_.add_text({x, bottom + tick_px + caption_px},
                              tick_text(tick, step_of(across)), style);
        }
        const std::vector<double> upward = ticks_of(1, layout_.map_height);
        for (const double tick : upward) {
            const double y = bottom - px_per_mm * (tick - raster_.low.y());
            picture_.add_polyline(
                std::array<PixelPoint, 2>{PixelPoint{left - tick_px, y}, {left, y}},
                frame_style);
            picture_.add_text({left - tick_px - 19, y + caption_px / 3},
                              tick_text(tick, step_of(upward)), style);
        }
        const TextStyle name{caption_px, "#444444", true, true};
        picture_.add_text(
            {left + layout_.map_width / 2.0, bottom + tick_px + 2.3 * caption_px},
            "x, mm", name);
        picture_.add_text({left - tick_px - 19, layout_.top - caption_px}, "y, mm", name);
    }

    // Draws the scale: remaining stock above, gouges below.
    void add_scale()
    {
        const int x = layout_.scale_left;
        picture_.add_text({x + 0.0, layout_.top + caption_px}, "deviation, mm",
                          {caption_px, "#222222", true, false});
        const auto edges = class_edges(figure_.limits);
        for (std::size_t k = 0; k < colours.size(); ++k) {
            const int y = layout_.top + swatch_px * static_cast<int>(colours.size() - k);
            const PixelBox swatch{x, y, swatch_px, swatch_px};
            picture_.add_boxes(std::span{&swatch, 1}, colours[k]);
            if (k < edges.size())
                picture_.add_text({x + swatch_px + 6.0, y + caption_px / 3},
                                  shown(edges[k]), {caption_px, "#222222", false, false});
        }
        for (const ClassName& named : class_names) {
            const double middle =
                layout_.top +
                swatch_px * (static_cast<double>(colours.size()) + 0.5 -
                             static_cast<double>(named.first + named.last) / 2);
            picture_.add_text({x + swatch_px + 6 + number_px, middle + caption_px / 3},
                              named.name, {caption_px, "#222222", false, false});
        }
    }

    // Explains the squares that have no colour because their stock is not judged.
    void add_unjudged()
    {
        if (!(deviation_.inaccessible_area_mm2 > 0))
            return;
        const double x = layout_.scale_left;
        const double y =
            layout_.top + swatch_px * static_cast<double>(colours.size() + 2);
        const std::array<PixelPoint, 4> plate{
            PixelPoint{x, y}, PixelPoint{x + swatch_px, y},
            PixelPoint{x + swatch_px, y + swatch_px}, PixelPoint{x, y + swatch_px}};
        picture_.add_polygon(plate, "#ffffff", frame_style);
        const TextStyle style{caption_px, "#222222", false, false};
        picture_.add_text({x + swatch_px + 6, y + caption_px}, "not judged: the cutter",
                          style);
        picture_.add_text({x + swatch_px + 6, y + 2.3 * caption_px},
                          "cannot touch the part", style);
    }

    // Marks the extreme places. The label of the upper mark is raised and that of the
    // lower mark lowered, so that they do not overlap.
    void add_marks()
    {
        const auto& rest = deviation_.highest;
        const auto& gouge = deviation_.deepest;
        const bool is_gouge_above =
            rest && gouge && gouge->ray.point.y() > rest->ray.point.y();
        if (rest)
            add_mark(*rest, "remaining ",
                     is_gouge_above ? label_shift_px : -label_shift_px);
        if (gouge)
            add_mark(*gouge, "gouge ", is_gouge_above ? -label_shift_px : label_shift_px);
    }

    // Circles a place and labels it, unless its deviation is below a tenth of the limit.
    void add_mark(const DeviationPlace& place, std::string_view name, double shift_px)
    {
        if (class_of(place.left, figure_.limits) == neutral)
            return;
        const PixelPoint at = pixels(place.ray.point);
        std::array<PixelPoint, mark_corners> ring;
        for (int k = 0; k < mark_corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / mark_corners;
            ring[static_cast<std::size_t>(k)] =
                at + mark_radius_px * PixelPoint{std::cos(angle), std::sin(angle)};
        }
        picture_.add_polygon(ring, "none", mark_style);
        add_label(at + PixelPoint{0, shift_px},
                  std::string{name} + shown(std::abs(place.left)) + " mm");
    }

    // Draws a label on a white plate beside its mark, on the side that has room.
    void add_label(const PixelPoint& at, const std::string& label)
    {
        constexpr double letter_px = letter_width * caption_px;
        const double width = letter_px * static_cast<double>(label.size());
        const double gap = mark_radius_px + 3;
        const bool is_left = at.x() > layout_.left + layout_.map_width / 2.0 &&
                             at.x() > layout_.left + gap + width;
        const double x = is_left ? at.x() - gap - width - 6 : at.x() + gap;
        const double y = at.y() - caption_px / 2 - 3;
        const double right = x + width + 6;
        const double bottom = y + caption_px + 6;
        const std::array<PixelPoint, 4> plate{PixelPoint{x, y}, PixelPoint{right, y},
                                              PixelPoint{right, bottom},
                                              PixelPoint{x, bottom}};
        picture_.add_polygon(plate, "#ffffff", frame_style);
        picture_.add_text({(x + right) / 2, bottom - 6}, label,
                          {caption_px, "#222222", false, true});
    }

    // The place of a point on the map; points outside are moved to the border of the map.
    PixelPoint pixels(const Vec3& point) const
    {
        const double px_per_mm = layout_.square / raster_.side;
        const double x = px_per_mm * (point.x() - raster_.low.x());
        const double y = px_per_mm * (point.y() - raster_.low.y());
        return {layout_.left + std::clamp(x, 0.0, layout_.map_width + 0.0),
                layout_.top + layout_.map_height -
                    std::clamp(y, 0.0, layout_.map_height + 0.0)};
    }

    const Deviation& deviation_;
    const DeviationFigure& figure_;
    const DeviationRaster& raster_;
    std::vector<std::string> captions_;
    Layout layout_;
    SvgPicture picture_;
};

}  // namespace

std::string_view deviation_colour(double left, const DeviationLimits& limits)
{
    return colours[class_of(left, limits)];
}

std::string deviation_svg(const PartCharts& charts, const Deviation& deviation,
                          const DeviationFigure& figure)
{
    require(400 <= figure.width_px && figure.width_px <= 4000,
            "deviation_svg: need 400 <= width_px <= 4000");
    require(1 <= figure.squares && figure.squares <= 1000,
            "deviation_svg: need 1 <= squares <= 1000");
    const DeviationRaster raster =
        deviation_raster(charts, deviation, figure.limits, figure.squares);
    return DeviationMap{deviation, figure, raster}.text();
}

}  // namespace endmill
