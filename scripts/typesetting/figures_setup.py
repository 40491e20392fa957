# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures on Kang and Suh, and the summary of all verdicts."""
import numpy as np

from .claims_table import PAPERS
from .style import COLOURS, bars, column, label, look, number, panels

PAPER = "five-axis-setup"
GRIDS = ["hex:10", "cube:10", "latlong:40x16", "latlong:30x21", "ico:3", "ico:4"]
VERDICTS = ["reproduced", "print agrees", "calibrated", "differs", "print disagrees", "not recoverable",
            "not in the paper"]
SHADES = ["#0072B2", "#8cc5e8", "#cccccc", "#D55E00", "#f0a875", "#ffffff", "#000000"]


def verdicts(data):
    """Share of the claims with each verdict, by paper."""
    figure, (axes,) = panels(1, 2.0)
    for k, paper in enumerate(PAPERS):
        rows = [row for row in data.claims if row["paper"] == paper and row["verdict"] in VERDICTS]
        start = 0
        for i, verdict in enumerate(VERDICTS):
            count = sum(row["verdict"] == verdict for row in rows)
            axes.barh(k, count, left=start, height=0.65, color=SHADES[i], edgecolor="black", linewidth=0.5,
                      hatch=("", "", "...", "", "", "///", "")[i], label=None if k else verdict)
            start += count
    axes.set_yticks(range(len(PAPERS)), [text.split(":")[0] for text in PAPERS.values()])
    axes.invert_yaxis()
    axes.grid(False, axis="y")
    label(axes, "claims", "")
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    return figure


def project(points):
    """Points of the unit sphere seen from a fixed direction: across, up, and towards the eye."""
    azimuth, height = np.radians(-55), np.radians(25)
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0])
    eye = np.array([np.cos(azimuth) * np.cos(height), np.sin(azimuth) * np.cos(height), np.sin(height)])
    up = np.cross(eye, right)
    return points @ right, points @ up, points @ eye


def motions(data):
    """Borders of the feasible tool motion on the sphere."""
    figure, axes = panels(4, 1.9)
    chosen = ["figure 5 (a): C and A", "figure 5 (b): A and B", "figure 6 (a): C not limited", "R2 not limited"]
    titles = ["(a) C and A", "(b) A and B", "(c) C without limits", "(d) second axis\nwithout limits"]
    circle = np.linspace(0, 2 * np.pi, 200)
    for one, name, title in zip(axes, chosen, titles):
        one.plot(np.cos(circle), np.sin(circle), color="#777777", linewidth=0.6)
        rows = data.rows(f"{PAPER}/feasible-motion", "edges", row=name)
        for edge in dict.fromkeys(row["edge"] for row in rows):
            part = [row for row in rows if row["edge"] == edge]
            across, up, towards = project(np.array([column(part, axis) for axis in "xyz"]).T)
            for front in (True, False):
                seen = (towards >= 0) == front
                one.plot(np.where(seen, across, np.nan), np.where(seen, up, np.nan),
                         color=COLOURS[1] if front else "#888888", linewidth=1.5 if front else 0.7,
                         linestyle="-" if front else "--")
        across, up, _ = project(np.array([[0, 0, 1.0]]))
        one.plot(across, up, "o", color="black", markersize=3)
        one.set_aspect("equal")
        one.set_axis_off()
        one.set_title(title, loc="center")
    return figure


def candidates(data):
    """The area of every candidate of the best pose."""
    figure, axes = panels(2, 2.4)
    rows = data.rows(f"{PAPER}/figure-13-14", "sectors")
    axes[0].plot(column(rows, "from_deg"), [v / 1000 for v in column(rows, "area_deg2")], **look(1))
    label(axes[0], "azimuth of the sector's end, degrees", "$F$, 1000 square degrees", "(a) C,A: double sectors")
    for i, kind in enumerate(dict.fromkeys(row["kind"] for row in data.rows(f"{PAPER}/figure-13-14", "rectangles"))):
        rows = data.rows(f"{PAPER}/figure-13-14", "rectangles", kind=kind)
        axes[1].plot(column(rows, "r1_azimuth_deg"), [v / 1000 for v in column(rows, "area_deg2")], linestyle="",
                     marker="os"[i], color=COLOURS[1 + i], markerfacecolor=COLOURS[1] if i == 0 else "none",
                     label=kind)
    label(axes[1], "azimuth of R1, degrees", "$F$, 1000 square degrees", "(b) A,B: rectangles")
    axes[1].legend()
    return figure


def modes(data):
    """Floored area of the best pose: nearest cells against whole cones, with the certified bound."""
    figure, (axes,) = panels(1, 2.4)
    names, series = [], {"nearest cells, paper": [], "nearest cells, exact": [], "whole cones": []}
    for family in ("AB", "CA"):
        for incidence in (90, 80, 60):
            row = data.row(f"{PAPER}/modes", f"{family}, {incidence}, floored-area")
            names.append(f"{family[0]},{family[1]}, {incidence}°")
            for key, name in zip(series, ("paper", "corrected", "set")):
                series[key].append(number(row[name]) or float("nan"))
    bars(axes, names, series)
    axes.set(yscale="log", ylim=(500, 9e4))
    label(axes, "family of machines, incidence limit", "floored area, square degrees")
    axes.legend(ncols=3, loc="upper left")
    return figure


def literal(data):
    """The printed rectangle's area against the area that its pose needs."""
    figure, (axes,) = panels(1, 2.4)
    rows = [data.row(f"{PAPER}/teapot-grids", f"{grid}, 90, AB, paper-literal") for grid in GRIDS]
    right = [data.row(f"{PAPER}/teapot-grids", f"{grid}, 90, AB, corrected") for grid in GRIDS]
    bars(axes, GRIDS, {"claimed by the printed rule": column(rows, "area_deg2"),
                       "needed by that pose": column(rows, "true_area_deg2"),
                       "exact minimum": column(right, "area_deg2")})
    axes.tick_params(axis="x", labelsize=7)
    label(axes, "grid of directions", "$F$, square degrees")
    axes.legend()
    return figure


def growth(data):
    """Time for each pair of triangle and direction."""
    figure, axes = panels(2, 2.5, sharey=True)
    rows = [row for row in data.rows(f"{PAPER}/complexity") if row["size"]]
    for one, sweep in zip(axes, ("triangles", "directions")):
        for i, work in enumerate(dict.fromkeys(row["work"] for row in rows)):
            curve = [row for row in rows if row["work"] == work and row["sweep"] == sweep]
            one.plot(column(curve, "size"), column(curve, "ns_a_pair"), **look(i), label=work)
        one.set(xscale="log", yscale="log")
        if sweep == "directions":
            one.set_xticks([200, 500, 1000, 2000, 5000], ["200", "500", "1000", "2000", "5000"])
            one.minorticks_off()
        label(one, sweep, "time, ns a pair" if sweep == "triangles" else "",
              f"({'ab'[sweep == 'directions']}) by {sweep}")
    axes[1].legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    return figure


FIGURES = {"verdicts": verdicts, "motions": motions, "candidates": candidates, "modes": modes, "literal": literal,
           "growth": growth}
