// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/joined_rows.h"

// A section has coordinates (s, z) in its drive plane. The rows also have x and y if the
// position of the planes in space is known, so that the file can be drawn in space
// without the frame.

namespace endmill {
namespace {

constexpr std::string_view point_header = "plane,curve,point,s_mm,x_mm,y_mm,z_mm\n";

// Appends a number.
void append(std::string& text, double number)
{
    require(std::isfinite(number), "section CSV: a number is not finite");
    append_text(text, number);
}

// The rows of one plane.
class PlaneRows {
public:
    // Position `plane` of `placed` is that of the plane, if there is any.
    PlaneRows(const DrivePlanes* placed, std::size_t plane)
        : placed_{placed},
          plane_{plane}
    {
        require(!placed || plane < placed->positions.size(),
                "section CSV: more planes than positions");
    }

    // Appends the row of a point. Its place in space follows from the position of the
    // plane.
    void add(std::size_t curve, std::size_t point, const SectionPoint& at)
    {
        text_ += std::to_string(plane_) + ',' + std::to_string(curve) + ',' +
                 std::to_string(point) + ',';
        append(text_, at.x());
        if (placed_) {
            const Vec3 place =
                placed_->frame.point(at.x(), placed_->positions[plane_], at.y());
            text_ += ',';
            append(text_, place.x());
            text_ += ',';
            append(text_, place.y());
        } else {
            text_ += ",,";
        }
        text_ += ',';
        append(text_, at.y());
        text_ += '\n';
    }

    // The whole text.
    std::string take() { return std::move(text_); }

private:
    const DrivePlanes* placed_;
    std::size_t plane_;
    std::string text_;
};

// Collects the pieces of a table in a text.
template <typename Write>
std::string whole(const Write& write)
{
    std::string text;
    write([&](std::string_view piece) { text += piece; });
    return text;
}

// Writes the rows of the points of all curves. `position` gives the place of a point in its
// plane.
template <typename Plane, typename Position>
void write_rows(std::span<const Plane> planes, const DrivePlanes* placed,
                const Position& position,
                const std::function<void(std::string_view piece)>& sink)
{
    sink(point_header);
    pass_texts(
        planes.size(),
        [&](std::size_t p) {
            PlaneRows rows{placed, p};
            const auto& curves = planes[p].curves;
            for (std::size_t c = 0; c < curves.size(); ++c)
                for (std::size_t k = 0; k < curves[c].points.size(); ++k)
                    rows.add(c, k, position(curves[c].points[k]));
            return rows.take();
        },
        sink);
}

}  // namespace

void write_sections_csv(std::span<const PlaneSection> planes, const DrivePlanes* placed,
                        const std::function<void(std::string_view piece)>& sink)
{
    write_rows(planes, placed, std::identity{}, sink);
}

std::string sections_csv(std::span<const PlaneSection> planes, const DrivePlanes* placed)
{
    return whole([&](const auto& sink) { write_sections_csv(planes, placed, sink); });
}

void write_trimmed_csv(std::span<const Trimmed> planes, const DrivePlanes* placed,
                       const std::function<void(std::string_view piece)>& sink)
{
    write_rows(
        planes, placed, [](const auto& point) -> const SectionPoint& { return point.at; },
        sink);
}

std::string trimmed_csv(std::span<const Trimmed> planes, const DrivePlanes* placed)
{
    return whole([&](const auto& sink) { write_trimmed_csv(planes, placed, sink); });
}

std::string loops_csv(std::span<const std::vector<CutOut>> planes, LoopColumns columns)
{
    const bool has_rule = columns == LoopColumns::CauseAndRule;
    std::string text = "plane,curve,s_mm,z_mm,first_point,last_point,cause";
    text += has_rule ? ",rule\n" : "\n";
    for (std::size_t p = 0; p < planes.size(); ++p)
        for (const CutOut& cut : planes[p]) {
            text += std::to_string(p) + ',' + std::to_string(cut.curve) + ',';
            if (cut.place)
                append(text, cut.place->x());
            text += ',';
            if (cut.place)
                append(text, cut.place->y());
            text += ',' + std::to_string(cut.first_point) + ',' +
                    std::to_string(cut.last_point) + ',';
            text += name(cut.cause);
            if (has_rule)
                text += ',' + std::string{cut.rule};
            text += '\n';
        }
    return text;
}

}  // namespace endmill
