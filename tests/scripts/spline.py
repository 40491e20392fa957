# SPDX-License-Identifier: GPL-3.0-or-later
"""The bicubic not-a-knot spline of a height grid, independent of the library."""


def solve(matrix, right):
    """Solves matrix x = right by elimination with pivots. Both are lists of rows."""
    rows = [list(a) + list(b) for a, b in zip(matrix, right)]
    n = len(rows)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(n):
            if i != k and rows[i][k]:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    return [[value / row[k] for value in row[n:]] for k, row in enumerate(rows)]


def second_derivatives(knots):
    """A matrix whose row k gives the second derivative at knot k from the values at all knots."""
    n, h = len(knots), [b - a for a, b in zip(knots, knots[1:])]
    left = [[0.0] * n for _ in range(n)]
    right = [[0.0] * n for _ in range(n)]
    for k in range(1, n - 1):
        left[k][k - 1:k + 2] = h[k - 1], 2 * (h[k - 1] + h[k]), h[k]
        right[k][k - 1:k + 2] = 6 / h[k - 1], -6 / h[k - 1] - 6 / h[k], 6 / h[k]
    # The third derivative has no jump at the second knot and at the last but one.
    left[0][:3] = h[1], -h[0] - h[1], h[0]
    left[-1][-3:] = h[-1], -h[-1] - h[-2], h[-2]
    return solve(left, right)


def weights(knots, points):
    """A matrix whose rows give the value of the spline at each point from the values at all knots."""
    bending = second_derivatives(knots)
    result = []
    for x in points:
        k = max(i for i in range(len(knots) - 1) if knots[i] <= x)
        h = knots[k + 1] - knots[k]
        b = (x - knots[k]) / h
        a = 1 - b
        row = [h * h / 6 * ((a**3 - a) * p + (b**3 - b) * q)
               for p, q in zip(bending[k], bending[k + 1])]
        row[k] += a
        row[k + 1] += b
        result.append(row)
    return result


def heights(x, y, z, at_x, at_y):
    """z[y][x] of the spline at the points of a finer grid."""
    across, along = weights(x, at_x), weights(y, at_y)
    columns = [[sum(w * value for w, value in zip(row, line)) for row in across] for line in z]
    return [[sum(w * column for w, column in zip(row, values)) for values in zip(*columns)]
            for row in along]
