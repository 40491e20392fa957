// SPDX-License-Identifier: GPL-3.0-or-later
#include "cad/face_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <BRepAdaptor_Surface.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomConvert.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_SweptSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Circ.hxx>
#include <gp_Lin.hxx>
#include <gp_Vec.hxx>

namespace endmill::cad {
namespace {

// The rectangle of parameters around a face.
struct Rectangle {
    double u0 = 0;
    double u1 = 0;
    double v0 = 0;
    double v1 = 0;
};

Rectangle rectangle_of(const TopoDS_Face& face)
{
    Rectangle found;
    BRepTools::UVBounds(face, found.u0, found.u1, found.v0, found.v1);
    return found;
}

// Distances in parameters that are below the tolerance of the face in space.
struct ParameterTolerance {
    double u;
    double v;
};

ParameterTolerance tolerance_of(const TopoDS_Face& face)
{
    const BRepAdaptor_Surface surface{face, Standard_False};
    const double in_space = std::max(BRep_Tool::Tolerance(face), Precision::Confusion());
    return {surface.UResolution(in_space), surface.VResolution(in_space)};
}

// Whether an edge of the face runs along one side of the rectangle.
bool is_on_side(const TopoDS_Edge& edge, const TopoDS_Face& face, const Rectangle& all,
                const ParameterTolerance& near)
{
    constexpr int samples = 16;
    double from = 0;
    double to = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, from, to);
    if (curve.IsNull())
        return false;
    bool is_on_u0 = true;
    bool is_on_u1 = true;
    bool is_on_v0 = true;
    bool is_on_v1 = true;
    for (int k = 0; k <= samples; ++k) {
        const gp_Pnt2d at = curve->Value(from + (to - from) * k / samples);
        is_on_u0 = is_on_u0 && std::abs(at.X() - all.u0) <= near.u;
        is_on_u1 = is_on_u1 && std::abs(at.X() - all.u1) <= near.u;
        is_on_v0 = is_on_v0 && std::abs(at.Y() - all.v0) <= near.v;
        is_on_v1 = is_on_v1 && std::abs(at.Y() - all.v1) <= near.v;
    }
    return is_on_u0 || is_on_u1 || is_on_v0 || is_on_v1;
}

// Whether a curve has an exact spline.
bool is_exact(const Handle(Geom_Curve) & curve)
{
    if (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve);
        !trimmed.IsNull())
        return is_exact(trimmed->BasisCurve());
    return !curve->IsKind(STANDARD_TYPE(Geom_OffsetCurve));
}

// Whether a surface has an exact spline.
bool is_exact(const Handle(Geom_Surface) & surface)
{
    if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
        !trimmed.IsNull())
        return is_exact(trimmed->BasisSurface());
    if (const auto swept = Handle(Geom_SweptSurface)::DownCast(surface); !swept.IsNull())
        return is_exact(swept->BasisCurve());
    return surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface)) ||
           surface->IsKind(STANDARD_TYPE(Geom_BoundedSurface));
}

// The part of a surface over a rectangle. A surface that ends there stays whole.
Handle(Geom_Surface) part_of(const Handle(Geom_Surface) & surface, const Rectangle& all,
                             const ParameterTolerance& near)
{
    Rectangle own;
    surface->Bounds(own.u0, own.u1, own.v0, own.v1);
    const bool is_whole_u =
        std::abs(own.u0 - all.u0) <= near.u && std::abs(own.u1 - all.u1) <= near.u;
    const bool is_whole_v =
        std::abs(own.v0 - all.v0) <= near.v && std::abs(own.v1 - all.v1) <= near.v;
    if (is_whole_u && is_whole_v)
        return surface;
    if (is_whole_u)
        return new Geom_RectangularTrimmedSurface(surface, all.v0, all.v1,
                                                  Standard_False);
    if (is_whole_v)
        return new Geom_RectangularTrimmedSurface(surface, all.u0, all.u1, Standard_True);
    return new Geom_RectangularTrimmedSurface(surface, all.u0, all.u1, all.v0, all.v1);
}

// The elementary surface that a swept one is; empty if it is none. IGES files give cylinders,
// spheres and tori so.
std::string_view swept_kind(const TopoDS_Face& face)
{
    Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
        !trimmed.IsNull())
        surface = trimmed->BasisSurface();
    const auto swept = Handle(Geom_SweptSurface)::DownCast(surface);
    if (swept.IsNull())
        return {};
    const GeomAdaptor_Curve curve{swept->BasisCurve()};
    const bool is_line = curve.GetType() == GeomAbs_Line;
    const bool is_circle = curve.GetType() == GeomAbs_Circle;
    const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
    if (turned.IsNull()) {
        if (is_line)
            return "plane";
        const bool is_along = is_circle && curve.Circle().Axis().Direction().IsParallel(
                                               swept->Direction(), Precision::Angular());
        return is_along ? "cylinder" : "";
    }
    const gp_Lin axis{turned->Axis()};
    if (is_line) {
        const gp_Lin line = curve.Line();
        if (line.Direction().IsParallel(axis.Direction(), Precision::Angular()))
            return "cylinder";
        if (line.Direction().IsNormal(axis.Direction(), Precision::Angular()))
            return "plane";
        return line.Distance(axis) <= Precision::Confusion() ? "cone" : "";
    }
    const bool is_in_plane =
        is_circle &&
        curve.Circle().Axis().Direction().IsNormal(axis.Direction(),
                                                   Precision::Angular()) &&
        std::abs(gp_Vec{curve.Circle().Location(), axis.Location()}.Dot(
            curve.Circle().Axis().Direction())) <= Precision::Confusion();
    if (!is_in_plane)
        return {};
    return axis.Distance(curve.Circle().Location()) <= Precision::Confusion() ? "sphere"
                                                                              : "torus";
}

}  // namespace

std::string_view surface_kind(const TopoDS_Face& face)
{
    if (const std::string_view kind = swept_kind(face); !kind.empty())
        return kind;
    switch (BRepAdaptor_Surface{face, Standard_False}.GetType()) {
        case GeomAbs_Plane:
            return "plane";
        case GeomAbs_Cylinder:
            return "cylinder";
        case GeomAbs_Cone:
            return "cone";
        case GeomAbs_Sphere:
            return "sphere";
        case GeomAbs_Torus:
            return "torus";
        case GeomAbs_BezierSurface:
            return "bezier";
        case GeomAbs_BSplineSurface:
            return "nurbs";
        case GeomAbs_SurfaceOfRevolution:
            return "revolution";
        case GeomAbs_SurfaceOfExtrusion:
            return "extrusion";
        case GeomAbs_OffsetSurface:
            return "offset";
        default:
            return "other";
    }
}

bool is_trimmed(const TopoDS_Face& face)
{
    int wires = 0;
    for (TopExp_Explorer wire{face, TopAbs_WIRE}; wire.More(); wire.Next())
        ++wires;
    if (wires != 1)
        return true;
    const Rectangle all = rectangle_of(face);
    const ParameterTolerance near = tolerance_of(face);
    for (TopExp_Explorer edge{face, TopAbs_EDGE}; edge.More(); edge.Next())
        if (!is_on_side(TopoDS::Edge(edge.Current()), face, all, near))
            return true;
    return false;
}

Handle(Geom_BSplineSurface) whole_surface(const TopoDS_Face& face)
{
    try {
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
        if (surface.IsNull() || !is_exact(surface))
            return {};
        Handle(Geom_BSplineSurface) spline = GeomConvert::SurfaceToBSplineSurface(
            part_of(surface, rectangle_of(face), tolerance_of(face)));
        if (!spline.IsNull() && spline->IsUPeriodic())
            spline->SetUNotPeriodic();
        if (!spline.IsNull() && spline->IsVPeriodic())
            spline->SetVNotPeriodic();
        return spline;
    } catch (const Standard_Failure&) {
        return {};
    }
}

std::optional<FaceBalls> balls_at_mesh(const TopoDS_Face& face)
{
    TopLoc_Location place;
    const Handle(Poly_Triangulation)& mesh = BRep_Tool::Triangulation(face, place);
    if (mesh.IsNull() || !mesh->HasUVNodes())
        return std::nullopt;
    const BRepAdaptor_Surface surface{face};
    constexpr int second_derivatives = 2;
    BRepLProp_SLProps at{surface, second_derivatives, Precision::Confusion()};
    bool is_known = false;
    double greatest = 0;  // curvature towards du x dv, 1/mm
    double least = 0;     // the same of the most convex place
    const auto look = [&](const gp_XY& parameters) {
        at.SetParameters(parameters.X(), parameters.Y());
        if (!at.IsCurvatureDefined())
            return;
        is_known = true;
        greatest = std::max(greatest, at.MaxCurvature());
        least = std::min(least, at.MinCurvature());
    };
    for (int i = 1; i <= mesh->NbNodes(); ++i)
        look(mesh->UVNode(i).XY());
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
        int a = 0;
        int b = 0;
        int c = 0;
        mesh->Triangle(i).Get(a, b, c);
        look((mesh->UVNode(a).XY() + mesh->UVNode(b).XY() + mesh->UVNode(c).XY()) / 3);
    }
    if (!is_known)
        return std::nullopt;
    constexpr double flat = 1e-9;  // 1/mm, by rounding
    const auto radius = [](double curvature) {
        return curvature > flat ? std::optional{1 / curvature} : std::nullopt;
    };
    FaceBalls balls{radius(greatest), radius(-least)};
    const bool is_reversed =
        (face.Orientation() == TopAbs_REVERSED) != place.Transformation().IsNegative();
    if (is_reversed)
        std::swap(balls.outside, balls.inside);
    return balls;
}

}  // namespace endmill::cad
