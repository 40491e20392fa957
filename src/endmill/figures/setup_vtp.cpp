// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "endmill/core/detail/appended_arrays.h"
#include "endmill/core/error.h"

// The file holds three kinds of cells: the facets of the part, lines for the axes, and
// lines on a sphere around the part for the borders of the motion. One integer for each
// cell, `object`, distinguishes them, so that a viewer can colour or hide them by a
// threshold.

namespace endmill {
namespace {

constexpr double border_step = 0.02;  // rad; chords are within 5e-5 radii of the sphere
constexpr double axis_reach = 1.3;    // length of axes, in radii of the sphere

constexpr std::string_view preamble =
    "<?xml version=\"1.0\"?>\n"
    "<!-- A setup in mm, rotary axes at zero. object: 0 part, 1 tool axis, 2 R1, 3 R2, "
    "4 border of the needed directions, 5 of the machine's. -->\n"
    "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
    "header_type=\"UInt64\">\n";

// Cells of one kind. VTK numbers vertices first, then lines, then polygons.
struct VtkCells {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets;
    std::vector<std::int32_t> objects;

    // Ends a cell whose points have been added.
    void close(SetupObject object)
    {
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        objects.push_back(static_cast<std::int32_t>(object));
    }
};

// Collects the points and cells of the file.
class SetupScene {
public:
    // Points of axes and borders are added after those of the part.
    SetupScene(const TriangleMesh& mesh, const FacetAccess& access,
               const ShownSetup& setup)
        : access_{&access},
          points_{posed_points(mesh, setup)},
          sphere_{sphere_around(points_)}
    {
        add_facets(mesh);
        const RotaryFrame frame = machine_directions(setup);
        add_axis(SetupObject::ToolAxis, frame.tool_axis, 0);
        add_axis(SetupObject::FirstAxis, frame.r1_axis, -axis_reach);
        add_axis(SetupObject::SecondAxis, frame.r2_axis, -axis_reach);
        for (const SetupLine& line : motion_borders(setup, border_step))
            add_line(line);
    }

    // The whole file. VTK expects vertices, lines and polygons in this order.
    std::string text() const
    {
        AppendedArrays arrays;
        std::string file{preamble};
        file += " <PolyData>\n  <Piece NumberOfPoints=\"" +
                std::to_string(points_.size()) + "\" NumberOfVerts=\"" +
                std::to_string(verts_.offsets.size()) + "\" NumberOfLines=\"" +
                std::to_string(lines_.offsets.size()) + "\" NumberOfPolys=\"" +
                std::to_string(polys_.offsets.size()) + "\">\n";
        file += "   <Points>\n" + arrays.append("point_mm", 3, coordinates());
        file += "   </Points>\n   <CellData Scalars=\"object\">\n";
        file += cell_data(arrays) + "   </CellData>\n";
        file += cells("Verts", verts_, arrays) + cells("Lines", lines_, arrays) +
                cells("Polys", polys_, arrays);
        file += "  </Piece>\n </PolyData>\n <AppendedData encoding=\"raw\">\n_";
        file += arrays.bytes();
        return file + "\n </AppendedData>\n</VTKFile>\n";
    }

private:
    // Adds the triangles of the part.
    void add_facets(const TriangleMesh& mesh)
    {
        for (const Triangle& triangle : mesh.triangles()) {
            for (const std::int32_t corner : triangle)
                polys_.connectivity.push_back(corner);
            polys_.close(SetupObject::Facet);
        }
    }

    // Adds an axis from `from` to `axis_reach`, in radii of the sphere.
    void add_axis(SetupObject object, const Vec3& axis, double from)
    {
        add_point(lines_, from * axis);
        add_point(lines_, axis_reach * axis);
        lines_.close(object);
    }

    // Adds a border; one of a single direction becomes a vertex.
    void add_line(const SetupLine& line)
    {
        VtkCells& cells = line.directions.size() == 1 ? verts_ : lines_;
        for (const Vec3& direction : line.directions)
            add_point(cells, direction);
        cells.close(line.object);
    }

    // Adds a point on the sphere around the part, given on the unit sphere.
    void add_point(VtkCells& cells, const Vec3& on_unit_sphere)
    {
        cells.connectivity.push_back(static_cast<std::int64_t>(points_.size()));
        points_.emplace_back(sphere_.centre + sphere_.radius * on_unit_sphere);
    }

    // The coordinates of all points, in mm.
    std::vector<double> coordinates() const
    {
        std::vector<double> numbers;
        numbers.reserve(3 * points_.size());
        for (const Vec3& point : points_)
            numbers.insert(numbers.end(), point.data(), point.data() + 3);
        return numbers;
    }

    // The data of all cells; axes and borders have 0 for the data of facets.
    std::string cell_data(AppendedArrays& arrays) const
    {
        std::vector<std::int32_t> objects = verts_.objects;
        objects.insert(objects.end(), lines_.objects.begin(), lines_.objects.end());
        std::vector<double> fractions(objects.size(), 0);
        std::vector<std::uint8_t> reached(objects.size(), 0);
        objects.insert(objects.end(), polys_.objects.begin(), polys_.objects.end());
        fractions.insert(fractions.end(), access_->visible_fraction.begin(),
                         access_->visible_fraction.end());
        reached.insert(reached.end(), access_->reached_at_zero.begin(),
                       access_->reached_at_zero.end());
        return arrays.append("object", 1, objects) +
               arrays.append("visible_fraction", 1, fractions) +
               arrays.append("reached_at_zero", 1, reached);
    }

    // The XML element of one kind of cells.
    static std::string cells(const std::string& element, const VtkCells& cells,
                             AppendedArrays& arrays)
    {
        return "   <" + element + ">\n" +
               arrays.append("connectivity", 1, cells.connectivity) +
               arrays.append("offsets", 1, cells.offsets) + "   </" + element + ">\n";
    }

    const FacetAccess* access_;
    std::vector<Vec3> points_;  // the part's first
    PartSphere sphere_;
    VtkCells verts_;
    VtkCells lines_;
    VtkCells polys_;
};

}  // namespace

std::string setup_vtp(const TriangleMesh& mesh, const FacetAccess& access,
                      const ShownSetup& setup)
{
    const std::size_t facets = mesh.triangles().size();
    require(facets > 0, "setup_vtp: need a facet");
    require(access.visible_fraction.size() == facets &&
                access.reached_at_zero.size() == facets,
            "setup_vtp: need the access of each facet");
    require(std::ranges::all_of(access.visible_fraction,
                                [](double share) { return 0 <= share && share <= 1; }),
            "setup_vtp: need visible fractions within [0, 1]");
    return SetupScene{mesh, access, setup}.text();
}

}  // namespace endmill
