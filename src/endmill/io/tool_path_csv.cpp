// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/tool_path_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/numbers.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

constexpr std::string_view location_columns =
    "pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z";
constexpr std::string_view contact_columns =
    ",u,v,contact_x_mm,contact_y_mm,contact_z_mm,normal_x,normal_y,normal_z\n";
constexpr std::string_view no_contact = ",,,,,,,,";
constexpr std::size_t points_per_chunk = 2048;
constexpr std::size_t chunks_per_batch = 64;  // bounds the text that is held twice

// Appends numbers, and copies the text of one that its column had in the row before:
// an axis or the parameter of an iso-line hardly ever changes.
class NumberColumn {
public:
    void append(std::string& text, double value)
    {
        text += ',';
        const std::size_t begin = text.size();
        if (bytes_ > 0 && value == value_) {
            text.append(text, begin_, bytes_);
        } else {
            require(std::isfinite(value), "tool_path_csv: a number is not finite");
            append_text(text, value);
        }
        value_ = value;
        begin_ = begin;
        bytes_ = text.size() - begin;
    }

private:
    double value_ = 0;
    std::size_t begin_ = 0;  // of the text of value_
    std::size_t bytes_ = 0;
};

class RowWriter {
public:
    explicit RowWriter(bool has_patches) : has_patches_{has_patches} {}

    void append(std::string& text, const PathPoint& point)
    {
        text += std::to_string(point.pass);
        text += ',';
        text += std::to_string(point.point);
        text += ',';
        text += move_name(point.move);
        append(text, point.location.tip, 0);
        append(text, point.location.axis, 3);
        if (has_patches_) {
            text += ',';
            text += std::to_string(point.patch);
        }
        if (point.contact) {
            columns_[6].append(text, point.contact->u);
            columns_[7].append(text, point.contact->v);
            append(text, point.contact->contact.point, 8);
            append(text, point.contact->contact.normal, 11);
        } else {
            text += no_contact;
        }
        text += '\n';
    }

private:
    void append(std::string& text, const Vec3& vector, std::size_t column)
    {
        for (int c = 0; c < 3; ++c)
            columns_[column + c].append(text, vector[c]);
    }

    bool has_patches_;
    std::array<NumberColumn, 14> columns_;
};

// The lines of some points, beginning without what came before them: chunks are
// independent of each other.
std::string rows(std::span<const PathPoint> points, bool has_patches)
{
    RowWriter writer{has_patches};
    std::string text;
    for (const PathPoint& point : points)
        writer.append(text, point);
    return text;
}

}  // namespace

std::string tool_path_csv(const ToolPath& path)
{
    const std::span<const PathPoint> points = path.points;
    const bool has_patches =
        std::ranges::any_of(points, [](const PathPoint& p) { return p.patch != 0; });
    std::string csv{location_columns};
    csv += has_patches ? ",patch" : "";
    csv += contact_columns;
    std::vector<std::string> chunks(chunks_per_batch);
    constexpr std::size_t points_per_batch = points_per_chunk * chunks_per_batch;
    for (std::size_t first = 0; first < points.size(); first += points_per_batch) {
        const auto batch =
            points.subspan(first, std::min(points_per_batch, points.size() - first));
        const std::size_t count =
            (batch.size() + points_per_chunk - 1) / points_per_chunk;
        parallel_for(count, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::size_t at = i * points_per_chunk;
                chunks[i] =
                    rows(batch.subspan(at, std::min(points_per_chunk, batch.size() - at)),
                         has_patches);
            }
        });
        for (std::size_t i = 0; i < count; ++i)
            csv += chunks[i];
        if (first == 0)  // the rest will be about as long a point, give or take an eighth
            csv.reserve(csv.size() / batch.size() * points.size() / 8 * 9);
    }
    return csv;
}

}  // namespace endmill
