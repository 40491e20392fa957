// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/tool_path_svg.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_svg.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

// The rectangle 60 x 30 mm, lifted by `height` in the middle of each patch.
Surface plate(double height)
{
    std::vector<Vec3> net;
    for (int j = 0; j <= 3; ++j)
        for (int i = 0; i <= 6; ++i)
            net.emplace_back(10 * i, 10 * j, i % 3 == 0 || j % 3 == 0 ? 0 : height);
    return composite_bezier(2, 1, net);
}

SurfaceDrawing from_above()
{
    SurfaceDrawing drawing;
    drawing.figure.azimuth = Angle::degrees(-90);
    drawing.figure.elevation = Angle::degrees(90);
    return drawing;
}

std::vector<std::vector<PixelPoint>> polygons_of(const std::string& svg)
{
    std::vector<std::vector<PixelPoint>> polygons;
    for (const XmlElement& element : SmallXml::parse(svg))
        if (element.name == "path" && element.attributes.at("fill") != "none")
            polygons.push_back(points_of(element.attributes.at("d")));
    return polygons;
}

double area(const std::vector<PixelPoint>& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const PixelPoint& a = polygon[i];
        const PixelPoint& b = polygon[(i + 1) % polygon.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return std::abs(twice) / 2;
}

// Seen from above, the cells tile the rectangle.
TEST(SurfaceSvg, CoversTheSurfaceWithItsCells)
{
    SurfaceDrawing drawing = from_above();
    drawing.spaces_per_patch = 5;
    const std::string svg = surface_svg(plate(40), drawing);
    const auto cells = polygons_of(svg);
    ASSERT_EQ(cells.size(), 2U * 5 * 5);
    double sum = 0;
    double left = cells[0][0].x();
    double right = left;
    for (const auto& cell : cells) {
        sum += area(cell);
        for (const PixelPoint& point : cell) {
            left = std::min(left, point.x());
            right = std::max(right, point.x());
        }
    }
    const double scale = (right - left) / 60;
    EXPECT_NEAR(sum / (scale * scale), 60 * 30, 2);
}

// The last thing drawn at a place is what the viewer sees: cells come from far to near.
TEST(SurfaceSvg, DrawsNearerCellsLater)
{
    SurfaceDrawing drawing;
    drawing.figure.elevation = Angle::degrees(0);
    drawing.figure.azimuth = Angle::degrees(-90);  // the viewer looks along +y
    std::vector<Vec3> net;
    for (int j = 0; j <= 3; ++j)
        for (int i = 0; i <= 3; ++i)
            net.emplace_back(10 * i, 10 * j, 7 * j);
    drawing.spaces_per_patch = 4;
    const auto cells = polygons_of(surface_svg(composite_bezier(1, 1, net), drawing));
    ASSERT_EQ(cells.size(), 16U);
    for (std::size_t k = 4; k < cells.size(); ++k)
        EXPECT_GT(cells[k][0].y(), cells[k - 4][0].y());  // the far rows stand higher
}

TEST(SurfaceSvg, MarksThePatchBordersAndTheNetOnDemand)
{
    const std::string without = surface_svg(plate(40), from_above());
    EXPECT_FALSE(lines_of(without, "#12365f").empty());
    EXPECT_TRUE(lines_of(without, "#c2702a").empty());
    SurfaceDrawing drawing = from_above();
    drawing.control_net = true;
    const std::string with = surface_svg(plate(40), drawing);
    EXPECT_EQ(lines_of(with, "#c2702a").size(), 2U * 8 + 1);  // and the legend's sample
}

TEST(SurfaceSvg, NeedsAtLeastOneSpaceAPatch)
{
    SurfaceDrawing drawing;
    drawing.spaces_per_patch = 0;
    EXPECT_THROW(surface_svg(plate(0), drawing), DomainError);
    drawing.spaces_per_patch = 1;
    EXPECT_EQ(polygons_of(surface_svg(plate(0), drawing)).size(), 2U);
}

}  // namespace
}  // namespace endmill
