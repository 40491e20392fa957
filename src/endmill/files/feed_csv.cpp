// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/joined_rows.h"
#include "endmill/files/detail/rounded_degrees.h"

namespace endmill {
namespace {

// Rows are seldom longer: ten numbers of 17 digits and two words.
constexpr std::size_t usual_row_bytes = 256;

// Appends a cell; an empty one if there is no number.
void append(std::string& text, std::optional<double> number)
{
    require(!number || std::isfinite(*number), "feed_csv: a number is not finite");
    text += ',';
    if (number)
        append_text(text, *number);
}

// Appends an angle in degrees; an empty cell if it is unknown.
void append_degrees(std::string& text, std::optional<double> radians)
{
    std::optional<double> degrees;
    if (radians)
        degrees = rounded_degrees(*radians);
    append(text, degrees);
}

// Appends the columns of the geometry of a move.
void append_geometry(std::string& text, const SegmentCut& cut)
{
    text += std::to_string(cut.pass) + ',' + std::to_string(cut.point);
    append(text, cut.length_mm);
    append_degrees(text, cut.mu);
    append_degrees(text, cut.lambda);
    append(text, cut.pick_feed_mm);
    append(text, cut.pick_feed_horizontal_mm);
    append(text, cut.depth_mm);
}

// Appends the columns of the feed and the loads of a move.
void append_feed(std::string& text, const SegmentFeed& row)
{
    append_degrees(text, row.engaged_angle);
    append(text, row.tooth.feed_per_tooth_mm);
    append(text, row.peak_factor);
    text += ',';
    text += feed_limit_name(reported_limit(row));
    text += ',';
    text += speed_limit_name(row.table.speed_limit);
    append(text, row.loads.cutting_force_n);
    append(text, row.loads.thrust_n);
    append(text, row.loads.torque_n_m);
    append(text, row.table.power_w);
}

}  // namespace

void write_feed_csv(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows,
                    const std::function<void(std::string_view piece)>& sink)
{
    require(cuts.size() == rows.size(), "feed_csv: need one row for each move");
    sink(
        "pass,point,length_mm,mu_deg,lambda_deg,pick_feed_mm,pick_feed_horizontal_mm,"
        "depth_mm,engaged_angle_deg,feed_per_tooth_mm,peak_factor,limit,speed_limit,"
        "cutting_force_n,thrust_n,torque_n_m,power_w\n");
    write_feed_rows(cuts, rows, sink);
}

std::string feed_rows(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows)
{
    require(cuts.size() == rows.size(), "feed_csv: need one row for each move");
    std::string text;
    text.reserve(rows.size() * usual_row_bytes);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        append_geometry(text, cuts[i]);
        append_feed(text, rows[i]);
        text += '\n';
    }
    return text;
}

void write_feed_rows(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows,
                     const std::function<void(std::string_view piece)>& sink)
{
    require(cuts.size() == rows.size(), "feed_csv: need one row for each move");
    pass_rows(
        rows.size(),
        [&](std::size_t first, std::size_t count) {
            return feed_rows(cuts.subspan(first, count), rows.subspan(first, count));
        },
        sink);
}

std::string feed_csv(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows)
{
    std::string text;
    write_feed_csv(cuts, rows, [&](std::string_view piece) { text += piece; });
    return text;
}

std::string force_profile_csv(std::span<const double> angles,
                              std::span<const CuttingForce> forces)
{
    require(angles.size() == forces.size(),
            "force_profile_csv: need one angle for each force");
    std::string text = "theta_deg,force_x_n,force_y_n,force_z_n,torque_n_m\n";
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const double degrees = rounded_degrees(angles[i]);
        for (const double number :
             {degrees, forces[i].x_n, forces[i].y_n, forces[i].z_n}) {
            require(std::isfinite(number), "force_profile_csv: a number is not finite");
            append_text(text, number);
            text += ',';
        }
        require(std::isfinite(forces[i].torque_n_m),
                "force_profile_csv: a number is not finite");
        append_text(text, forces[i].torque_n_m);
        text += '\n';
    }
    return text;
}

}  // namespace endmill
