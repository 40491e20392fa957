// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/axis_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/orientation/detail/axis_smoothing.h"

// The candidates of a contact are directions of a grid that is fixed in space. An axis that
// does not turn at all is then the same state in all layers. On a grid of leads and tilts it
// would change its state, because the frame of the contact turns: steps of the grid are
// larger than the turns between layers, and no path could turn less than the frame.

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;
// Number of candidates that a grid aims at, and along a side of a grid of inclinations.
constexpr int candidates_aim = 81;
constexpr int side_candidates = 9;
// The same where no candidate of the first grid is allowed.
constexpr int fine_side_candidates = 33;
// A range below this width is sampled in the frame of the contact: a grid in space would
// miss it.
constexpr double narrow_range_deg = 1;
// Slack of the ranges in rad, for rounding.
constexpr double range_slack = 1e-9;
// Least number of equal parts of a pass, in contacts, that layers divide it into.
constexpr std::size_t least_parts = 4;
// Rounds after which all contacts between two layers become layers if one of them must.
constexpr int lazy_rounds = 3;

double tangent(const Angle& angle)
{
    return std::tan(angle.radians());
}

void require_sound(const AxisFieldOptions& options)
{
    const double most = Angle::degrees(89).radians();
    for (const LeanRange& range : {options.lead, options.tilt})
        require(-most < range.from.radians() &&
                    range.from.radians() <= range.to.radians() &&
                    range.to.radians() < most,
                "axis_field: need ranges within -89 and 89 degrees in rising order");
    require(options.layer_turn.radians() >= 0 && options.greatest_turn.radians() > 0,
            "axis_field: need a turn of layers from 0 and a greatest turn above 0");
    require(options.lean_weight >= 0 && options.width_weight >= 0 &&
                std::isfinite(options.lean_weight) && std::isfinite(options.width_weight),
            "axis_field: need weights from 0");
    require(options.smoothing_rounds >= 0, "axis_field: need rounds from 0");
}

void require_sound(std::span<const FieldContact> contacts)
{
    double way = -infinity;
    for (const FieldContact& contact : contacts) {
        const Vec3& normal = contact.contact.normal;
        require(std::abs(normal.norm() - 1) < 1e-6 &&
                    std::abs(contact.feed.norm() - 1) < 1e-6 &&
                    std::abs(normal.dot(contact.feed)) < 1e-6,
                "axis_field: need unit normals and feeds at right angles");
        require(contact.way_mm >= way && std::isfinite(contact.way_mm),
                "axis_field: need a way that never decreases");
        way = contact.way_mm;
    }
}

bool is_in(const LeanRange& range, const Angle& angle)
{
    return range.from.radians() - range_slack <= angle.radians() &&
           angle.radians() <= range.to.radians() + range_slack;
}

// The solid angle of the rectangle from (0, 0) to (x, y) at unit distance.
double solid_angle(double x, double y)
{
    return std::atan2(x * y, std::sqrt(1 + x * x + y * y));
}

// Adds inclinations at even steps over both ranges.
void add_frame_grid(const FieldContact& contact, const AxisFieldOptions& options,
                    int most_sides, std::vector<Vec3>& found)
{
    const auto sides = [most_sides](const LeanRange& range) {
        return range.from.radians() < range.to.radians() ? most_sides : 1;
    };
    const auto at = [](const LeanRange& range, int k, int count) {
        const double share = count > 1 ? double(k) / (count - 1) : 0;
        return Angle::radians(std::lerp(range.from.radians(), range.to.radians(), share));
    };
    const int leads = sides(options.lead);
    const int tilts = sides(options.tilt);
    for (int i = 0; i < leads; ++i)
        for (int j = 0; j < tilts; ++j)
            found.push_back(
                inclined_axis(contact.contact.normal, contact.feed,
                              {at(options.lead, i, leads), at(options.tilt, j, tilts)}));
}

// The directions of the grid in space that are within the ranges. Its rows have constant
// latitudes, and their directions are as far apart as the rows.
void add_space_grid(const FieldContact& contact, const AxisFieldOptions& options,
                    std::vector<Vec3>& found)
{
    const std::array<double, 2> leads{tangent(options.lead.from),
                                      tangent(options.lead.to)};
    const std::array<double, 2> tilts{tangent(options.tilt.from),
                                      tangent(options.tilt.to)};
    const double step =
        std::sqrt((solid_angle(leads[1], tilts[1]) - solid_angle(leads[0], tilts[1]) -
                   solid_angle(leads[1], tilts[0]) + solid_angle(leads[0], tilts[0])) /
                  candidates_aim);
    const double lean =
        std::atan(std::hypot(std::max(std::abs(leads[0]), std::abs(leads[1])),
                             std::max(std::abs(tilts[0]), std::abs(tilts[1])))) +
        range_slack;
    const Vec3& normal = contact.contact.normal;
    const double latitude = std::asin(std::clamp(normal.z(), -1.0, 1.0));
    const double azimuth = std::atan2(normal.y(), normal.x());
    const int rows = std::max(1, static_cast<int>(std::ceil(pi / step)));
    const double row_step = pi / rows;
    const auto row_of = [&](double at) {
        return std::clamp(static_cast<int>(std::floor((at + pi / 2) / row_step)), 0,
                          rows - 1);
    };
    for (int row = row_of(latitude - lean); row <= row_of(latitude + lean); ++row) {
        const double at = (row + 0.5) * row_step - pi / 2;
        const double scale = std::cos(at) * std::cos(latitude);
        const double least =
            std::cos(lean) - std::sin(at) * std::sin(latitude);  // of scale cos(azimuth)
        const double half = least <= -scale  ? pi
                            : least >= scale ? 0
                                             : std::acos(least / scale);
        const int count =
            std::max(1, static_cast<int>(std::round(2 * pi * std::cos(at) / step)));
        const double azimuth_step = 2 * pi / count;
        const int first = static_cast<int>(std::ceil((azimuth - half) / azimuth_step));
        const int last =
            std::min(static_cast<int>(std::floor((azimuth + half) / azimuth_step)),
                     first + count - 1);
        for (int k = first; k <= last; ++k) {
            // by the remainder, so that a direction is the same from all contacts
            const double turn = ((k % count + count) % count) * azimuth_step;
            const Vec3 axis{std::cos(at) * std::cos(turn), std::cos(at) * std::sin(turn),
                            std::sin(at)};
            if (axis.dot(normal) > 0 &&
                is_within(options, inclination_of(axis, normal, contact.feed)))
                found.push_back(axis);
        }
    }
}

// An allowed candidate of a layer, in one solution of the machine.
struct State {
    Vec3 axis;
    RotaryPositions positions{0, 0};  // rad
    double cost;                      // degrees, of the lean and the lost width
};

struct Layer {
    std::size_t contact;
    std::vector<State> states;
};

// Chooses the axes of one path.
class FieldSearch {
public:
    FieldSearch(std::span<const FieldContact> contacts, const AxisJudge& judge,
                const AxisFieldOptions& options)
        : contacts_{contacts},
          judge_{judge},
          options_{options},
          is_layer_(contacts.size(), 0)
    {
        choose_layers();
    }

    // Adds layers until the axis is allowed between them.
    AxisField search()
    {
        AxisField field;
        for (int round = 0;; ++round) {
            judge_layers();
            if (!find_path(field))
                continue;  // with more layers
            field.axes = carried();
            if (!add_layers_where_broken(field.axes, round >= lazy_rounds))
                break;
        }
        field.layers = layers_.size();
        smooth(field);
        return field;
    }

private:
    bool starts_pass(std::size_t contact) const
    {
        return contact == 0 || contacts_[contact].starts_pass;
    }

    // Marks ends of passes, contacts after each turn of the normal, and at least some.
    void choose_layers()
    {
        const double least = std::cos(options_.layer_turn.radians());
        std::size_t begin = 0;
        while (begin < contacts_.size()) {
            std::size_t end = begin + 1;
            while (end < contacts_.size() && !starts_pass(end))
                ++end;
            const std::size_t most =
                std::max<std::size_t>(1, (end - begin) / least_parts);
            std::size_t last = begin;
            for (std::size_t k = begin; k < end; ++k) {
                const bool is_turned = contacts_[k].contact.normal.dot(
                                           contacts_[last].contact.normal) <= least;
                if (k == begin || k + 1 == end || is_turned || k - last >= most) {
                    is_layer_[k] = 1;
                    last = k;
                }
            }
            begin = end;
        }
    }

    JudgedAxis judged(std::size_t contact, const Vec3& axis) const
    {
        const FieldContact& at = contacts_[contact];
        if (!(axis.dot(at.contact.normal) > 0))
            return {.broken = AxisRule::Range};
        const Inclination inclination = inclination_of(axis, at.contact.normal, at.feed);
        if (!is_within(options_, inclination))
            return {.broken = AxisRule::Range};
        return judge_(contact, axis, inclination);
    }

    // The cost of a lean in degrees of travel.
    double lean_cost(const FieldContact& at, const Vec3& axis) const
    {
        const Inclination inclination = inclination_of(axis, at.contact.normal, at.feed);
        const double lead = inclination.lead.degrees() - at.wanted.lead.degrees();
        const double tilt = inclination.tilt.degrees() - at.wanted.tilt.degrees();
        return options_.lean_weight * (lead * lead + tilt * tilt);
    }

    void add_states(const Vec3& axis, double cost, std::vector<State>& states) const
    {
        if (!options_.machine) {
            states.push_back({.axis = axis, .cost = cost});
            return;
        }
        for (const RotarySolution& solution : rotary_solutions(*options_.machine, axis))
            if (solution.is_within_limits)
                states.push_back(
                    {.axis = axis, .positions = solution.positions, .cost = cost});
    }

    // The allowed ones of `candidates` as states; notes the rule that removed the last one.
    std::vector<State> allowed_states(std::size_t contact,
                                      std::span<const Vec3> candidates,
                                      AxisRule& last) const
    {
        std::vector<State> states;
        for (const Vec3& axis : candidates) {
            const JudgedAxis found = judged(contact, axis);
            if (found.broken)
                last = std::max(last, *found.broken);
            else
                add_states(axis,
                           lean_cost(contacts_[contact], axis) +
                               options_.width_weight * found.lost_width,
                           states);
        }
        if (states.empty() && options_.machine)
            last = std::max(last, AxisRule::Machine);
        return states;
    }

    std::vector<State> states_at(std::size_t contact) const
    {
        const FieldContact& at = contacts_[contact];
        AxisRule last = AxisRule::Range;
        std::vector<State> states =
            allowed_states(contact, axis_candidates(at, options_), last);
        if (!states.empty())
            return states;
        std::vector<Vec3> finer;
        add_frame_grid(at, options_, fine_side_candidates, finer);
        states = allowed_states(contact, finer, last);
        if (states.empty())
            throw GeometryError{"no tool axis is allowed at contact " +
                                std::to_string(contact) + ", " + place_of(contact) +
                                ": " + std::string{axis_rule_name(last)} +
                                " removes the last one; expected wider ranges of lead "
                                "and tilt (--lead-range, --tilt-range), or a smaller "
                                "cutter"};
        return states;
    }

    std::string place_of(std::size_t contact) const
    {
        const Vec3& point = contacts_[contact].contact.point;
        const auto rounded = [](double value) {
            return to_text(std::round(value * 1e3) / 1e3);
        };
        return "(" + rounded(point.x()) + ", " + rounded(point.y()) + ", " +
               rounded(point.z()) + ") mm";
    }

    // Makes the states of all new layers.
    void judge_layers()
    {
        std::vector<Layer> layers;
        layers.reserve(contacts_.size());
        std::vector<std::size_t> fresh;
        auto old = layers_.begin();
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            if (!is_layer_[k])
                continue;
            if (old != layers_.end() && old->contact == k) {
                layers.push_back(std::move(*old++));
                continue;
            }
            fresh.push_back(layers.size());
            layers.push_back({k, {}});
        }
        layers_ = std::move(layers);
        parallel_for(fresh.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                layers_[fresh[k]].states = states_at(layers_[fresh[k]].contact);
        });
    }

    // Turn of the tool in degrees, or of the axes of the machine.
    double travel(const State& from, const State& to, double chord) const
    {
        if (!options_.machine)
            return 2 * std::asin(std::min(1.0, chord / 2)) * 180 / pi;
        double sum = 0;
        for (std::size_t k = 0; k < 2; ++k) {
            const double way = to.positions[k] - from.positions[k];
            sum += std::abs(is_endless(k) ? std::remainder(way, 2 * pi) : way);
        }
        return sum * 180 / pi;
    }

    bool is_endless(std::size_t axis) const { return endless_[axis]; }

    std::array<bool, 2> endless_axes() const
    {
        std::array<bool, 2> endless{false, false};
        if (options_.machine) {
            const Machine& machine = options_.machine->machine;
            for (std::size_t k = 0; k < machine.configuration.rotary.size(); ++k)
                endless[k] = !std::isfinite(position_range(machine, k).to);
        }
        return endless;
    }

    // The least costs of all states of a layer, from those of the layer before.
    struct Reached {
        std::vector<double> cost;
        std::vector<std::size_t> before;
    };
    Reached reached(const Layer& from, const std::vector<double>& cost,
                    const Layer& to) const
    {
        const bool is_limited = !starts_pass(to.contact);
        const double most =
            2 * std::sin(std::min(pi, options_.greatest_turn.radians()) / 2) +
            range_slack;
        Reached found;
        found.cost.reserve(to.states.size());
        found.before.reserve(to.states.size());
        for (const State& state : to.states) {
            double least = infinity;
            std::size_t best = 0;
            for (std::size_t k = 0; k < from.states.size(); ++k) {
                if (!(cost[k] < least))
                    continue;
                const double chord = (state.axis - from.states[k].axis).norm();
                if (is_limited && chord > most)
                    continue;
                const double sum = cost[k] + travel(from.states[k], state, chord);
                if (sum < least) {
                    least = sum;
                    best = k;
                }
            }
            found.cost.push_back(least + state.cost);
            found.before.push_back(best);
        }
        return found;
    }

    // The shortest path. If no state of a layer is reached, all contacts before it become
    // layers.
    // \return whether there is a path.
    bool find_path(AxisField& field)
    {
        std::vector<std::vector<std::size_t>> before(layers_.size());
        std::vector<double> cost;
        cost.reserve(layers_.front().states.size());
        for (const State& state : layers_.front().states)
            cost.push_back(state.cost);
        for (std::size_t k = 1; k < layers_.size(); ++k) {
            Reached next = reached(layers_[k - 1], cost, layers_[k]);
            if (*std::ranges::min_element(next.cost) == infinity) {
                refine_before(k);
                return false;
            }
            before[k] = std::move(next.before);
            cost = std::move(next.cost);
        }
        const auto best = std::ranges::min_element(cost);
        field.path_cost = *best;
        chosen_.assign(layers_.size(), 0);
        chosen_.back() = static_cast<std::size_t>(best - cost.begin());
        for (std::size_t k = layers_.size() - 1; k > 0; --k)
            chosen_[k - 1] = before[k][chosen_[k]];
        return true;
    }

    void refine_before(std::size_t layer)
    {
        const std::size_t from = layers_[layer - 1].contact;
        const std::size_t to = layers_[layer].contact;
        if (to == from + 1)
            throw GeometryError{
                "no allowed tool axis at contact " + std::to_string(to) + ", " +
                place_of(to) + ", is within " +
                to_text(options_.greatest_turn.written_degrees()) +
                " degrees of those at the contact before; expected wider ranges of lead "
                "and tilt (--lead-range, --tilt-range)"};
        std::fill(is_layer_.begin() + static_cast<std::ptrdiff_t>(from),
                  is_layer_.begin() + static_cast<std::ptrdiff_t>(to), 1);
    }

    // The axes of all contacts: those of the layers, and on great arcs between them.
    std::vector<Vec3> carried() const
    {
        std::vector<Vec3> axes(contacts_.size());
        for (std::size_t k = 0; k < layers_.size(); ++k) {
            const Layer& layer = layers_[k];
            const Vec3& axis = layer.states[chosen_[k]].axis;
            axes[layer.contact] = axis;
            if (k == 0)
                continue;
            const std::size_t from = layers_[k - 1].contact;
            const double start = contacts_[from].way_mm;
            const double length = contacts_[layer.contact].way_mm - start;
            for (std::size_t at = from + 1; at < layer.contact; ++at)
                axes[at] =
                    axis_on_arc(axes[from], axis,
                                length > 0 ? (contacts_[at].way_mm - start) / length : 0);
        }
        return axes;
    }

    // Makes layers of the contacts at which the axis is not allowed, or of all contacts
    // between the layers around them.
    // \return whether there are any.
    bool add_layers_where_broken(const std::vector<Vec3>& axes, bool with_neighbours)
    {
        std::vector<char> is_broken(contacts_.size(), 0);
        parallel_for(contacts_.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                is_broken[k] = !is_layer_[k] && judged(k, axes[k]).broken ? 1 : 0;
        });
        bool has_any = false;
        for (std::size_t k = 0; k < contacts_.size(); ++k) {
            if (!is_broken[k])
                continue;
            has_any = true;
            is_layer_[k] = 1;
            for (std::size_t at = k; with_neighbours && !is_layer_[at - 1]; --at)
                is_layer_[at - 1] = 1;
            for (std::size_t at = k; with_neighbours && !is_layer_[at + 1]; ++at)
                is_layer_[at + 1] = 1;
        }
        return has_any;
    }

    void smooth(AxisField& field) const
    {
        std::vector<SmoothedRow> rows;
        rows.reserve(contacts_.size());
        for (std::size_t k = 0; k < contacts_.size(); ++k)
            rows.push_back({field.axes[k], contacts_[k].way_mm, starts_pass(k)});
        SmoothingLimits limits;
        limits.is_allowed = [&](std::size_t row, const Vec3& axis) {
            return !judged(row, axis).broken;
        };
        limits.greatest_turn = options_.greatest_turn.radians();
        limits.rounds = options_.smoothing_rounds;
        limits.machine = options_.machine;
        SmoothedAxes smooth = smooth_axes(rows, limits);
        field.axes = std::move(smooth.axes);
        field.rough_bend = smooth.rough_bend;
        field.smooth_bend = smooth.smooth_bend;
        field.rounds = smooth.rounds;
    }

    std::span<const FieldContact> contacts_;
    const AxisJudge& judge_;
    const AxisFieldOptions& options_;
    std::array<bool, 2> endless_ = endless_axes();  // rotary axes without limits
    std::vector<char> is_layer_;
    std::vector<Layer> layers_;
    std::vector<std::size_t> chosen_;  // state of each layer
};

}  // namespace

std::string_view axis_rule_name(AxisRule rule)
{
    constexpr std::array<std::string_view, 8> names{
        "the range of lead and tilt", "a gouge beside the contact",
        "the width of the strip",     "the lead that keeps the heel off",
        "the range of the machine",   "the visibility cone",
        "the gap of the cutter",      "the gap of shank or holder"};
    return names[static_cast<std::size_t>(rule)];
}

bool is_within(const AxisFieldOptions& options, const Inclination& inclination)
{
    return is_in(options.lead, inclination.lead) && is_in(options.tilt, inclination.tilt);
}

Inclination inclination_of(const Vec3& axis, const Vec3& normal, const Vec3& feed)
{
    const double up = axis.dot(normal);
    return {Angle::radians(std::atan2(axis.dot(feed), up)),
            Angle::radians(std::atan2(axis.dot(normal.cross(feed)), up))};
}

std::vector<Vec3> axis_candidates(const FieldContact& contact,
                                  const AxisFieldOptions& options)
{
    std::vector<Vec3> found;
    found.reserve(2 * candidates_aim);
    if (is_within(options, contact.wanted))
        found.push_back(
            inclined_axis(contact.contact.normal, contact.feed, contact.wanted));
    const auto is_narrow = [](const LeanRange& range) {
        return range.to.degrees() - range.from.degrees() < narrow_range_deg;
    };
    if (is_narrow(options.lead) || is_narrow(options.tilt))
        add_frame_grid(contact, options, side_candidates, found);
    else
        add_space_grid(contact, options, found);
    return found;
}

AxisField axis_field(std::span<const FieldContact> contacts, const AxisJudge& judge,
                     const AxisFieldOptions& options)
{
    require_sound(options);
    require_sound(contacts);
    if (contacts.empty())
        return {};
    return FieldSearch{contacts, judge, options}.search();
}

}  // namespace endmill
