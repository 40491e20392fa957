// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>

namespace endmill {

/// Writes a STEP file of 1000 faces: fifty groups of twenty, each a free-form solid (six
/// faces), a box (six), two cylinders (six), a sphere and a torus.
class ModelOfFaces {
public:
    static constexpr int groups = 50;
    static constexpr int faces = 1000;

    /// \throws std::runtime_error if the file cannot be written.
    static void write(const std::filesystem::path& path)
    {
        TopoDS_Compound whole;
        BRep_Builder builder;
        builder.MakeCompound(whole);
        for (int k = 0; k < groups; ++k)
            add_group(builder, whole, {100.0 * (k % 10), 60.0 * (k / 10), 0});
        STEPControl_Writer writer;
        if (writer.Transfer(whole, STEPControl_AsIs) != IFSelect_RetDone ||
            writer.Write(path.c_str()) != IFSelect_RetDone)
            throw std::runtime_error{"the STEP file cannot be written"};
    }

private:
    // A sheet of 40 by 30 mm with a bump, made a solid of 12 mm height.
    static TopoDS_Shape pillow(const gp_Pnt& at)
    {
        TColgp_Array2OfPnt points{1, 9, 1, 7};
        for (int i = 0; i <= 8; ++i)
            for (int j = 0; j <= 6; ++j) {
                const double x = 5.0 * i;
                const double y = 5.0 * j;
                const double height =
                    6 * std::exp(-(std::pow(x - 20, 2) + std::pow(y - 15, 2)) / 200);
                points(i + 1, j + 1) = {at.X() + x, at.Y() + y, at.Z() + height};
            }
        GeomAPI_PointsToBSplineSurface fit;
        fit.Interpolate(points);
        constexpr double confusion = 1e-7;
        return BRepPrimAPI_MakePrism{
            BRepBuilderAPI_MakeFace{Handle(Geom_Surface){fit.Surface()}, confusion}
                .Face(),
            gp_Vec{0, 0, -12}};
    }

    static void add_group(BRep_Builder& builder, TopoDS_Compound& whole, const gp_Pnt& at)
    {
        const auto place = [&](double x, double y) {
            return gp_Ax2{{at.X() + x, at.Y() + y, at.Z()}, {0, 0, 1}};
        };
        builder.Add(whole, pillow(at));
        builder.Add(whole, BRepPrimAPI_MakeBox{place(45, 0), 10, 20, 8}.Shape());
        builder.Add(whole, BRepPrimAPI_MakeCylinder{place(65, 8), 5, 15}.Shape());
        builder.Add(whole, BRepPrimAPI_MakeCylinder{place(65, 25), 3, 25}.Shape());
        builder.Add(whole, BRepPrimAPI_MakeSphere{place(80, 10), 6}.Shape());
        builder.Add(whole, BRepPrimAPI_MakeTorus{place(80, 38), 7, 2}.Shape());
    }
};

}  // namespace endmill
