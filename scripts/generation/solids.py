# SPDX-License-Identifier: GPL-3.0-or-later
"""Small closed parts: (vertices, triangles), counter-clockwise seen from outside, in mm."""
from math import cos, pi, sin

DOME_SIDES = 48  # a multiple of 8: the corners of the plate share the rim evenly
DOME_RINGS = 12

BLADES = 6
WHEEL_COLUMNS = 10  # columns of the hub for each blade, of which the blade takes one
WHEEL_ROWS = 10  # rows of the curved side of the hub
BLADE_ROWS = (1, 9)  # rows between which a blade stands
BLADE_LEVELS = 4  # rows of a blade
BLADE_HEIGHT = 12  # mm
HUB_TWIST, BLADE_LEAN = pi / 6, pi / 18  # from the bottom to the top of the hub, and of a blade

SADDLE_STEPS = 12  # facets of the saddle along x and along y
SADDLE_LENGTH, SADDLE_WIDTH, WALL = 60, 48, 6  # mm: along x, between the walls, of a wall
SADDLE_LEVEL, SADDLE_RISE, WALL_TOP = 10, 4, 26  # mm: in the middle, from there to the ends, of the walls

# Rounding makes the files independent of the mathematical library.
DECIMALS = 9


def fan(corners):
    """A fan of triangles for a face that is visible as a whole from its first corner."""
    return [(corners[0], a, b) for a, b in zip(corners[1:], corners[2:])]


def box_corners(low, high):
    """The lower four corners, then the upper four, each counter-clockwise seen from above."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    return [(x, y, z) for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]


def ring_of_quads(lower, upper):
    """Triangles between two closed rows of vertices, counter-clockwise seen from above."""
    count = len(lower)
    faces = [(lower[k], lower[(k + 1) % count], upper[(k + 1) % count], upper[k])
             for k in range(count)]
    return [triangle for face in faces for triangle in fan(face)]


def extrusion(outline, y0, y1):
    """A prism along y over an outline of (x, z) that is visible as a whole from its first corner."""
    count = len(outline)
    front, back = list(range(count)), list(range(count, 2 * count))
    vertices = [(x, y, z) for y in (y0, y1) for x, z in outline]
    return vertices, fan(front) + fan(back[:1] + back[:0:-1]) + ring_of_quads(back, front)


def prism():
    """A roof of 40 mm width, 15 mm height and 60 mm length, with flanks of 25 mm."""
    return extrusion([(0, 15), (-20, 0), (20, 0)], 0, 60)


def v_groove():
    """A block with a groove along y, 24 mm wide and 9 mm deep, flanks of 15 mm."""
    return extrusion([(0, 11), (-12, 20), (-30, 20), (-30, 0), (30, 0), (30, 20), (12, 20)],
                     -20, 20)


def pocket():
    """A block with a pocket of 40 x 20 x 10 mm in the middle of its top."""
    vertices = box_corners((-30, -20, 0), (30, 20, 20)) + box_corners((-20, -10, 10), (20, 10, 20))
    bottom, top, floor, rim = [list(range(k, k + 4)) for k in (0, 4, 8, 12)]
    return vertices, (fan(bottom[::-1]) + ring_of_quads(bottom, top) + ring_of_quads(top, rim)
                      + ring_of_quads(rim, floor) + fan(floor))


def corner_of_side(side):
    """The corner of the plate nearest to a side of the dome's rim."""
    return (side + DOME_SIDES // 8) // (DOME_SIDES // 4) % 4


def dome():
    """A half ball of radius 20 mm, vertices on the sphere, on a plate of 60 x 60 x 10 mm."""
    vertices = box_corners((-30, -30, 0), (30, 30, 10))
    rings = []
    for ring in range(DOME_RINGS):
        latitude = pi / 2 * ring / DOME_RINGS
        rings.append(range(len(vertices), len(vertices) + DOME_SIDES))
        for side in range(DOME_SIDES):
            longitude = 2 * pi * (side / DOME_SIDES - 3 / 8)  # -135 degrees: the first corner
            direction = (cos(latitude) * cos(longitude), cos(latitude) * sin(longitude),
                         sin(latitude))
            x, y, z = (round(20 * c, DECIMALS) + 0.0 for c in direction)  # + 0: no -0
            vertices.append((x, y, 10 + z))
    vertices.append((0, 0, 30))

    bottom, top, rim = list(range(4)), list(range(4, 8)), rings[0]
    triangles = fan(bottom[::-1]) + ring_of_quads(bottom, top)
    for side in range(DOME_SIDES):
        before, here = (corner_of_side(s) for s in (side - 1, side))
        if before != here:
            triangles.append((top[before], top[here], rim[side]))
        triangles.append((top[here], rim[(side + 1) % DOME_SIDES], rim[side]))
    for lower, upper in zip(rings, rings[1:]):
        triangles += ring_of_quads(lower, upper)
    last, pole = rings[-1], len(vertices) - 1
    triangles += [(last[k], last[(k + 1) % DOME_SIDES], pole) for k in range(DOME_SIDES)]
    return vertices, triangles


def hub_profile():
    """Points (r, z) of the side of the hub and their outward normals: a cylinder, then a quarter of an ellipse, concave."""
    points, normals = [(30, 0), (30, 6)], [(1, 0), (1, 0)]
    for row in range(1, WHEEL_ROWS + 1):
        angle = pi / 2 * row / WHEEL_ROWS
        points.append((30 - 18 * sin(angle), 26 - 20 * cos(angle)))
        normals.append((20 * sin(angle), 18 * cos(angle)))
    return points, [(r / (r * r + z * z)**0.5, z / (r * r + z * z)**0.5) for r, z in normals]


def wheel_point(row, column, level=0):
    """A point of the hub, or of a blade at a level above it. Columns turn with the rows, and blades lean."""
    (r, z), (out, up) = (values[row] for values in hub_profile())
    height = BLADE_HEIGHT * level / BLADE_LEVELS
    angle = (2 * pi * column / (BLADES * WHEEL_COLUMNS) + HUB_TWIST * max(0, row - 1) / WHEEL_ROWS
             + BLADE_LEAN * level / BLADE_LEVELS)
    radius = r + height * out
    return tuple(round(c, DECIMALS) + 0.0 for c in (radius * cos(angle), radius * sin(angle), z + height * up))


def bladed_wheel():
    """A hub of revolution of 60 mm diameter with six twisted blades, on the plane z = 0."""
    columns, rows = BLADES * WHEEL_COLUMNS, WHEEL_ROWS + 2
    first, last = (1 + row for row in BLADE_ROWS)
    vertices = [wheel_point(row, column) for row in range(rows) for column in range(columns)]
    vertices += [(0, 0, 0), (0, 0, 26)]

    def hub(row, column):
        return row * columns + column % columns

    triangles = []
    for row in range(rows - 1):
        for column in range(columns):
            if not (first <= row < last and column % WHEEL_COLUMNS == 0):
                triangles += fan([hub(row, column), hub(row, column + 1), hub(row + 1, column + 1), hub(row + 1, column)])
    for column in range(columns):
        triangles.append((columns * rows, hub(0, column + 1), hub(0, column)))
        triangles.append((columns * rows + 1, hub(rows - 1, column), hub(rows - 1, column + 1)))
    for blade in range(BLADES):
        column = blade * WHEEL_COLUMNS
        outline = [(row, column + 1) for row in range(first, last + 1)] + [(row, column) for row in range(last, first - 1, -1)]
        below = [hub(*at) for at in outline]
        for level in range(1, BLADE_LEVELS + 1):
            above = list(range(len(vertices), len(vertices) + len(outline)))
            vertices += [wheel_point(row, at, level) for row, at in outline]
            triangles += ring_of_quads(below, above)
            below = above
        for k in range(last - first):
            triangles += fan([below[-1 - k], below[k], below[k + 1], below[-2 - k]])
    return vertices, triangles


def walled_saddle():
    """A saddle that rises along x, between two vertical walls, on the plane z = 0."""
    steps, half, outer = SADDLE_STEPS, SADDLE_WIDTH / 2, SADDLE_WIDTH / 2 + WALL
    shares = [2 * k / steps - 1 for k in range(steps + 1)]  # from -1 to 1
    vertices = []
    for along in shares:
        floor = [(half * across, SADDLE_LEVEL + SADDLE_RISE * (along**2 - across**2)) for across in reversed(shares)]
        section = [(-outer, 0), (-half, 0), (half, 0), (outer, 0), (outer, WALL_TOP), (half, WALL_TOP),
                   *floor, (-half, WALL_TOP), (-outer, WALL_TOP)]
        vertices += [tuple(round(c, DECIMALS) + 0.0 for c in (SADDLE_LENGTH / 2 * along, y, z)) for y, z in section]
    count = len(vertices) // len(shares)
    rings = [list(range(first, first + count)) for first in range(0, len(vertices), count)]

    def end(ring):
        right, left = 6, count - 3  # the floor beside the walls
        return (fan([ring[0], ring[1], ring[left], ring[left + 1], ring[left + 2]])
                + fan([ring[1], ring[2], *ring[right:left + 1]])
                + fan([ring[3], ring[4], ring[5], ring[right], ring[2]]))

    triangles = [triangle[::-1] for triangle in end(rings[0])]
    for back, front in zip(rings, rings[1:]):
        triangles += ring_of_quads(back, front)
    return vertices, triangles + end(rings[-1])
