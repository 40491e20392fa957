# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the meshes of datasets/meshes as (vertices, triangles), and measures them."""
import re
import struct
from collections import Counter


def from_corners(corners):
    """A mesh of triples of points. Equal points become one vertex."""
    numbers = {}
    triangles = [tuple(numbers.setdefault(c, len(numbers)) for c in t) for t in corners]
    return list(numbers), triangles


def read_stl(content):
    if content.startswith(b"solid "):
        points = [tuple(map(float, row.split()[1:]))
                  for row in re.findall(r"vertex.*", content.decode())]
    else:
        count, = struct.unpack_from("<I", content, 80)
        assert len(content) == 84 + 50 * count
        facets = [struct.unpack_from("<12f", content, 84 + 50 * k) for k in range(count)]
        points = [f[k:k + 3] for f in facets for k in (3, 6, 9)]
    return from_corners(zip(*[iter(points)] * 3))


def read_obj(content):
    rows = [line.split() for line in content.decode().splitlines()]
    vertices = [tuple(map(float, r[1:])) for r in rows if r[0] == "v"]
    return vertices, [tuple(int(k) - 1 for k in r[1:]) for r in rows if r[0] == "f"]


def read_ply(content):
    head, body = content.split(b"end_header\n", 1)
    vertices, faces = (int(n) for n in re.findall(rb"element \w+ (\d+)", head))
    points = list(struct.iter_unpack("<3d", body[:24 * vertices]))
    triangles = list(struct.iter_unpack("<B3i", body[24 * vertices:]))
    assert len(triangles) == faces and all(t[0] == 3 for t in triangles)
    return points, [t[1:] for t in triangles]


def read_off(content):
    head, counts, *rows = content.decode().splitlines()
    vertices, faces, _ = map(int, counts.split())
    assert head == "OFF" and len(rows) == vertices + faces
    points = [tuple(map(float, row.split())) for row in rows[:vertices]]
    return points, [tuple(map(int, row.split()))[1:] for row in rows[vertices:]]


def read_mesh(path):
    read = {".stl": read_stl, ".obj": read_obj, ".ply": read_ply, ".off": read_off}
    return read[path.suffix](path.read_bytes())


def edges(triangles):
    """The number of occurrences of each directed edge."""
    return Counter(edge for a, b, c in triangles for edge in ((a, b), (b, c), (c, a)))


def border_edges(triangles):
    """The number of edges without an opposite edge. Raises an error if an edge occurs twice in one direction."""
    found = edges(triangles)
    assert max(found.values()) == 1
    return [edge for edge in found if edge[::-1] not in found]


def sheets_at(triangles):
    """For every vertex, the number of separate fans of triangles around it."""
    onward = {}
    for a, b, c in triangles:
        for here, start, end in ((a, b, c), (b, c, a), (c, a, b)):
            onward.setdefault(here, {})[start] = end
    sheets = {}
    for vertex, ring in onward.items():
        sheets[vertex] = 0
        while ring:
            at = next(iter(ring.keys() - set(ring.values()) or ring))
            while at in ring:
                at = ring.pop(at)
            sheets[vertex] += 1
    return sheets


def volume(vertices, triangles):
    total = 0
    for triangle in triangles:
        (a, b, c), (d, e, f), (g, h, i) = (vertices[k] for k in triangle)
        total += a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return total / 6
