// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/certified_inflow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "endmill/bound/detail/centred_form.h"
#include "endmill/bound/detail/raised_point.h"

namespace endmill {
namespace {

// Directions of travel. The greatest inflow of all directions exceeds that of these by a
// factor of one over the cosine of half the angle between two, 1.0021.
constexpr int directions = 48;
// Intervals of the ray angle.
constexpr int arcs = 72;
// Halvings of an interval at whose rays the boundary of D(x) may meet the border.
constexpr int arc_halvings = 3;
// Steps of Newton's method on a ray.
constexpr int most_steps = 50;
// Widenings of the first enclosure of a radius.
constexpr int widenings = 6;
constexpr std::string_view no_normal = "the surface may have no normal";

using CentredVector = std::array<CentredForm, 3>;

CentredForm dot(const CentredVector& a, const CentredVector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Interval dot(const IntervalVector& a, const IntervalVector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// x a + y b for numbers or intervals x and y.
template <typename Factor>
IntervalVector combined(const Factor& x, const IntervalVector& a, const Factor& y,
                        const IntervalVector& b)
{
    return {x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]};
}

CentredVector combined(const CentredForm& x, const CentredVector& a, const CentredForm& y,
                       const CentredVector& b)
{
    return {x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]};
}

CentredVector centred(const Vec3& middle, const IntervalVector& range,
                      const IntervalVector& first, const IntervalVector& second)
{
    CentredVector result;
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = CentredForm::of(middle[static_cast<int>(k)], range[k],
                                    {first[k], second[k], Interval{0, 0}});
    return result;
}

// The contacts of a box. The variables of all centred forms are u and v, from the middle
// in half widths of the box; and the ray angle likewise.
struct Contacts {
    ContactFrame frame;       // of the middle
    double half_u;            // of the box
    double half_v;            // of the box
    CentredVector centre;     // of the ball
    IntervalVector centre_u;  // derivatives of the centre
    IntervalVector centre_v;
    std::array<CentredVector, 2> centre_slopes;  // the same derivatives
    std::array<CentredVector, 2> velocities;     // of the centre, for two unit directions
};

// Velocities of the centre when the bounded point moves at unit speed along q_u, and
// across it in the tangent plane.
std::array<CentredVector, 2> velocities_of(const CentredVector& surface_u,
                                           const CentredVector& surface_v,
                                           const CentredVector& moved_u,
                                           const CentredVector& moved_v)
{
    const CentredForm first = reciprocal(dot(surface_u, surface_u));
    const CentredForm mixed = dot(surface_u, surface_v);
    const CentredForm share = mixed * first;
    const CentredForm across =
        reciprocal(square_root(dot(surface_v, surface_v) - mixed * share));
    const CentredForm none = CentredForm::constant(0);
    return {combined(square_root(first), moved_u, none, moved_v),
            combined(-1.0 * (across * share), moved_u, across, moved_v)};
}

Contacts contacts_of(const BoundedPart& part, const BoundProblem& problem,
                     const ContactBox& box, const ContactFrame& frame,
                     const RaisedEnclosure& raised)
{
    const double a = box.box.u.length() / 2;
    const double b = box.box.v.length() / 2;
    const RaisedJet jet =
        raised_jet(part, box.middle.surface, box.middle.at, problem.cutter.radius());
    const auto scaled = [](double by, const IntervalVector& vector) {
        return IntervalVector{by * vector[0], by * vector[1], by * vector[2]};
    };
    const auto tangent = [&](const Vec3& middle, const IntervalVector& range,
                             const IntervalVector& by_u, const IntervalVector& by_v) {
        return centred(middle, range, scaled(a, by_u), scaled(b, by_v));
    };
    const auto& y2 = raised.seconds;
    const auto& q2 = raised.surface_second;
    const CentredVector surface_u =
        tangent(jet.surface_du, raised.surface[0], q2[0], q2[1]);
    const CentredVector surface_v =
        tangent(jet.surface_dv, raised.surface[1], q2[1], q2[2]);
    const bool is_contact = problem.length == BoundedLength::Contact;
    const CentredVector centre_u = tangent(jet.du, raised.tangents[0], y2[0], y2[1]);
    const CentredVector centre_v = tangent(jet.dv, raised.tangents[1], y2[1], y2[2]);
    return {frame,
            a,
            b,
            centred(jet.point, raised.point, scaled(a, raised.tangents[0]),
                    scaled(b, raised.tangents[1])),
            raised.tangents[0],
            raised.tangents[1],
            {centre_u, centre_v},
            velocities_of(surface_u, surface_v, is_contact ? centre_u : surface_u,
                          is_contact ? centre_v : surface_v)};
}

// Whether one principal curvature is certainly too concave for the ball in the whole box:
// the determinant of (q_a . (q_b + R N_b)) has the sign of (1 + R k1)(1 + R k2).
bool is_too_concave(const RaisedEnclosure& raised)
{
    const auto& q = raised.surface;
    const auto& c = raised.tangents;
    const Interval determinant =
        dot(q[0], c[0]) * dot(q[1], c[1]) - dot(q[0], c[1]) * dot(q[1], c[0]);
    return determinant.high < 0;
}

// The part of a function that grows with the distance from the half-line: all components,
// or, above the centre, only the level ones.
CentredVector from_nearest(CentredVector difference, const BoundProblem& problem)
{
    if (problem.tool == CoveringTool::BallAndFlank)
        difference[2] = negative_part(difference[2]);
    return difference;
}

// Sums of inflow over arcs of rays, for each direction.
struct InflowSums {
    std::array<double, directions> values{};
    std::array<Interval, directions> slopes_u{};
    std::array<Interval, directions> slopes_v{};
    double radii = 0;  // integral of the squares of the radii, halved
};

// An arc of rays: angles, and the direction of the rays in the parameters.
struct Arc {
    double middle;
    double half;
    CentredForm u;
    CentredForm v;
};

// The boundary point of the rays of an arc, and the raised surface there.
struct RayForms {
    CentredForm radius;
    SurfacePoint at;                   // in the middle
    std::array<Interval, 3> u_slopes;  // of the parameters
    std::array<Interval, 3> v_slopes;
    double area;               // the area element in the middle
    CentredVector difference;  // from the centre of the ball to the raised point
    CentredVector away;        // the same from the nearest point of the tool
    CentredVector along;       // derivative of the raised point along the ray
    CentredVector tangent_u;
    CentredVector tangent_v;
};

class BoxInflow {
public:
    BoxInflow(const BoundedPart& part, const BoundProblem& problem,
              const DensityGrid& grid, std::span<const double> density,
              const EnclosureGrid& enclosures, const ContactBox& box,
              const Contacts& contacts)
        : part_{part},
          problem_{problem},
          grid_{grid},
          density_{density},
          enclosures_{enclosures},
          box_{box},
          contacts_{contacts},
          tool_{problem, contacts.frame.centre},
          scale_{std::abs(contacts.frame.along_1.a * contacts.frame.along_2.b -
                          contacts.frame.along_1.b * contacts.frame.along_2.a)}
    {
    }

    std::string_view star_shaped_about(const EnclosureGrid::Near& near) const;
    bool add_arcs();
    CertifiedInflow result() const;

private:
    // A boundary point of all rays of an arc and all contacts.
    struct Boundary {
        CentredForm radius;
        ParameterBox box;
        LeafRange leaves;
    };
    enum class Place { Inside, Across, Outside };

    Arc arc(double middle, double half) const;
    std::optional<double> radius_at(const Arc& arc) const;
    std::optional<Boundary> boundary(const Arc& arc);
    RayForms forms_of(const Arc& arc, const CentredForm& radius,
                      const SurfaceLeaf& all) const;
    std::optional<RayForms> closer(const Arc& arc, const RayForms& forms,
                                   const SurfaceLeaf& all) const;
    Place place_of(const ParameterBox& box) const;
    bool add(double middle, double half, int halvings);
    bool add_flow(const Arc& arc, const Boundary& boundary, Place place);
    void add_cells(const LeafRange& leaves);

    const BoundedPart& part_;
    const BoundProblem& problem_;
    const DensityGrid& grid_;
    std::span<const double> density_;
    const EnclosureGrid& enclosures_;
    const ContactBox& box_;
    const Contacts& contacts_;
    ToolReach tool_;
    double scale_;
    double last_radius_ = 1;
    InflowSums sums_;
    double across_u_ = 0;  // inflow of arcs that may meet a border of u
    double across_v_ = 0;
    std::vector<std::uint32_t> cells_;
    std::optional<LeafRange> covered_;
};

// On all leaves that the tool may reach, the distance from the tool rises along each ray
// from a contact. Below the centre, half the derivative of its square is
//     (q - x + R (N(q) - N(x))) . y_d,
// because N(q) . y_d = 0, and the first factor is r times a mean of q_d + R N_d.
std::string_view BoxInflow::star_shaped_about(const EnclosureGrid::Near& near) const
{
    if (!near.cells_of_others.empty())
        return "a ball covers places of two surfaces";
    if (!near.own)
        return "no contact was found";
    const std::size_t surface = box_.middle.surface;
    const double R = problem_.cutter.radius();
    std::array<IntervalVector, 2> moved{};
    std::array<IntervalVector, 2> raised{};
    bool is_first = true;
    for (int row = near.own->low_v; row <= near.own->high_v; ++row)
        for (int column = near.own->low_u; column <= near.own->high_u; ++column) {
            const SurfaceLeaf& leaf = enclosures_.leaf(surface, column, row);
            for (std::size_t a = 0; a < 2; ++a) {
                const IntervalVector sum =
                    combined(1.0, leaf.surface[a], R, leaf.normal[a]);
                for (std::size_t k = 0; k < 3; ++k) {
                    moved[a][k] = is_first ? sum[k] : hull(moved[a][k], sum[k]);
                    raised[a][k] = is_first ? leaf.tangents[a][k]
                                            : hull(raised[a][k], leaf.tangents[a][k]);
                }
            }
            is_first = false;
        }
    const double uu = dot(moved[0], raised[0]).low;
    const double vv = dot(moved[1], raised[1]).low;
    const double uv = magnitude(dot(moved[0], raised[1]) + dot(moved[1], raised[0])) / 2;
    if (!(uu > 0 && vv > 0 && uu * vv > uv * uv))
        return "the covered set may have several components";
    if (problem_.tool == CoveringTool::Ball)
        return {};
    for (std::size_t k = 0; k < near.columns.size(); ++k) {
        const int column = static_cast<int>(near.columns[k]);
        const int row = static_cast<int>(near.rows[k]);
        const SurfaceLeaf& leaf = enclosures_.leaf(surface, column, row);
        if (leaf.point[2].high <= contacts_.centre[2].range.low)
            continue;
        const ParameterBox at = enclosures_.box(surface, column, row);
        const Interval u = at.u - box_.box.u;
        const Interval v = at.v - box_.box.v;
        Interval slope{0, 0};
        for (std::size_t c = 0; c < 2; ++c)
            slope = slope + (leaf.point[c] - contacts_.centre[c].range) *
                                (u * leaf.tangents[0][c] + v * leaf.tangents[1][c]);
        if (!(slope.low > 0))
            return "the flank may cover a part of its own";
    }
    return {};
}

Arc BoxInflow::arc(double middle, double half) const
{
    const auto component = [&](double first, double second) -> CentredForm {
        const double size = std::hypot(first, second);
        const double value = std::cos(middle) * first + std::sin(middle) * second;
        const double slope = std::cos(middle) * second - std::sin(middle) * first;
        const Interval slopes{half * (slope - half * size), half * (slope + half * size)};
        const double far = magnitude(slopes);
        return {value, {value - far, value + far}, {Interval{}, Interval{}, slopes}};
    };
    const ContactFrame& frame = contacts_.frame;
    return {middle, half, component(frame.along_1.a, frame.along_2.a),
            component(frame.along_1.b, frame.along_2.b)};
}

// The radius at the middle contact and angle, by Newton's method.
std::optional<double> BoxInflow::radius_at(const Arc& arc) const
{
    const SurfacePoint from = contacts_.frame.at;
    double r = last_radius_;
    for (int step = 0; step < most_steps; ++step) {
        const RaisedJet raised =
            raised_jet(part_, box_.middle.surface,
                       {from.u + r * arc.u.middle, from.v + r * arc.v.middle},
                       problem_.scallop_height);
        if (raised.area == 0)
            return std::nullopt;
        const Vec3 away = tool_.from_nearest(raised.point);
        const double slope =
            2 * away.dot(arc.u.middle * raised.du + arc.v.middle * raised.dv);
        const double excess = away.squaredNorm() - tool_.reach() * tool_.reach();
        if (!(slope > 0))
            return std::nullopt;
        const double next = std::max(r / 2, r - excess / slope);
        const bool is_done = std::abs(next - r) <= 1e-13 * r;
        r = next;
        if (is_done)
            return r;
    }
    return std::nullopt;
}

// By the mean value theorem the radius at any contact and angle of the box differs from
// that in the middle by the derivatives of the squared distance, divided by its derivative
// along the ray. A range that contains its own image contains all radii.
std::optional<BoxInflow::Boundary> BoxInflow::boundary(const Arc& arc)
{
    const auto found = radius_at(arc);
    if (!found)
        return std::nullopt;
    last_radius_ = *found;
    const double middle = *found;
    const SurfacePoint from = contacts_.frame.at;
    const RaisedJet jet =
        raised_jet(part_, box_.middle.surface,
                   {from.u + middle * arc.u.middle, from.v + middle * arc.v.middle},
                   problem_.scallop_height);
    const Vec3 difference = jet.point - contacts_.frame.centre;
    const Interval angle_slope_u = arc.u.slopes[2];
    const Interval angle_slope_v = arc.v.slopes[2];
    double far = 0.05 * middle;
    for (int k = 0; k < widenings; ++k) {
        const Interval radius{std::max(0.0, middle - far), middle + far};
        const ParameterBox box{box_.box.u + radius * arc.u.range,
                               box_.box.v + radius * arc.v.range};
        const auto leaves = enclosures_.range(box_.middle.surface, box);
        if (!leaves)
            return std::nullopt;
        std::array<IntervalVector, 2> tangents =
            enclosures_.leaf(box_.middle.surface, leaves->low_u, leaves->low_v).tangents;
        for (int row = leaves->low_v; row <= leaves->high_v; ++row)
            for (int column = leaves->low_u; column <= leaves->high_u; ++column) {
                const auto& other =
                    enclosures_.leaf(box_.middle.surface, column, row).tangents;
                for (std::size_t a = 0; a < 2; ++a)
                    for (std::size_t c = 0; c < 3; ++c)
                        tangents[a][c] = hull(tangents[a][c], other[a][c]);
            }
        const IntervalVector along =
            combined(arc.u.range, tangents[0], arc.v.range, tangents[1]);
        CentredVector away;
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = difference[static_cast<int>(c)];
            const std::array<Interval, 3> slopes{
                contacts_.half_u * (tangents[0][c] - contacts_.centre_u[c]),
                contacts_.half_v * (tangents[1][c] - contacts_.centre_v[c]),
                radius *
                    (angle_slope_u * tangents[0][c] + angle_slope_v * tangents[1][c])};
            const double change = magnitude(slopes[0]) + magnitude(slopes[1]) +
                                  magnitude(slopes[2]) + far * magnitude(along[c]);
            away[c] = {value, {value - change, value + change}, slopes};
        }
        away = from_nearest(away, problem_);
        Interval rise{0, 0};
        for (std::size_t c = 0; c < 3; ++c)
            rise = rise + away[c].range * along[c];
        if (!(rise.low > 0))
            return std::nullopt;
        const Interval share = -reciprocal(rise);
        CentredForm result{middle, {}, {}};
        double change = 0;
        for (std::size_t n = 0; n < 3; ++n) {
            Interval slope{0, 0};
            for (std::size_t c = 0; c < 3; ++c)
                slope = slope + away[c].range * away[c].slopes[n];
            result.slopes[n] = slope * share;
            change += magnitude(result.slopes[n]);
        }
        if (change <= far && change < middle) {
            result.range = {middle - change, middle + change};
            const ParameterBox closer{box_.box.u + result.range * arc.u.range,
                                      box_.box.v + result.range * arc.v.range};
            return Boundary{result, closer,
                            *enclosures_.range(box_.middle.surface, closer)};
        }
        far = std::max(1.2 * change, 1.5 * far);
    }
    return std::nullopt;
}

BoxInflow::Place BoxInflow::place_of(const ParameterBox& box) const
{
    const Surface& surface = part_.surfaces[box_.middle.surface];
    const Interval u = surface.range(Parameter::U);
    const Interval v = surface.range(Parameter::V);
    if (box.u.high < u.low || box.u.low > u.high || box.v.high < v.low ||
        box.v.low > v.high)
        return Place::Outside;
    return contains(u, box.u) && contains(v, box.v) ? Place::Inside : Place::Across;
}

void BoxInflow::add_cells(const LeafRange& leaves)
{
    for (int row = leaves.low_v; row <= leaves.high_v; ++row)
        for (int column = leaves.low_u; column <= leaves.high_u; ++column) {
            const SurfaceLeaf& leaf = enclosures_.leaf(box_.middle.surface, column, row);
            if (leaf.is_inside && (cells_.empty() || cells_.back() != leaf.node))
                cells_.push_back(leaf.node);
        }
}

// A function of the place on the surface, from its derivatives in u and v.
CentredForm of_place(const RayForms& forms, double middle, const Interval& range,
                     const Interval& by_u, const Interval& by_v)
{
    std::array<Interval, 3> slopes;
    for (std::size_t n = 0; n < 3; ++n)
        slopes[n] = by_u * forms.u_slopes[n] + by_v * forms.v_slopes[n];
    return CentredForm::of(middle, range, slopes);
}

RayForms BoxInflow::forms_of(const Arc& arc, const CentredForm& radius,
                             const SurfaceLeaf& all) const
{
    const SurfacePoint from = contacts_.frame.at;
    RayForms forms;
    forms.radius = radius;
    forms.at = {from.u + radius.middle * arc.u.middle,
                from.v + radius.middle * arc.v.middle};
    forms.u_slopes = (radius * arc.u).slopes;
    forms.v_slopes = (radius * arc.v).slopes;
    forms.u_slopes[0] = forms.u_slopes[0] + Interval{contacts_.half_u, contacts_.half_u};
    forms.v_slopes[1] = forms.v_slopes[1] + Interval{contacts_.half_v, contacts_.half_v};
    const RaisedJet jet =
        raised_jet(part_, box_.middle.surface, forms.at, problem_.scallop_height);
    forms.area = jet.area;
    for (std::size_t c = 0; c < 3; ++c) {
        const int k = static_cast<int>(c);
        forms.difference[c] = of_place(forms, jet.point[k], all.point[c],
                                       all.tangents[0][c], all.tangents[1][c]) -
                              contacts_.centre[c];
        forms.tangent_u[c] = of_place(forms, jet.du[k], all.tangents[0][c],
                                      all.seconds[0][c], all.seconds[1][c]);
        forms.tangent_v[c] = of_place(forms, jet.dv[k], all.tangents[1][c],
                                      all.seconds[1][c], all.seconds[2][c]);
    }
    forms.away = from_nearest(forms.difference, problem_);
    forms.along = combined(arc.u, forms.tangent_u, arc.v, forms.tangent_v);
    return forms;
}

// The same forms with closer derivatives of the radius and of the difference. The tangents
// at the contact and at the boundary, and the point and the tangents along an arc, turn
// together; the forms of their differences know this, the ranges of both do not.
std::optional<RayForms> BoxInflow::closer(const Arc& arc, const RayForms& forms,
                                          const SurfaceLeaf& all) const
{
    const Interval rise = dot(forms.away, forms.along).range;
    if (!(rise.low > 0))
        return std::nullopt;
    const Interval share = -reciprocal(rise);
    const auto turned = [&](const CentredForm& direction) -> CentredForm {
        const Interval& slope = direction.slopes[2];
        return {(slope.low + slope.high) / 2,
                slope,
                {Interval{}, Interval{}, -(arc.half * arc.half) * direction.range}};
    };
    std::array<CentredVector, 3> changes;  // of the difference; by the angle, over r
    for (std::size_t c = 0; c < 3; ++c) {
        changes[0][c] =
            contacts_.half_u * (forms.tangent_u[c] - contacts_.centre_slopes[0][c]);
        changes[1][c] =
            contacts_.half_v * (forms.tangent_v[c] - contacts_.centre_slopes[1][c]);
        changes[2][c] =
            turned(arc.u) * forms.tangent_u[c] + turned(arc.v) * forms.tangent_v[c];
    }
    const std::array<Interval, 3> of_square{
        dot(forms.away, changes[0]).range, dot(forms.away, changes[1]).range,
        (forms.radius * dot(forms.away, changes[2])).range};
    CentredForm radius = forms.radius;
    for (std::size_t n = 0; n < 3; ++n)
        radius.slopes[n] = common_part(radius.slopes[n], of_square[n] * share);
    radius = CentredForm::of(radius.middle, radius.range, radius.slopes);
    RayForms result = forms_of(arc, radius, all);
    for (std::size_t c = 0; c < 3; ++c) {
        CentredForm& away = result.difference[c];
        for (std::size_t n = 0; n < 3; ++n)
            away.slopes[n] = common_part(
                away.slopes[n], (n < 2 ? changes[n][c] : radius * changes[n][c]).range +
                                    radius.slopes[n] * result.along[c].range);
        away = CentredForm::of(away.middle, away.range, away.slopes);
    }
    result.away = from_nearest(result.difference, problem_);
    return result;
}

// The flow of the rays of an arc. Over an arc of half width w, the integral of a function
// of the angle is at most 2 w times its value in the middle, plus w / 2 times the width of
// the range of its derivative per w.
bool BoxInflow::add_flow(const Arc& arc, const Boundary& boundary, Place place)
{
    const std::size_t surface = box_.middle.surface;
    const LeafRange& leaves = boundary.leaves;
    SurfaceLeaf all = enclosures_.leaf(surface, leaves.low_u, leaves.low_v);
    bool has_density = false;
    const auto join = [](auto& vectors, const auto& others) {
        for (std::size_t a = 0; a < vectors.size(); ++a)
            for (std::size_t c = 0; c < 3; ++c)
                vectors[a][c] = hull(vectors[a][c], others[a][c]);
    };
    Interval density{0, 0};
    std::array<Interval, 2> density_slope{};
    for (int row = leaves.low_v; row <= leaves.high_v; ++row)
        for (int column = leaves.low_u; column <= leaves.high_u; ++column) {
            const SurfaceLeaf& leaf = enclosures_.leaf(surface, column, row);
            for (std::size_t c = 0; c < 3; ++c)
                all.point[c] = hull(all.point[c], leaf.point[c]);
            join(all.tangents, leaf.tangents);
            join(all.seconds, leaf.seconds);
            if (!leaf.is_inside)
                continue;
            density = has_density ? hull(density, leaf.density) : leaf.density;
            for (std::size_t a = 0; a < 2; ++a)
                density_slope[a] = has_density
                                       ? hull(density_slope[a], leaf.density_slope[a])
                                       : leaf.density_slope[a];
            has_density = true;
        }
    add_cells(leaves);

    const bool has_jump = enclosures_.has_jump(surface, boundary.box);
    RayForms forms = forms_of(arc, boundary.radius, all);
    if (!has_jump) {
        for (int k = 0; k < 2; ++k) {
            const auto found = closer(arc, forms, all);
            if (!found)
                return false;
            forms = *found;
        }
    }
    const CentredForm& r = forms.radius;
    const CentredVector& away = forms.away;
    const CentredVector& along = forms.along;
    const CentredForm rise = dot(away, along);
    Interval rise_range = rise.range;
    if (has_jump) {
        rise_range = {0, 0};
        for (std::size_t c = 0; c < 3; ++c)
            rise_range = rise_range + away[c].range * (arc.u.range * all.tangents[0][c] +
                                                       arc.v.range * all.tangents[1][c]);
    }
    if (!(rise_range.low > 0))
        return false;
    const CentredForm rate = scale_ * (r * reciprocal(rise));
    const CentredForm first = rate * dot(away, contacts_.velocities[0]);
    const CentredForm second = rate * dot(away, contacts_.velocities[1]);
    if (place == Place::Across || has_jump) {
        const Interval flow_rate = scale_ * (r.range * reciprocal(rise_range));
        const Interval by_1 =
            density * (flow_rate * dot(away, contacts_.velocities[0]).range);
        const Interval by_2 =
            density * (flow_rate * dot(away, contacts_.velocities[1]).range);
        double greatest = 0;
        for (int j = 0; j < directions; ++j) {
            const double turn = 2 * std::numbers::pi * j / directions;
            const double most =
                2 * arc.half *
                std::max(0.0, (std::cos(turn) * by_1 + std::sin(turn) * by_2).high);
            sums_.values[j] += most;
            greatest = std::max(greatest, most);
        }
        const Interval range = part_.surfaces[surface].range(Parameter::U);
        (contains(range, boundary.box.u) ? across_v_ : across_u_) += greatest;
        return true;
    }
    const CentredForm g = of_place(
        forms, grid_.value(density_, grid_.place(surface, forms.at)) * forms.area,
        density, density_slope[0], density_slope[1]);
    const CentredForm flow_1 = g * first;
    const CentredForm flow_2 = g * second;
    for (int j = 0; j < directions; ++j) {
        const double turn = 2 * std::numbers::pi * j / directions;
        const CentredForm flow = std::cos(turn) * flow_1 + std::sin(turn) * flow_2;
        if (flow.range.high <= 0)
            continue;
        std::array<Interval, 3> slopes = flow.slopes;
        if (flow.range.low < 0)
            for (Interval& slope : slopes)
                slope = hull(slope, {0, 0});
        sums_.values[j] +=
            2 * arc.half * (std::max(0.0, flow.middle) + slopes[2].length() / 4);
        sums_.slopes_u[j] = sums_.slopes_u[j] + 2 * arc.half * slopes[0];
        sums_.slopes_v[j] = sums_.slopes_v[j] + 2 * arc.half * slopes[1];
    }
    return true;
}

bool BoxInflow::add(double middle, double half, int halvings)
{
    const Arc rays = arc(middle, half);
    const auto found = boundary(rays);
    if (!found)
        return false;
    const Place place = place_of(found->box);
    if (place == Place::Across && halvings > 0)
        return add(middle - half / 2, half / 2, halvings - 1) &&
               add(middle + half / 2, half / 2, halvings - 1);
    const LeafRange& leaves = found->leaves;
    if (!covered_)
        covered_ = leaves;
    covered_ = LeafRange{std::min(covered_->low_u, leaves.low_u),
                         std::max(covered_->high_u, leaves.high_u),
                         std::min(covered_->low_v, leaves.low_v),
                         std::max(covered_->high_v, leaves.high_v)};
    const double radius = found->radius.range.high;
    sums_.radii += half * radius * radius;
    return place == Place::Outside || add_flow(rays, *found, place);
}

bool BoxInflow::add_arcs()
{
    constexpr double half = std::numbers::pi / arcs;
    for (int k = 0; k < arcs; ++k)
        if (!add(2 * half * k, half, arc_halvings))
            return false;
    return true;
}

CertifiedInflow BoxInflow::result() const
{
    double greatest = 0;
    double of_u = 0;
    double of_v = 0;
    for (int j = 0; j < directions; ++j) {
        const double by_u = magnitude(sums_.slopes_u[j]);
        const double by_v = magnitude(sums_.slopes_v[j]);
        const double sum = sums_.values[j] + by_u + by_v;
        if (sum > greatest) {
            greatest = sum;
            of_u = by_u;
            of_v = by_v;
        }
    }
    double density = 0;
    double parameters = 0;
    for (int row = covered_->low_v; row <= covered_->high_v; ++row)
        for (int column = covered_->low_u; column <= covered_->high_u; ++column) {
            const SurfaceLeaf& leaf = enclosures_.leaf(box_.middle.surface, column, row);
            if (!leaf.is_inside)
                continue;
            density = std::max(density, leaf.density.high);
            const ParameterBox at = enclosures_.box(box_.middle.surface, column, row);
            parameters += at.u.length() * at.v.length();
        }
    std::vector<std::uint32_t> cells = cells_;
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return {CertifiedInflow::Kind::Bounded,
            greatest / std::cos(std::numbers::pi / directions),
            density * std::min(scale_ * sums_.radii, parameters),
            of_u + across_u_ >= of_v + across_v_,
            std::move(cells),
            {}};
}

CertifiedInflow unknown(const EnclosureGrid::Near& near, const EnclosureGrid& enclosures,
                        std::size_t surface, std::string_view reason)
{
    CertifiedInflow result{CertifiedInflow::Kind::Unknown, 0,     0, true,
                           near.cells_of_others,           reason};
    for (std::size_t k = 0; k < near.columns.size(); ++k) {
        const SurfaceLeaf& leaf = enclosures.leaf(
            surface, static_cast<int>(near.columns[k]), static_cast<int>(near.rows[k]));
        if (leaf.is_inside)
            result.cells.push_back(leaf.node);
    }
    std::ranges::sort(result.cells);
    result.cells.erase(std::unique(result.cells.begin(), result.cells.end()),
                       result.cells.end());
    return result;
}

}  // namespace

CertifiedInflow certified_inflow(const BoundedPart& part, const BoundProblem& problem,
                                 const DensityGrid& grid, std::span<const double> density,
                                 const EnclosureGrid& enclosures,
                                 const ContactBox& contacts)
{
    const double R = problem.cutter.radius();
    const std::size_t surface = contacts.middle.surface;
    const auto raised = raised_enclosure(part, contacts.middle, contacts.box, R);
    if (raised && is_too_concave(*raised))
        return {CertifiedInflow::Kind::NoContact, 0, 0, true, {}, {}};
    if (!raised)
        return {CertifiedInflow::Kind::Unknown, 0, 0, true, {}, no_normal};
    Vec3 middle;
    double radius = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        middle[static_cast<int>(c)] = (raised->point[c].low + raised->point[c].high) / 2;
        radius = std::hypot(radius, raised->point[c].length() / 2);
    }
    const EnclosureGrid::Near near =
        enclosures.near(surface, ToolReach{problem, middle}, radius);
    const auto frame = contact_frame(part, problem, contacts.middle);
    if (!frame)
        return unknown(near, enclosures, surface, "the ball may not fit");
    const Contacts of_box = contacts_of(part, problem, contacts, *frame, *raised);
    BoxInflow inflow{part, problem, grid, density, enclosures, contacts, of_box};
    const std::string_view reason = inflow.star_shaped_about(near);
    if (!reason.empty())
        return unknown(near, enclosures, surface, reason);
    if (!inflow.add_arcs())
        return unknown(near, enclosures, surface, "a ray could not be enclosed");
    return inflow.result();
}

}  // namespace endmill
