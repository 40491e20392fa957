// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "drawn_svg.h"
#include "endmill/core/error.h"
#include "endmill/figures/setup_figures.h"
#include "test_meshes.h"

namespace endmill {
namespace {

const std::string cell_colour = "#e9b04a";
const std::string rim_colour = "#a85b00";

// The top of a box is reached from the upper half of the sphere.
struct BoxWithTop {
    TriangleMesh mesh = test::box_mesh({0, 0, 0}, {3, 2, 1});
    SphereGrid grid = sphere_grid("hex:4");
    VisibilityMap map{12, 192};
    std::size_t facet = 0;

    BoxWithTop()
    {
        for (std::size_t k = 0; k < 12; ++k) {
            const auto corners = mesh.corners(k);
            if (corners[0].z() == 1 && corners[1].z() == 1 && corners[2].z() == 1)
                facet = k;
        }
        for (std::size_t cell = 0; cell < grid.cells.size(); ++cell)
            if (grid.centres[cell].z() > 0)
                map.column(cell)[0] |= std::uint64_t{1} << facet;
    }
};

// The rim of the upper half is the equator, at the height of the facet.
TEST(ConeSvg, DrawsTheCellsAndTheRimAboutTheCentroid)
{
    const BoxWithTop box;
    const SetupFigure from_front{.azimuth = Angle::degrees(-90),
                                 .elevation = Angle::degrees(0)};
    const std::string svg = cone_svg(box.mesh, box.facet, box.grid, box.map, from_front);
    const auto cells = lines_of(svg, cell_colour);
    EXPECT_EQ(cells.size(), 96U + 1U);  // half of the cells, and the legend
    const auto rim = lines_of(svg, rim_colour);
    ASSERT_GT(rim.size(), 1U);
    const double height = rim.front().front().y();
    for (std::size_t k = 0; k + 1 < rim.size(); ++k)  // all but the legend
        for (const PixelPoint& point : rim[k])
            EXPECT_NEAR(point.y(), height, 0.1);
    for (std::size_t k = 0; k + 1 < cells.size(); ++k)
        for (const PixelPoint& point : cells[k])
            EXPECT_LE(point.y(), height + 0.1);
}

TEST(ConeSvg, RefusesAFacetOrMapOfAnotherPart)
{
    const BoxWithTop box;
    EXPECT_THROW(cone_svg(box.mesh, 12, box.grid, box.map, {}), DomainError);
    EXPECT_THROW(cone_svg(box.mesh, 0, sphere_grid("hex:3"), box.map, {}), DomainError);
    EXPECT_THROW(cone_svg(box.mesh, 0, box.grid, VisibilityMap{11, 192}, {}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
