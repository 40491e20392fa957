// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>

#include "endmill/core/detail/number_text.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/joined_rows.h"
#include "endmill/files/detail/rounded_degrees.h"

namespace endmill {
namespace {

// Rows are seldom longer: ten numbers of 17 digits and two words.
constexpr std::size_t usual_row_bytes = 256;

// The text of one row, which is made without a string: there are millions of rows.
class RowText {
public:
    void add(std::string_view word) { end_ = std::ranges::copy(word, end_).out; }

    void add(int number)
    {
        end_ = std::to_chars(end_, row_.data() + row_.size(), number).ptr;
    }

    // Adds a cell; an empty one if there is no number.
    void add_cell(std::optional<double> number)
    {
        require(!number || std::isfinite(*number), "feed_csv: a number is not finite");
        *end_++ = ',';
        if (number)
            end_ = write_number(end_, *number);
    }

    // Adds an angle in degrees; an empty cell if it is unknown.
    void add_degrees(std::optional<double> radians)
    {
        std::optional<double> degrees;
        if (radians)
            degrees = rounded_degrees(*radians);
        add_cell(degrees);
    }

    std::string_view text() const
    {
        return {row_.data(), static_cast<std::size_t>(end_ - row_.data())};
    }

private:
    // A row has 2 whole numbers, 2 words of at most 20 characters and 13 numbers.
    std::array<char, 16 * longest_number_text + 64> row_;
    char* end_ = row_.data();
};

// Adds the columns of the geometry of a move.
void add_geometry(RowText& row, const SegmentCut& cut)
{
    row.add(cut.pass);
    row.add(",");
    row.add(cut.point);
    row.add_cell(cut.length_mm);
    row.add_degrees(cut.mu);
    row.add_degrees(cut.lambda);
    row.add_cell(cut.pick_feed_mm);
    row.add_cell(cut.pick_feed_horizontal_mm);
    row.add_cell(cut.depth_mm);
}

// Adds the columns of the feed and the loads of a move.
void add_feed(RowText& row, const SegmentFeed& feed)
{
    row.add_degrees(feed.engaged_angle);
    row.add_cell(feed.tooth.feed_per_tooth_mm);
    row.add_cell(feed.peak_factor);
    row.add(",");
    row.add(feed_limit_name(reported_limit(feed)));
    row.add(",");
    row.add(speed_limit_name(feed.table.speed_limit));
    row.add_cell(feed.loads.cutting_force_n);
    row.add_cell(feed.loads.thrust_n);
    row.add_cell(feed.loads.torque_n_m);
    row.add_cell(feed.table.power_w);
    row.add("\n");
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
        RowText row;
        add_geometry(row, cuts[i]);
        add_feed(row, rows[i]);
        text += row.text();
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
