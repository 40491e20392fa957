# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the parts of this folder with FreeCAD 0.20 (Debian: freecad).

    cd datasets/cad && freecadcmd make_parts.py

FreeCAD's command line writes neither colours nor names of faces. They are added to assembly.step as text, in the
way of other CAD programs. Dates in the files are replaced by a fixed one, so that the files do not change.
"""
import math
import re
from pathlib import Path

import FreeCAD
import Import
import Part
from FreeCAD import Vector

DATE = "2026-01-01T00:00:00"
GREY, ORANGE = (0.5, 0.5, 0.5), (1.0, 0.5, 0.0)


def without_date(name):
    text = Path(name).read_text(encoding="ascii")
    text = re.sub(r"'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d'", f"'{DATE}'", text)
    text = re.sub(r"15H\d{8}\.\d{6}", "15H20260101.000000", text)
    Path(name).write_text(text, encoding="ascii")


def export(shape, stem, iges):
    shape.exportStep(f"{stem}.step")
    without_date(f"{stem}.step")
    if iges:
        shape.exportIges(f"{stem}.iges")
        without_date(f"{stem}.iges")


def waves(length, width, height, step):
    """A B-spline surface through the points of a wavy height field."""
    points = [[Vector(x, y, height + 2 * math.sin(x / 12) * math.cos(y / 15))
               for y in range(-step, width + 2 * step, step)] for x in range(-step, length + 2 * step, step)]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    return surface


def mould():
    """A block of 80 by 60 mm with rounded vertical edges and a sculptured top."""
    below = waves(80, 60, 25, 5).toShape().extrude(Vector(0, 0, -60))
    block = below.common(Part.makeBox(80, 60, 40))
    upright = [edge for edge in block.Edges
               if edge.Curve.TypeId == "Part::GeomLine" and abs(edge.tangentAt(edge.FirstParameter).z) > 0.999]
    return block.makeFillet(6, upright)


def primitives():
    """A cylinder, a cone, a sphere and a torus that do not touch."""
    return Part.makeCompound([
        Part.makeCylinder(5, 20, Vector(0, 0, 0)),
        Part.makeCone(6, 2, 15, Vector(20, 0, 0)),
        Part.makeSphere(8, Vector(45, 0, 8)),
        Part.makeTorus(10, 3, Vector(75, 0, 3)),
    ])


def pillow():
    """A solid whose six faces are not trimmed: a B-spline top and bottom and four swept sides."""
    surface = Part.BSplineSurface()
    points = [[Vector(x, y, 15 + 6 * math.exp(-((x - 20) ** 2 + (y - 15) ** 2) / 200))
               for y in range(0, 31, 5)] for x in range(0, 41, 5)]
    surface.interpolate(points)
    return surface.toShape().extrude(Vector(0, 0, -12))


def bracket_in_inches():
    """A block of 3 by 2 by 1/2 inch with two holes and a fillet; the file is in inches."""
    inch = 25.4
    block = Part.makeBox(3 * inch, 2 * inch, inch / 2)
    for x in (0.75, 2.25):
        block = block.cut(Part.makeCylinder(inch / 4, inch, Vector(x * inch, inch, -inch / 4)))
    edge = [e for e in block.Edges if e.CenterOfMass.isEqual(Vector(0, inch, inch / 2), 1e-6)]
    Part.setStaticValue("write.step.unit", "INCH")
    export(block.makeFillet(inch / 8, edge), "bracket-inch", iges=False)
    Part.setStaticValue("write.step.unit", "MM")


def with_styles(name, styles):
    """Gives faces a name and a colour. styles: number of the face in the file, from 1 -> (name, (r, g, b))."""
    text = Path(name).read_text(encoding="ascii")
    context = re.search(r"ADVANCED_BREP_SHAPE_REPRESENTATION\(''\s*,\s*\([^)]*\)\s*,\s*(#\d+)\)", text).group(1)
    next_id = max(map(int, re.findall(r"^#(\d+) *=", text, re.M))) + 1
    faces = [match for match in re.finditer(r"^(#\d+) = ADVANCED_FACE\('',", text, re.M)]
    lines, items = [], []
    for number, (label, (red, green, blue)) in styles.items():
        face = faces[number - 1].group(1)
        first = next_id
        entities = [f"COLOUR_RGB('',{red:.6f},{green:.6f},{blue:.6f})",
                    f"FILL_AREA_STYLE_COLOUR('',#{first})",
                    f"FILL_AREA_STYLE('',(#{first + 1}))",
                    f"SURFACE_STYLE_FILL_AREA(#{first + 2})",
                    f"SURFACE_SIDE_STYLE('',(#{first + 3}))",
                    f"SURFACE_STYLE_USAGE(.BOTH.,#{first + 4})",
                    f"PRESENTATION_STYLE_ASSIGNMENT((#{first + 5}))",
                    f"STYLED_ITEM('color',(#{first + 6}),{face})"]
        lines += [f"#{first + k} = {entity};" for k, entity in enumerate(entities)]
        next_id += len(entities)
        items.append(f"#{next_id - 1}")
        text = text.replace(f"{face} = ADVANCED_FACE('',", f"{face} = ADVANCED_FACE('{label}',")
    lines.append(f"#{next_id} = MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',({','.join(items)}),{context});")
    head, tail = text.rsplit("ENDSEC;", 1)
    Path(name).write_text(head + "\n".join(lines) + "\nENDSEC;" + tail, encoding="ascii")


def assembly():
    """A plate with the same pin at two places; a colour and a name for the top of the plate and for a side of the pin."""
    document = FreeCAD.newDocument("assembly")
    plate = document.addObject("Part::Feature", "Plate")
    plate.Shape = Part.makeBox(60, 40, 8)
    pin = document.addObject("Part::Feature", "Pin")
    pin.Shape = Part.makeCylinder(5, 20)
    whole = document.addObject("App::Part", "Assembly")
    whole.addObject(plate)
    for name, x in (("PinLeft", 15), ("PinRight", 45)):
        link = document.addObject("App::Link", name)
        link.LinkedObject = pin
        link.Placement.Base = Vector(x, 20, 8)
        whole.addObject(link)
    document.recompute()
    Import.export([whole], "assembly.step")
    without_date("assembly.step")
    with_styles("assembly.step", {6: ("top", ORANGE), 7: ("shaft", GREY)})


def tray():
    """A block of 60 by 40 by 20 mm with a pocket, whose corners are rounded by 5 mm, and an oblique hole of 8 mm through the floor."""
    hole = Part.makeBox(40, 20, 10, Vector(10, 10, 12))
    hole = hole.makeFillet(5, [edge for edge in hole.Edges if abs(edge.tangentAt(edge.FirstParameter).z) > 0.999])
    drill = Part.makeCylinder(4, 60, Vector(30, 20, 12) - Vector(15, 0, 20), Vector(3, 0, 4))
    return Part.makeBox(60, 40, 20).cut(hole).cut(drill)


export(mould(), "mould", iges=True)
export(primitives(), "primitives", iges=True)
export(pillow(), "pillow", iges=True)
bracket_in_inches()
assembly()
export(tray(), "tray", iges=False)
