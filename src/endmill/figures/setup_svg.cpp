// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/figures/detail/drawn_mesh.h"
#include "endmill/figures/detail/setup_styles.h"

// The figure is drawn in these steps:
//
// 1. The part is turned to the directions of the machine and made coarser if it has too
//    many facets (drawn_mesh.h).
// 2. Each facet gets a colour: by its access, and by the angle between its normal and the
//    direction to the viewer.
// 3. Facets are drawn from back to front in the order of the depth of their centres.
// 4. The axes are divided into short pieces. A piece is drawn if no facet lies between
//    its middle and the viewer.

namespace endmill {
namespace {

constexpr double axis_reach =
    1.2;  // length of axes, in radii of the sphere around the part
constexpr double label_share = 1.07;  // distance of the name over the length of the axis
constexpr int axis_pieces = 80;       // of an axis, tested for visibility one by one
constexpr double swatch_px = 11;
constexpr double seam_px = 0.7;  // outline that hides anti-aliased gaps between facets

constexpr LineStyle part_axis_style{"#b3261e", 2, "7 3"};
constexpr double lean_reach = 1.0;        // radius of the arc of the lean, in radii
constexpr int lean_pieces = 30;           // chords of this arc
constexpr double lean_label_reach = 1.1;  // of the angle, in radii
// Distance of the names of the part's axes over the length of an axis; they are longer than
// those of the machine's.
constexpr double part_label_share = 1.15;

constexpr Shades reached_shades{"#33607f", "#457b9f", "#5b96bd", "#7bb3d6", "#a3cfea"};
constexpr Shades turned_shades{"#8a6a14", "#ac8722", "#cba338", "#e3be5b", "#f3d98c"};

// A facet with its depth and colour.
struct ShadedFacet {
    double depth;  // mm, towards the viewer
    std::array<Vec3, 3> corners;
    std::string_view colour;
};

// Draws one setup.
class SetupPicture {
public:
    // The part is posed first, because the extent of the figure depends on it.
    SetupPicture(const TriangleMesh& mesh, const ShownSetup& setup,
                 const SetupFigure& figure)
        : figure_{&figure},
          points_{posed_points(mesh, setup)},
          sphere_{sphere_around(points_)},
          drawn_{drawn_mesh(points_, mesh.triangles(), figure.most_facets)},
          axes_{machine_directions(setup)},
          part_axes_{part_axes(setup, figure)},
          picture_{options_for(figure, mesh.triangles().size()), extent()},
          toward_{picture_.view().toward}
    {
    }

    // Draws the facets from back to front, then the visible parts of the axes, then the
    // legend.
    std::string text(std::span<const std::uint8_t> reached_at_zero)
    {
        for (std::size_t k = 0; k < drawn_.triangles.size(); ++k)
            add_facet(drawn_.triangles[k], reached_at_zero[drawn_.facets[k]] != 0);
        std::ranges::stable_sort(facets_, {}, &ShadedFacet::depth);
        for (const ShadedFacet& facet : facets_)
            picture_.add_polygon(facet.corners, facet.colour,
                                 {facet.colour, seam_px, ""});
        for (const SetupAxis& axis : setup_axes(axes_))
            add_axis(axis, setup_style(axis.object), label_share);
        for (const SetupAxis& axis : part_axes_)
            add_axis(axis, part_axis_style, part_label_share);
        add_lean();
        add_setup_legend(picture_, axes_);
        if (!part_axes_.empty())
            picture_.add_legend("the part's own axes", part_axis_style);
        picture_.add_legend("reached at zero", {reached_shades[3], swatch_px, ""});
        picture_.add_legend("reached by turning", {turned_shades[3], swatch_px, ""});
        return picture_.text();
    }

private:
    // Adds a caption if the part is drawn coarser than it is.
    FigureOptions options_for(const SetupFigure& figure, std::size_t facets) const
    {
        FigureOptions options{.title = figure.title,
                              .captions = figure.captions,
                              .width_px = figure.width_px,
                              .azimuth = figure.azimuth,
                              .elevation = figure.elevation,
                              .axis_names = {"X", "Y", "Z"}};
        if (drawn_.triangles.size() < facets)
            options.captions.push_back(
                "drawn coarser: " + std::to_string(drawn_.triangles.size()) + " of " +
                std::to_string(facets) + " facets");
        return options;
    }

    // The part's x, y and z that have a name, in coordinates of the machine.
    static std::vector<SetupAxis> part_axes(const ShownSetup& setup,
                                            const SetupFigure& figure)
    {
        std::vector<SetupAxis> axes;
        for (int k = 0; k < 3; ++k)
            if (const std::string& name = figure.part_axis_names.at(k); !name.empty())
                axes.push_back(
                    {SetupObject::Facet, setup.part_to_machine.col(k), true, name});
        return axes;
    }

    // The points of the part and the ends of the axes with their names.
    std::vector<Vec3> extent() const
    {
        std::vector<Vec3> points = points_;
        for (const SetupAxis& axis : part_axes_)
            points.push_back(on_axis(axis, part_label_share));
        for (const SetupAxis& axis : setup_axes(axes_)) {
            points.push_back(on_axis(axis, label_share));
            if (!axis.is_half_line)
                points.push_back(on_axis(axis, -1));
        }
        return points;
    }

    // The point of an axis at a share of its length from the centre of the part.
    Vec3 on_axis(const SetupAxis& axis, double share) const
    {
        return sphere_.centre + share * axis_reach * sphere_.radius * axis.axis;
    }

    // Stores a facet with its depth and its colour.
    void add_facet(const Triangle& triangle, bool is_reached)
    {
        const std::array<Vec3, 3> corners{points_[triangle[0]], points_[triangle[1]],
                                          points_[triangle[2]]};
        const Vec3 normal =
            (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        const double cosine = normal.dot(toward_);
        const Shades& front = is_reached ? reached_shades : turned_shades;
        const Shades& shades = cosine < 0 ? grey_shades : front;
        const double depth = (corners[0] + corners[1] + corners[2]).dot(toward_) / 3;
        facets_.push_back({depth, corners, shade(shades, cosine)});
    }

    // Draws the visible runs of pieces of an axis, and its name.
    void add_axis(const SetupAxis& axis, const LineStyle& style, double name_share)
    {
        const auto end_of = [&](int k) {
            return on_axis(axis, static_cast<double>(k) / axis_pieces);
        };
        std::vector<Vec3> run;
        for (int k = axis.is_half_line ? 0 : -axis_pieces; k < axis_pieces; ++k) {
            if (is_hidden((end_of(k) + end_of(k + 1)) / 2)) {
                run.clear();
                continue;
            }
            if (run.empty())
                run.push_back(end_of(k));
            run.push_back(end_of(k + 1));
            const bool is_last = k + 1 == axis_pieces;
            if (is_last || is_hidden((end_of(k + 1) + end_of(k + 2)) / 2))
                picture_.add_curve(run, style);
        }
        picture_.add_label(on_axis(axis, name_share), {0, 0}, axis.name, style.colour);
    }

    // Draws the arc between the part's z, the last of its axes, and the tool axis, and
    // its angle in tenths of a degree.
    void add_lean()
    {
        if (figure_->part_axis_names[2].empty())
            return;
        const Vec3& from = axes_.tool_axis;
        const Vec3& to = part_axes_.back().axis;
        const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
        const Vec3 across = (to - from.dot(to) * from).stableNormalized();
        const auto at = [&](double share, double reach) {
            const Vec3 direction =
                std::cos(share * angle) * from + std::sin(share * angle) * across;
            return Vec3{sphere_.centre + reach * sphere_.radius * direction};
        };
        std::vector<Vec3> arc;
        for (int k = 0; k <= lean_pieces; ++k)
            arc.push_back(at(static_cast<double>(k) / lean_pieces, lean_reach));
        picture_.add_curve(arc, {part_axis_style.colour, part_axis_style.width_px, ""});
        const double tenths = std::round(10 * Angle::radians(angle).degrees()) / 10;
        picture_.add_label(at(0.5, lean_label_reach), {0, 0}, to_text(tenths) + "°",
                           part_axis_style.colour);
    }

    // Whether a facet lies between the point and the viewer: the line to the viewer
    // passes the three sides of the triangle on the same side, and the facet is nearer.
    bool is_hidden(const Vec3& point) const
    {
        return std::ranges::any_of(facets_, [&](const ShadedFacet& facet) {
            const auto& [a, b, c] = facet.corners;
            const Vec3 from = a - point;
            const Vec3 normal = (b - a).cross(c - a);
            const double rise = normal.dot(toward_);
            if (rise == 0 || normal.dot(from) / rise <= 0)
                return false;
            const auto side = [&](const Vec3& begin, const Vec3& end) {
                return (begin - point).cross(end - point).dot(toward_);
            };
            const double ab = side(a, b);
            const double bc = side(b, c);
            const double ca = side(c, a);
            return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
        });
    }

    const SetupFigure* figure_;
    std::vector<Vec3> points_;
    PartSphere sphere_;
    DrawnMesh drawn_;
    RotaryFrame axes_;
    std::vector<SetupAxis> part_axes_;
    AxonometricFigure picture_;
    Vec3 toward_;
    std::vector<ShadedFacet> facets_;
};

}  // namespace

std::string setup_svg(const TriangleMesh& mesh,
                      std::span<const std::uint8_t> reached_at_zero,
                      const ShownSetup& setup, const SetupFigure& figure)
{
    require(!mesh.triangles().empty(), "setup_svg: need a facet");
    require(reached_at_zero.size() == mesh.triangles().size(),
            "setup_svg: need the access of each facet");
    return SetupPicture{mesh, setup, figure}.text(reached_at_zero);
}

}  // namespace endmill
