# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures on Jang, Kim and Jeong."""
import numpy as np

from .style import COLOURS, bars, column, label, look, number, panels

PAPER = "interference"
METHODS = ["1", "2", "3 scan", "3 march", "3r", "envelope"]


def swallowtail(_):
    """The offset of a parabola by a radius above its least radius of curvature: a drawing by the closed form."""
    figure, axes = panels(2, 2.5)
    p, radius = 1.0, 2.0
    t = np.linspace(-4, 4, 2001)
    w = np.sqrt(1 + (t / p) ** 2)
    s, z = t - radius * t / (p * w), t**2 / (2 * p) + radius / w
    crossing, cusp = np.sqrt(radius**2 - p**2), p * np.sqrt((radius / p) ** (2 / 3) - 1)
    ball = np.linspace(0, 2 * np.pi, 200)
    for one in axes:
        one.plot(t, t**2 / (2 * p), color="#777777", linewidth=2.2, label="part")
        kept = np.abs(t) >= crossing
        for side in (t <= -crossing, t >= crossing):
            one.plot(s[side], z[side], color=COLOURS[1], label="kept" if side[0] else None)
        one.plot(s[~kept], z[~kept], color=COLOURS[2], linestyle="--", label="removed loop")
        one.set_aspect("equal")
        one.grid(False)
    height = p / 2 + radius**2 / (2 * p)
    axes[0].plot(radius * np.cos(ball), height + radius * np.sin(ball), color="black", linewidth=0.6, label="ball")
    axes[0].set(xlim=(-3.6, 3.6), ylim=(-0.2, 6.2))
    axes[1].legend(*axes[0].get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    axes[1].set(xlim=(-0.75, 0.75), ylim=(1.65, 2.75))
    cusp_s = cusp - radius * cusp / (p * np.sqrt(1 + (cusp / p) ** 2))
    cusp_z = cusp**2 / (2 * p) + radius / np.sqrt(1 + (cusp / p) ** 2)
    axes[1].annotate("crossing q", (0, height), (0.16, height - 0.04), fontsize=8)
    for sign in (-1, 1):
        axes[1].annotate("cusp", (sign * cusp_s, cusp_z), (sign * abs(cusp_s) - 0.06, cusp_z - 0.12), fontsize=8,
                         color="black")
    for one, text in zip(axes, ("(a) parabola and ball", "(b) the swallowtail")):
        label(one, "s, in units of p", "z, in units of p", text)
    return figure


def other_cutter(data):
    """Stock and gouge when the offset of a ball guides another cutter."""
    figure, axes = panels(2, 2.4)
    for i, (cutter, text) in enumerate((("bull:20:3", "bull-nose, $r$ = 3 mm"), ("flat:20", "flat, $r$ = 0"))):
        rows = data.rows(f"{PAPER}/figure-2", cutter=cutter)
        slopes = column(rows, "slope_deg")
        for one, name in zip(axes, ("stock", "gouge")):
            one.plot(slopes, column(rows, f"{name}_mm"), **{**look(i), "marker": ""}, label=f"{text}: closed form")
            one.plot(slopes, column(rows, f"{name}_plane_mm"), linestyle="", marker="os"[i], color=COLOURS[i],
                     markerfacecolor="none", label="simulated, plane")
            one.plot(slopes, column(rows, f"{name}_valley_mm"), linestyle="", marker="x", color=COLOURS[i],
                     label="simulated, valley")
    label(axes[0], "slope, degrees", "stock along the normal, mm", "(a) reference points equated")
    label(axes[1], "slope, degrees", "gouge along the normal, mm", "(b) tips equated")
    axes[0].legend(fontsize=7)
    return figure


def increment(data):
    """Crossings that method 1 finds, and its search time, against the step."""
    figure, axes = panels(2, 2.5)
    for i, feed in enumerate(("0", "-15")):
        rows = [row for row in data.rows(f"{PAPER}/increment")
                if row["row"].startswith(f"at {feed} deg, step") and "stated" not in row["row"]]
        steps = [number(row["row"].split("step ")[1]) for row in rows]
        folds = number(data.row(f"{PAPER}/increment", f"at {feed} deg, method 3")["hits_at_4"])
        name = f"feed {feed.replace('-', '−')}°"
        axes[0].plot(steps, [100 * m / folds for m in column(rows, "missed")], **look(2 * i),
                     label=f"{name}, threshold = step")
        axes[0].plot(steps, [100 * m / folds for m in column(rows, "missed_at_4")], **look(2 * i + 1),
                     label=f"{name}, threshold = 4 steps")
        axes[1].plot(steps, column(rows, "search_over_method_2"), **look(2 * i), label=name)
    axes[1].axhline(1, color="black", linewidth=0.6)
    axes[0].set(xscale="log", ylim=(-2, 75))
    axes[1].set(xscale="log", yscale="log")
    label(axes[0], "step of method 1, mm", "crossings missed, % of method 3's", "(a) crossings")
    label(axes[1], "step of method 1, mm", "search time / that of method 2", "(b) time")
    axes[0].legend(fontsize=7, loc="upper right")
    axes[1].legend()
    return figure


def correctness(data):
    """Share of the curves that each method trims wrongly."""
    figure, (axes,) = panels(1, 2.7)
    rows = [row for row in data.rows(f"{PAPER}/correctness")
            if "stated" not in row["row"] and "no twist" not in row["row"]]
    names = [row["row"].replace("sections at ", "").replace(" deg, ", "°\n").replace("convex, ", "convex,\n")
             .replace("-15", "−15") for row in rows]
    shares = {text: [100 * a / b for a, b in zip(column(rows, name), column(rows, "curves"))]
              for text, name in (("3, literal", "literal 3"), ("3, guarded", "guarded 3"), ("3r", "3r"))}
    bars(axes, names, shares)
    axes.tick_params(axis="x", labelsize=6.5)
    label(axes, "set of curves", "curves trimmed wrongly, %")
    axes.legend()
    return figure


def complexity(data):
    """Time for each point against the number of points."""
    figure, (axes,) = panels(1, 2.5)
    rows = data.rows(f"{PAPER}/complexity")
    for i, method in enumerate(METHODS):
        curve = [row for row in rows if row["method"] == method]
        axes.plot(column(curve, "points"), column(curve, "ns_a_point"), **look(i),
                  label=f"method {method}" if method[0].isdigit() else method)
    axes.set(xscale="log", yscale="log")
    label(axes, "points on the curve", "time, ns a point")
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    return figure


def gouges(data):
    """Deepest gouge of the trimmed sections, by method and feed."""
    figure, (axes,) = panels(1, 2.4)
    names = ["untrimmed", "1 literal", "2 literal", "3 as printed", "3 guarded", "3r", "envelope",
             "envelope, border touched, grid 200"]
    series = {}
    for feed in ("0", "-15"):
        gouges_of = {row["row"]: number(row["gouge_mm"]) for row in data.rows(f"{PAPER}/figure-18")}
        series[f"feed {feed.replace('-', '−')}°"] = [gouges_of.get(f"at {feed} deg, {name}", float("nan"))
                                                    for name in names]
    bars(axes, ["untrimmed", "1", "2", "3", "3, guarded", "3r", "envelope", "envelope,\nborder"], series)
    axes.set(yscale="log", ylim=(5e-4, 20))
    label(axes, "method", "deepest gouge, mm")
    axes.legend(ncols=2, loc="upper right")
    return figure


FIGURES = {"swallowtail": swallowtail, "other-cutter": other_cutter, "increment": increment,
           "correctness": correctness, "trimming-time": complexity, "gouges": gouges}
