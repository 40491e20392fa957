// SPDX-License-Identifier: GPL-3.0-or-later
// The second route of the import test: evaluates the faces of a CAD file by OpenCASCADE.
//
//   cad_reference step|iges FILE < QUERIES
//
// A query is a line "value FACE U V", answered by the point of the face's surface at these
// parameters, or "distance FACE X Y Z", answered by the distance of the point from the
// surface; faces from 1, lengths in mm.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <string>

#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_Surface.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>

#include "cad/cad_model.h"

namespace {

using namespace endmill::cad;

double distance(const gp_Pnt& point, const Handle(Geom_Surface) & surface)
{
    constexpr double tolerance = 1e-12;
    const GeomAPI_ProjectPointOnSurf projection{point, surface};
    ShapeAnalysis_Surface analysis{surface};
    const gp_Pnt2d at = analysis.ValueOfUV(point, tolerance);
    const double nearby = point.Distance(surface->Value(at.X(), at.Y()));
    return projection.NbPoints() > 0 ? std::min(nearby, projection.LowerDistance())
                                     : nearby;
}

void answer(const Model& model)
{
    std::string query;
    std::size_t face = 0;
    while (std::cin >> query >> face) {
        const Handle(Geom_Surface) surface =
            BRep_Tool::Surface(model.faces.at(face - 1).face);
        if (query == "value") {
            double u = 0;
            double v = 0;
            std::cin >> u >> v;
            const gp_Pnt point = surface->Value(u, v);
            std::printf("%.17g %.17g %.17g\n", point.X(), point.Y(), point.Z());
        } else {
            double x = 0;
            double y = 0;
            double z = 0;
            std::cin >> x >> y >> z;
            std::printf("%.17g\n", distance({x, y, z}, surface));
        }
    }
}

}  // namespace

int main(int count, char** words)
{
    try {
        if (count != 3)
            return 2;
        const bool is_iges = std::string{words[1]} == "iges";
        const Model model =
            read_model(words[2], is_iges ? FileKind::Iges : FileKind::Step,
                       std::numeric_limits<std::size_t>::max());
        std::cout.flush();
        std::puts("answers:");
        answer(model);
        return 0;
    } catch (const Standard_Failure& error) {
        std::fprintf(stderr, "%s\n", error.GetMessageString());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
    return 1;
}
