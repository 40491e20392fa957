// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/vtk.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "endmill/core/detail/appended_arrays.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

static_assert(static_cast<int>(Move::Cut) == 0 && static_cast<int>(Move::Link) == 1 &&
                  static_cast<int>(Move::Rapid) == 2 &&
                  static_cast<int>(Move::Plunge) == 3 &&
                  static_cast<int>(Move::Retract) == 4,
              "the comment in the file explains these numbers");

constexpr std::string_view preamble =
    "<?xml version=\"1.0\"?>\n"
    "<!-- Tool path: tips in mm. "
    "move: 0 cut, 1 link, 2 rapid, 3 plunge, 4 retract. -->\n"
    "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
    "header_type=\"UInt64\">\n";

// The cells of the file: `connectivity` lists the points of all, one line after another.
struct Polylines {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets;  // one past the last point of each in connectivity
    std::vector<std::int32_t> pass;
    std::vector<std::int32_t> piece;  // number of the run of cuts, or of the next one
    std::vector<std::uint8_t> move;
};

// One polyline for each run of moves of one kind in one pass.
Polylines runs_of_one_move(const std::vector<PathPoint>& points)
{
    Polylines lines;
    std::int32_t piece = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const PathPoint& point = points[i];
        const bool goes_on = !lines.pass.empty() && lines.pass.back() == point.pass &&
                             lines.move.back() == static_cast<std::uint8_t>(point.move);
        if (point.move != Move::Cut && !lines.move.empty() &&
            lines.move.back() == static_cast<std::uint8_t>(Move::Cut))
            ++piece;
        if (!goes_on) {
            // A move ends at its point, so the line begins at the point before.
            lines.connectivity.push_back(static_cast<std::int64_t>(i - 1));
            lines.offsets.push_back(0);
            lines.pass.push_back(point.pass);
            lines.piece.push_back(piece);
            lines.move.push_back(static_cast<std::uint8_t>(point.move));
        }
        lines.connectivity.push_back(static_cast<std::int64_t>(i));
        lines.offsets.back() = static_cast<std::int64_t>(lines.connectivity.size());
    }
    return lines;
}

// The numbers `values_of(point)` of all points in order.
template <class Function>
std::vector<double> per_point(const std::vector<PathPoint>& points, Function values_of)
{
    std::vector<double> numbers;
    for (const PathPoint& point : points) {
        const auto values = values_of(point);
        for (const double value : values) {
            require(std::isfinite(value), "tool_path_vtp: a number is not finite");
            numbers.push_back(value);
        }
    }
    return numbers;
}

// The contact point; the tip where there is no contact.
Vec3 contact_point(const PathPoint& point)
{
    return point.contact() ? point.contact()->contact.point : point.location.tip;
}

// The normal at the contact; the axis where there is no contact.
Vec3 contact_normal(const PathPoint& point)
{
    return point.contact() ? point.contact()->contact.normal : point.location.axis;
}

// The elements of the point data; their arrays are appended.
std::string point_data(const std::vector<PathPoint>& points, AppendedArrays& arrays)
{
    std::vector<std::uint8_t> has_contact;
    has_contact.reserve(points.size());
    for (const PathPoint& point : points)
        has_contact.push_back(point.contact() ? 1 : 0);
    using Scalar = std::array<double, 1>;
    const auto u = [](const PathPoint& p) {
        return Scalar{p.contact() ? p.contact()->u : 0};
    };
    const auto v = [](const PathPoint& p) {
        return Scalar{p.contact() ? p.contact()->v : 0};
    };
    const auto axis = [](const PathPoint& p) { return p.location.axis; };

    std::string xml = "   <PointData>\n";
    xml += arrays.append("axis", 3, per_point(points, axis));
    xml += arrays.append("has_contact", 1, has_contact);
    xml += arrays.append("contact", 3, per_point(points, contact_point));
    xml += arrays.append("normal", 3, per_point(points, contact_normal));
    xml += arrays.append("u", 1, per_point(points, u));
    xml += arrays.append("v", 1, per_point(points, v));
    return xml + "   </PointData>\n";
}

// The elements of the polylines and their cell data; their arrays are appended.
std::string polyline_data(const Polylines& lines, AppendedArrays& arrays)
{
    std::string xml = "   <Lines>\n";
    xml += arrays.append("connectivity", 1, lines.connectivity);
    xml += arrays.append("offsets", 1, lines.offsets);
    xml += "   </Lines>\n   <CellData>\n";
    xml += arrays.append("pass", 1, lines.pass);
    xml += arrays.append("piece", 1, lines.piece);
    xml += arrays.append("move", 1, lines.move);
    return xml + "   </CellData>\n";
}

}  // namespace

std::string tool_path_vtp(const ToolPath& path)
{
    const std::vector<PathPoint>& points = path.points;
    const Polylines lines = runs_of_one_move(points);
    const auto tip = [](const PathPoint& point) { return point.location.tip; };

    AppendedArrays arrays;
    std::string file{preamble};
    file += " <PolyData>\n  <Piece NumberOfPoints=\"" + std::to_string(points.size()) +
            "\" NumberOfLines=\"" + std::to_string(lines.offsets.size()) + "\">\n";
    file += "   <Points>\n" + arrays.append("tip_mm", 3, per_point(points, tip)) +
            "   </Points>\n";
    file += point_data(points, arrays);
    file += polyline_data(lines, arrays);
    file += "  </Piece>\n </PolyData>\n <AppendedData encoding=\"raw\">\n_";
    file += arrays.bytes();
    file += "\n </AppendedData>\n</VTKFile>\n";
    return file;
}

}  // namespace endmill
