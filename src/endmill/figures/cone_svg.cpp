// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/figures/detail/drawn_mesh.h"
#include "endmill/figures/detail/setup_styles.h"

// The part is drawn from back to front, then the cells of the cone from back to front, and
// last the rim of the cone with lines from the centroid.

namespace endmill {
namespace {

constexpr double cone_reach = 0.6;  // radius of the cone, in radii of the part's sphere
constexpr double seam_px = 0.7;     // outline that hides gaps between facets
constexpr double centroid_px = 3.5;
constexpr double swatch_px = 11;
// Every so many points of the rim a line goes to the centroid.
constexpr int rim_points_a_ray = 4;
constexpr std::string_view facet_colour = "#1f5f8b";
constexpr LineStyle cell_style{"#e9b04a", 0.7, ""};
constexpr LineStyle rim_style{"#a85b00", 1.8, ""};
constexpr LineStyle ray_style{"#a85b00", 0.8, ""};

// A side of a cell on the rim of the cone.
using RimSide = std::pair<std::int32_t, std::int32_t>;

// The sides of cells of the cone whose other cell is not in the cone.
std::vector<RimSide> rim_of(const SphereGrid& grid, const std::vector<std::size_t>& cone)
{
    std::map<RimSide, int> uses;
    for (const std::size_t cell : cone)
        for (std::size_t side = 0; side < 3; ++side)
            ++uses[std::minmax(
                {grid.cells[cell][side], grid.cells[cell][(side + 1) % 3]})];
    std::vector<RimSide> rim;
    for (const auto& [side, count] : uses)
        if (count == 1)
            rim.push_back(side);
    return rim;
}

// Draws the cone of one facet.
class ConePicture {
public:
    ConePicture(const TriangleMesh& mesh, std::size_t facet, const SphereGrid& grid,
                const SetupFigure& figure)
        : mesh_{&mesh},
          grid_{&grid},
          sphere_{sphere_around({mesh.points().begin(), mesh.points().end()})},
          corners_{mesh.corners(facet)},
          centroid_{(corners_[0] + corners_[1] + corners_[2]) / 3},
          picture_{options_for(figure), extent()}
    {
    }

    std::string text(const std::vector<std::size_t>& cone, const SetupFigure& figure)
    {
        add_part(figure.most_facets);
        picture_.add_polygon(corners_, facet_colour, {facet_colour, seam_px, ""});
        for (const std::size_t cell : cone)
            add_cell(cell);
        add_rim(rim_of(*grid_, cone));
        picture_.add_disc(centroid_, centroid_px, facet_colour);
        picture_.add_legend("the facet", {facet_colour, swatch_px, ""});
        picture_.add_legend("cells of its cone", cell_style);
        picture_.add_legend("rim of the cone", rim_style);
        return picture_.text();
    }

private:
    static FigureOptions options_for(const SetupFigure& figure)
    {
        return {.title = figure.title,
                .captions = figure.captions,
                .width_px = figure.width_px,
                .azimuth = figure.azimuth,
                .elevation = figure.elevation,
                .has_length = false};
    }

    // The point of the cone above the centroid in a direction.
    Vec3 above(const Vec3& direction) const
    {
        return centroid_ + cone_reach * sphere_.radius * direction;
    }

    // The part, and the sphere that holds the cone.
    std::vector<Vec3> extent() const
    {
        std::vector<Vec3> points{mesh_->points().begin(), mesh_->points().end()};
        for (const Vec3& direction : grid_->corners)
            points.push_back(above(direction));
        return points;
    }

    void add_part(std::size_t most_facets)
    {
        const DrawnMesh drawn =
            drawn_mesh(mesh_->points(), mesh_->triangles(), most_facets);
        const Vec3 toward = picture_.view().toward;
        std::vector<std::pair<double, std::array<Vec3, 3>>> by_depth;
        for (const auto& [a, b, c] : drawn.triangles) {
            const std::array<Vec3, 3> corners{mesh_->points()[a], mesh_->points()[b],
                                              mesh_->points()[c]};
            by_depth.emplace_back((corners[0] + corners[1] + corners[2]).dot(toward),
                                  corners);
        }
        std::ranges::stable_sort(by_depth, {}, [](const auto& one) { return one.first; });
        for (const auto& [depth, corners] : by_depth) {
            const Vec3 normal =
                (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
            const std::string_view colour = shade(grey_shades, normal.dot(toward));
            picture_.add_polygon(corners, colour, {colour, seam_px, ""});
        }
    }

    void add_cell(std::size_t cell)
    {
        std::vector<Vec3> outline;
        for (const std::int32_t corner : grid_->cells[cell])
            outline.push_back(above(grid_->corners[corner]));
        outline.push_back(outline.front());
        picture_.add_curve(outline, cell_style);
    }

    void add_rim(const std::vector<RimSide>& rim)
    {
        int number = 0;
        for (const auto& [from, to] : rim) {
            const Vec3 begin = above(grid_->corners[from]);
            picture_.add_curve(std::array{begin, above(grid_->corners[to])}, rim_style);
            if (number++ % rim_points_a_ray == 0)
                picture_.add_curve(std::array{centroid_, begin}, ray_style);
        }
    }

    const TriangleMesh* mesh_;
    const SphereGrid* grid_;
    PartSphere sphere_;
    std::array<Vec3, 3> corners_;
    Vec3 centroid_;
    AxonometricFigure picture_;
};

}  // namespace

std::string cone_svg(const TriangleMesh& mesh, std::size_t facet, const SphereGrid& grid,
                     const VisibilityMap& map, const SetupFigure& figure)
{
    require(map.facets() == mesh.triangles().size() && map.cells() == grid.cells.size(),
            "cone_svg: need the map of this part and grid");
    require(facet < map.facets(), "cone_svg: need a facet of the part");
    std::vector<std::size_t> cone;
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        if (map.is_accessible(facet, cell))
            cone.push_back(cell);
    return ConePicture{mesh, facet, grid, figure}.text(cone, figure);
}

}  // namespace endmill
