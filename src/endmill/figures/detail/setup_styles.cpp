// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/setup_styles.h"

#include <algorithm>
#include <cmath>

namespace endmill {
namespace {

constexpr std::string_view hidden_dashes = "3 4";
constexpr double hidden_width_px = 1.6;

}  // namespace

std::string_view shade(const Shades& shades, double cosine)
{
    constexpr auto count = static_cast<double>(std::tuple_size_v<Shades>);
    const auto step = static_cast<std::size_t>(std::abs(cosine) * count);
    return shades.at(std::min(step, shades.size() - 1));
}

// In the family C,A the first rotary axis and the tool axis are one line at zero.
std::vector<SetupAxis> setup_axes(const RotaryFrame& machine_directions)
{
    const RotaryFrame& frame = machine_directions;
    const bool is_ca = frame.family == RotaryFamily::CA;
    std::vector<SetupAxis> axes{
        {SetupObject::ToolAxis, frame.tool_axis, true, is_ca ? "tool, R1" : "tool"}};
    if (!is_ca)
        axes.push_back({SetupObject::FirstAxis, frame.r1_axis, false, "R1"});
    axes.push_back({SetupObject::SecondAxis, frame.r2_axis, false, "R2"});
    return axes;
}

LineStyle setup_style(SetupObject object)
{
    switch (object) {
        case SetupObject::Facet:
        case SetupObject::ToolAxis:
            return {"#000000", 2, ""};
        case SetupObject::FirstAxis:
            return {"#b8006b", 2, ""};
        case SetupObject::SecondAxis:
            return {"#00785a", 2, ""};
        case SetupObject::NeededMotion:
            return {"#e05a00", 3, ""};
        case SetupObject::MachineMotion:
            return {"#7b3fa0", 2, ""};
    }
    return {};
}

LineStyle hidden_style(SetupObject object)
{
    return {setup_style(object).colour, hidden_width_px, hidden_dashes};
}

// The legend names the tool axis and R1 together if they are one line.
void add_setup_legend(AxonometricFigure& figure, const RotaryFrame& machine_directions)
{
    for (const SetupAxis& axis : setup_axes(machine_directions)) {
        const bool is_both = axis.object == SetupObject::ToolAxis &&
                             machine_directions.family == RotaryFamily::CA;
        std::string label = axis_label(axis.object, machine_directions);
        if (is_both)
            label += ", " + axis_label(SetupObject::FirstAxis, machine_directions);
        figure.add_legend(label, setup_style(axis.object));
    }
}

void add_border_legend(AxonometricFigure& figure, const ShownSetup& setup)
{
    figure.add_legend("motion needed", setup_style(SetupObject::NeededMotion));
    if (setup.limits)
        figure.add_legend("machine's limits", setup_style(SetupObject::MachineMotion));
}

}  // namespace endmill
