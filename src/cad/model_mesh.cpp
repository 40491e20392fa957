// SPDX-License-Identifier: GPL-3.0-or-later
#include "cad/model_mesh.h"

#include <cstddef>
#include <limits>
#include <utility>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>

// BRepMesh divides every edge once, for all its faces, but gives each face points of its own.
// They are joined by the topology, without a tolerance: the k-th point of an edge is the same
// in all faces, and the ends of edges are the vertices of the model.

namespace endmill::cad {
namespace {

constexpr std::int32_t unknown = -1;

// The points of a mesh that grows face by face.
class JoinedPoints {
public:
    JoinedPoints(const Model& model, ModelMesh& mesh) : mesh_{mesh}
    {
        TopExp::MapShapes(model.shape, TopAbs_EDGE, edges_);
        TopExp::MapShapes(model.shape, TopAbs_VERTEX, vertices_);
        of_edges_.resize(static_cast<std::size_t>(edges_.Extent()) + 1);
        of_vertices_.resize(static_cast<std::size_t>(vertices_.Extent()) + 1, unknown);
    }

    // The numbers in the mesh of the points of a face.
    std::vector<std::int32_t> numbers(const TopoDS_Face& face,
                                      const Handle(Poly_Triangulation) & triangulation,
                                      const TopLoc_Location& place)
    {
        points_of_face_.assign(static_cast<std::size_t>(triangulation->NbNodes()) + 1,
                               unknown);
        triangulation_ = triangulation;
        place_ = place;
        for (TopExp_Explorer edge{face, TopAbs_EDGE}; edge.More(); edge.Next())
            join(TopoDS::Edge(edge.Current()));
        for (std::size_t i = 1; i < points_of_face_.size(); ++i)
            if (points_of_face_[i] == unknown)
                points_of_face_[i] = new_point(static_cast<int>(i));
        return points_of_face_;
    }

private:
    std::int32_t new_point(int node)
    {
        if (mesh_.points.size() >= std::numeric_limits<std::int32_t>::max())
            throw Limit{"the mesh has more than 2147483647 points"};
        const gp_Pnt point =
            triangulation_->Node(node).Transformed(place_.Transformation());
        mesh_.points.push_back({point.X(), point.Y(), point.Z()});
        return static_cast<std::int32_t>(mesh_.points.size() - 1);
    }

    // Gives a point of the face the number `shared`, or a new one if that has none yet.
    void share(int node, std::int32_t& shared)
    {
        std::int32_t& own = points_of_face_.at(static_cast<std::size_t>(node));
        if (shared == unknown)
            shared = own == unknown ? new_point(node) : own;
        if (own == unknown)
            own = shared;
    }

    void share_vertex(int node, const TopoDS_Vertex& vertex)
    {
        if (!vertex.IsNull())
            share(node,
                  of_vertices_.at(static_cast<std::size_t>(vertices_.FindIndex(vertex))));
    }

    void join(const TopoDS_Edge& edge)
    {
        const Handle(Poly_PolygonOnTriangulation)& line =
            BRep_Tool::PolygonOnTriangulation(edge, triangulation_, place_);
        if (line.IsNull())
            return;
        TopoDS_Vertex first;
        TopoDS_Vertex last;
        TopExp::Vertices(edge, first, last);
        const auto& nodes = line->Nodes();
        const int count = nodes.Length();
        const int offset = nodes.Lower();
        share_vertex(nodes(offset), first);
        share_vertex(nodes(offset + count - 1), last);
        auto& known = of_edges_.at(static_cast<std::size_t>(edges_.FindIndex(edge)));
        if (known.empty())
            known.resize(static_cast<std::size_t>(count), unknown);
        if (known.size() != static_cast<std::size_t>(count))
            return;  // the faces divide the edge differently
        const bool is_pole = BRep_Tool::Degenerated(edge);
        for (int k = 0; k < count; ++k)
            if (is_pole)
                share_vertex(nodes(offset + k), first);
            else
                share(nodes(offset + k), known[static_cast<std::size_t>(k)]);
    }

    ModelMesh& mesh_;
    TopTools_IndexedMapOfShape edges_;
    TopTools_IndexedMapOfShape vertices_;
    std::vector<std::vector<std::int32_t>> of_edges_;  // by edge, then along it
    std::vector<std::int32_t> of_vertices_;
    std::vector<std::int32_t> points_of_face_;  // of the face at hand, from 1
    Handle(Poly_Triangulation) triangulation_;
    TopLoc_Location place_;
};

}  // namespace

ModelMesh mesh_of(const Model& model, const MeshTolerances& tolerances)
{
    IMeshTools_Parameters parameters;
    parameters.Deflection = tolerances.chord;
    parameters.DeflectionInterior = tolerances.chord;
    parameters.Angle = tolerances.angle_rad;
    parameters.AngleInterior = tolerances.angle_rad;
    parameters.Relative = Standard_False;
    parameters.InParallel = Standard_False;
    parameters.AllowQualityDecrease =
        Standard_True;  // mesh again what the file meshed coarsely
    const BRepMesh_IncrementalMesh mesher{model.shape, parameters};
    ModelMesh mesh;
    JoinedPoints joined{model, mesh};
    for (std::size_t number = 0; number < model.faces.size(); ++number) {
        const TopoDS_Face& face = model.faces[number].face;
        TopLoc_Location place;
        const Handle(Poly_Triangulation)& triangulation =
            BRep_Tool::Triangulation(face, place);
        if (triangulation.IsNull() || triangulation->NbTriangles() == 0) {
            mesh.unmeshed.push_back(static_cast<std::int32_t>(number));
            continue;
        }
        const std::vector<std::int32_t> points =
            joined.numbers(face, triangulation, place);
        const bool is_reversed = (face.Orientation() == TopAbs_REVERSED) !=
                                 place.Transformation().IsNegative();
        for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
            std::array<int, 3> corners{};
            triangulation->Triangle(i).Get(corners[0], corners[1], corners[2]);
            if (is_reversed)
                std::swap(corners[1], corners[2]);
            const auto number_of = [&](int corner) {
                return points.at(static_cast<std::size_t>(corner));
            };
            const std::array<std::int32_t, 3> triangle{
                number_of(corners[0]), number_of(corners[1]), number_of(corners[2])};
            if (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
                triangle[2] == triangle[0])
                continue;  // at a pole
            mesh.triangles.push_back(triangle);
            mesh.triangle_faces.push_back(static_cast<std::int32_t>(number));
        }
    }
    return mesh;
}

}  // namespace endmill::cad
