# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes in standard file formats, as bytes."""
import struct
from math import sqrt


def text(number):
    """The shortest text that is read back as the same number."""
    return repr(int(number)) if number == int(number) else repr(number)


def words(numbers):
    return " ".join(text(n) for n in numbers)


def normal(a, b, c):
    """The unit normal of a triangle."""
    p, q = ([y - x for x, y in zip(a, other)] for other in (b, c))
    cross = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
    length = sqrt(sum(n * n for n in cross))
    return [n / length + 0.0 for n in cross]  # + 0: no -0


def stl_ascii(name, vertices, triangles):
    lines = [f"solid {name}"]
    for triangle in triangles:
        corners = [vertices[k] for k in triangle]
        lines += [f"facet normal {words(normal(*corners))}", " outer loop",
                  *(f"  vertex {words(corner)}" for corner in corners), " endloop", "endfacet"]
    return "\n".join([*lines, f"endsolid {name}", ""]).encode()


def stl_binary(name, vertices, triangles):
    parts = [f"{name}, lengths in mm".encode().ljust(80, b"\0"), struct.pack("<I", len(triangles))]
    for triangle in triangles:
        corners = [vertices[k] for k in triangle]
        numbers = [n for vector in (normal(*corners), *corners) for n in vector]
        parts.append(struct.pack("<12fH", *numbers, 0))
    return b"".join(parts)


def obj(name, vertices, triangles):
    lines = [f"# {name}, lengths in mm", *(f"v {words(vertex)}" for vertex in vertices),
             *("f " + words(k + 1 for k in triangle) for triangle in triangles), ""]
    return "\n".join(lines).encode()


def ply_binary(name, vertices, triangles):
    """A little-endian PLY file with coordinates in double precision."""
    head = ["ply", "format binary_little_endian 1.0", f"comment {name}, lengths in mm",
            f"element vertex {len(vertices)}", *(f"property double {axis}" for axis in "xyz"),
            f"element face {len(triangles)}", "property list uchar int vertex_indices",
            "end_header", ""]
    return b"".join(["\n".join(head).encode(), *(struct.pack("<3d", *v) for v in vertices),
                     *(struct.pack("<B3i", 3, *triangle) for triangle in triangles)])


def bottom_facets(_, vertices, triangles):
    """The numbers of the triangles on the lowest level, on which the part stands."""
    lowest = min(z for _, _, z in vertices)
    numbers = [k for k, triangle in enumerate(triangles) if all(vertices[corner][2] == lowest for corner in triangle)]
    return "".join(["# the bottom: facets for --skip-facets\n", *(f"{k}\n" for k in numbers)]).encode()


def off(_, vertices, triangles):
    lines = ["OFF", f"{len(vertices)} {len(triangles)} 0", *map(words, vertices),
             *(f"3 {words(triangle)}" for triangle in triangles), ""]
    return "\n".join(lines).encode()
