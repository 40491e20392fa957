// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <algorithm>
#include <cctype>

#include "endmill/figures/detail/solid_shapes.h"

// A configuration word lists the axes from the workpiece W to the tool T with the bed B
// among them, such as W/caxyBz/T. The axes before B carry the part and are drawn below
// it, those after B carry the tool and are drawn above it. Axes nearer to the bed are
// farther from the part or the tool. A C-shaped bed joins the lowest and the highest
// axis.

namespace endmill {
namespace {

// Sizes of the sketch in mm.
constexpr double pitch = 24;  // from one axis of the stack to the next
constexpr double half_height = 5;
constexpr double part_height = 18;
constexpr double tip_height = 30;  // of the tool tip above the foot of the part
constexpr double tool_length = 26;
constexpr double spindle_length = 16;
constexpr double reach_back = 60;  // depth of the bed behind the axes
constexpr double beam = 5;         // half the thickness of the bed

constexpr SolidColours bed_colours{"#d9d9d9", "#bfbfbf", "#a6a6a6"};
constexpr SolidColours slide_colours{"#dce6ef", "#bccddd", "#9fb6cb"};
constexpr SolidColours part_colours{"#f6ddb0", "#e6c07b", "#cfa257"};
constexpr SolidColours tool_colours{"#8c8c8c", "#6e6e6e", "#545454"};
constexpr SolidColours first_colours{"#f0cfe2", "#dfa6c8", "#cb7fae"};
constexpr SolidColours second_colours{"#c9e6da", "#9ccfbb", "#72b59c"};
constexpr LineStyle linear_style{"#1f4e79", 2, ""};
constexpr LineStyle first_style{"#b8006b", 2, ""};
constexpr LineStyle second_style{"#00785a", 2, ""};
constexpr std::string_view text_colour = "#333333";
constexpr double swatch_px = 11;

// Rotary axes are a, b, c; linear axes are x, y, z.
bool is_rotary(char letter)
{
    return letter <= 'c';
}

// The direction of a linear axis, or of the axis that a rotary axis turns about.
Vec3 axis_of(char letter)
{
    return Vec3::Unit(is_rotary(letter) ? letter - 'a' : letter - 'x');
}

std::string capital(char letter)
{
    return {static_cast<char>(std::toupper(letter))};
}

// Draws a machine from the bed upwards, so that nearer shapes cover the others.
class MachinePicture {
public:
    // The stack of axes below the part and the stack above the tool decide the height.
    MachinePicture(const MachineConfiguration& machine, const FigureOptions& options)
        : machine_{machine},
          letters_{machine.word.substr(2, machine.word.size() - 4)},
          below_{static_cast<int>(letters_.find('B'))},
          above_{static_cast<int>(letters_.size()) - 1 - below_},
          bottom_{-pitch * below_ + half_height},
          top_{tip_height + tool_length + spindle_length + pitch * above_ - half_height},
          figure_{options, extent()}
    {
    }

    // Draws from the bed upwards: the axes that carry the part, the part, the tool, and
    // the axes that carry the tool.
    std::string text()
    {
        add_bed();
        for (int k = below_; k-- > 0;)
            add_axis(letters_[static_cast<std::size_t>(k)], -pitch * (k + 0.5));
        add_box(figure_, {0, 0, part_height / 2}, {17, 13, part_height / 2},
                part_colours);
        figure_.add_label({-17, -13, part_height / 2}, {-24, 0}, "part", text_colour);
        add_tool();
        const double first = tip_height + tool_length + spindle_length + pitch / 2;
        for (int k = 0; k < above_; ++k)
            add_axis(letters_[letters_.size() - 1 - static_cast<std::size_t>(k)],
                     first + pitch * k);
        add_box(figure_, {0, (reach_back - 14) / 2, top_ + beam},
                {18, (reach_back + 14) / 2, beam}, bed_colours);
        figure_.add_label({18, reach_back, (bottom_ + top_) / 2}, {16, 0}, "B",
                          text_colour);
        add_legend();
        return figure_.text();
    }

private:
    // Corners of the box in which everything is drawn.
    std::vector<Vec3> extent() const
    {
        std::vector<Vec3> corners;
        for (const double x : {-30, 45})
            for (const double y : {-45.0, reach_back})
                for (const double z : {bottom_ - 2 * beam, top_ + 2 * beam})
                    corners.emplace_back(x, y, z);
        return corners;
    }

    // Draws the column behind the axes and the foot of the bed.
    void add_bed()
    {
        add_box(figure_, {0, reach_back - beam, (bottom_ + top_) / 2},
                {18, beam, (top_ - bottom_) / 2 + 2 * beam}, bed_colours);
        add_box(figure_, {0, (reach_back - 34) / 2, bottom_ - beam},
                {30, (reach_back + 14) / 2, beam}, bed_colours);
    }

    // Draws the tool and the spindle.
    void add_tool()
    {
        const Vec3 tip{0, 0, tip_height};
        const Vec3 shank = tip + Vec3{0, 0, tool_length};
        add_cylinder(figure_, tip, shank, 3.5, tool_colours);
        add_cylinder(figure_, shank, shank + Vec3{0, 0, spindle_length}, 9,
                     slide_colours);
        figure_.add_label(tip + Vec3{0, 0, tool_length / 2}, {-32, 0}, "tool",
                          text_colour);
    }

    // Whether the axis is R1, the rotary axis nearest to the part.
    bool is_first(char letter) const { return machine_.rotary.front().letter == letter; }

    // Draws one axis of a stack at the given height, in mm.
    void add_axis(char letter, double height)
    {
        const Vec3 middle{0, 0, height};
        const Vec3 axis = axis_of(letter);
        if (is_rotary(letter))
            add_rotary(letter, middle, axis);
        else
            add_linear(letter, middle, axis);
    }

    // An axis about z is a round table; an axis about x or y is a block on a horizontal
    // pin.
    void add_rotary(char letter, const Vec3& middle, const Vec3& axis)
    {
        const SolidColours& colours = is_first(letter) ? first_colours : second_colours;
        const LineStyle& style = is_first(letter) ? first_style : second_style;
        if (letter == 'c') {
            const Vec3 half{0, 0, half_height};
            add_cylinder(figure_, middle - half, middle + half, 22, colours);
            add_turn_arrow(figure_, {middle, axis, 27}, style);
            figure_.add_label(middle + 27 * figure_.view().right, {20, 0}, "c",
                              style.colour);
            return;
        }
        // The pin and its name are drawn at the end that is nearer to the viewer.
        const double side = axis.dot(figure_.view().toward) > 0 ? 1 : -1;
        const Vec3 end = side * axis;
        add_box(figure_, middle, {11, 11, 11}, colours);
        add_cylinder(figure_, middle - 26 * end, middle - 11 * end, 6, colours);
        add_cylinder(figure_, middle + 11 * end, middle + 26 * end, 6, colours);
        figure_.add_curve(std::vector<Vec3>{middle + 26 * end, middle + 42 * end}, style);
        add_turn_arrow(figure_, {middle + 33 * end, axis, 9}, style);
        figure_.add_label(middle + 48 * end, {0, 0}, std::string{letter}, style.colour);
    }

    // A linear axis is a slide with a double arrow in its direction.
    void add_linear(char letter, const Vec3& middle, const Vec3& axis)
    {
        const Vec3 half{26, 20, half_height};
        add_box(figure_, middle, half, slide_colours);
        // The double arrow is drawn on a side of the box where the axis is visible.
        const bool is_y = letter == 'y';
        const bool is_z = letter == 'z';
        const Vec3 beside{is_y || is_z ? half.x() + 5 : 0,
                          is_y ? 0 : -half.y() - (is_z ? 0 : 5), 0};
        const double reach = is_z ? 11 : 18;
        add_double_arrow(figure_, middle + beside - reach * axis,
                         middle + beside + reach * axis, linear_style);
        const double name = is_y ? -reach - 5 : reach + 6;
        figure_.add_label(middle + beside + name * axis,
                          {is_z || is_y ? 9.0 : 0.0, is_z   ? 9.0
                                                     : is_y ? 5.0
                                                            : 0.0},
                          std::string{letter}, linear_style.colour);
    }

    // The legend states what each rotary axis turns.
    void add_legend()
    {
        const auto name = [&](std::size_t k) {
            const RotaryAxis& axis = machine_.rotary[k];
            const bool is_part = axis.side == MachineSide::Table;
            return "R" + std::to_string(k + 1) + " = " + capital(axis.letter) +
                   (is_part ? ", turns the part" : ", turns the tool");
        };
        for (std::size_t k = 0; k < machine_.rotary.size(); ++k)
            figure_.add_legend(
                name(k),
                {k == 0 ? first_colours.middle : second_colours.middle, swatch_px, ""});
        figure_.add_legend("linear axis", {slide_colours.middle, swatch_px, ""});
        figure_.add_legend("bed B", {bed_colours.middle, swatch_px, ""});
    }

    MachineConfiguration machine_;
    std::string letters_;  // the axes of the configuration word, without W/ and /T
    int below_;            // number of axes that carry the part
    int above_;            // number of axes that carry the tool
    double bottom_;
    double top_;
    AxonometricFigure figure_;
};

}  // namespace

// Draws the three linear axes, and on each a circular arrow for the rotary axis about it.
std::string machine_axes_svg(const std::string& title)
{
    const std::vector<Vec3> extent{
        {0, 0, 0}, {66, 0, 0}, {0, 66, 0}, {0, 0, 60}, {30, 0, -16}};
    AxonometricFigure figure{{.title = title,
                              .captions = {"a turn is positive by the right-hand rule"},
                              .width_px = 600,
                              .azimuth = Angle::degrees(35),
                              .elevation = Angle::degrees(25),
                              .axis_names = {"X", "Y", "Z"},
                              .has_length = false},
                             extent};
    for (int k = 0; k < 3; ++k) {
        const Vec3 axis = Vec3::Unit(k);
        figure.add_arrow(Vec3::Zero(), 50 * axis, linear_style);
        figure.add_label(55 * axis, {0, 0}, std::string{char('X' + k)},
                         linear_style.colour);
        add_turn_arrow(figure, {30 * axis, axis, 9}, first_style);
        figure.add_label(30 * axis + 15 * Vec3::Unit((k + 1) % 3), {0, 0},
                         std::string{char('A' + k)}, first_style.colour);
    }
    figure.add_legend("linear axes X, Y, Z", linear_style);
    figure.add_legend("rotary axes A, B, C", first_style);
    return figure.text();
}

std::string machine_svg(const MachineConfiguration& machine, const std::string& title,
                        const std::vector<std::string>& captions)
{
    return MachinePicture{machine,
                          {.title = title,
                           .captions = captions,
                           .width_px = 640,
                           .azimuth = Angle::degrees(-55),
                           .elevation = Angle::degrees(22),
                           .axis_names = {"X", "Y", "Z"},
                           .has_length = false}}
        .text();
}

}  // namespace endmill
