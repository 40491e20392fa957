# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures on Kim and Choi, and on the verified paths beside theirs."""
from .style import COLOURS, MARKERS, column, label, look, number, panels

PAPER = "economic-cl-data"
NETS = ["net_rot24_7D", "net_full48_41D", "net_symU24_7D", "net_rot24_1A", "net_symV24_1A", "net_sym12_1A"]


def scallops(data):
    """Scallop height against the interval, by ball and curvature."""
    figure, axes = panels(2, 2.5, sharey=True)
    rows = [row for row in data.rows(f"{PAPER}/figure-5") if row["interval_mm"]]
    for i, curvature in enumerate((-0.08, -0.04, 0, 0.04, 0.08)):
        curve = [row for row in rows if row["radius_mm"] == "7.5" and number(row["curvature_per_mm"]) == curvature]
        style = {**look(i), "marker": ""}
        axes[0].plot(column(curve, "interval_mm"), column(curve, "scallop_mm"), **style,
                     label=f"$k$ = {curvature:g} mm$^{{-1}}$".replace("-0", "−0"))
    for i, radius in enumerate(sorted({number(row["radius_mm"]) for row in rows})):
        curve = [row for row in rows if number(row["radius_mm"]) == radius and number(row["curvature_per_mm"]) == 0]
        axes[1].plot(column(curve, "interval_mm"), column(curve, "scallop_mm"), **{**look(i), "marker": ""},
                     label=f"$R$ = {radius:g} mm")
    label(axes[0], "interval $l$, mm", "scallop height $h$, mm", "(a) ball of radius 7.5 mm")
    label(axes[1], "interval $l$, mm", "", "(b) plane, $k$ = 0")
    for one in axes:
        one.set(ylim=(0, 3), xlim=(0, 12))
        one.legend()
    return figure


def cells(data):
    """Relative deviation of every cell from the print, on the six nets."""
    figure, axes = panels(2, 2.7, sharey=True)
    for one, (table, unit, name) in zip(axes, (("table-1", "ncl_d{}", "NCL"), ("table-2", "tcd_d{}_mm", "TCD"))):
        rows = {row["row"]: row for row in data.rows(f"{PAPER}/{table}")}
        for i, net in enumerate(NETS):
            percents = []
            for tolerance in ("1", "0.5", "0.2"):
                for direction in "uv":
                    for ball in (10, 15, 20):
                        at = f"d={tolerance} {direction}"
                        print_cell = number(rows[f"print {at}"][unit.format(ball)])
                        net_cell = number(rows[f"{net} {at}"][unit.format(ball)])
                        percents.append(100 * (net_cell / print_cell - 1))
            one.plot(range(1, 19), percents, linestyle="", marker=MARKERS[i], color=COLOURS[i], markersize=3.5,
                     label=net.replace("net_", ""), markerfacecolor="none" if i % 2 else COLOURS[i])
        one.axhline(0, color="black", linewidth=0.6)
        for border in (6.5, 12.5):
            one.axvline(border, color="#999999", linewidth=0.6)
        one.set_xticks([3.5, 9.5, 15.5], ["1 mm", "0.5 mm", "0.2 mm"])
        one.grid(False, axis="x")
        label(one, "", "computed / printed − 1, %", name)
    axes[1].set_ylabel("")
    figure.supxlabel("chord tolerance; in each group passes along u, then along v, by rising ball", fontsize=9)
    axes[1].legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0, title="net")
    return figure


def paths(data):
    """Figures 12 and 13 of the paper: the paths along u and along v, seen from above."""
    figure, axes = panels(2, 2.4)
    for one, (item, direction) in zip(axes, (("figure-12", "u"), ("figure-13", "v"))):
        rows = data.rows(f"{PAPER}/{item}", "toolpath")
        one.plot(column(rows, "contact_x_mm"), column(rows, "contact_y_mm"), color="black", linewidth=0.35)
        label(one, "x, mm", "y, mm", f"({'ab'[direction == 'v']}) passes along {direction}")
        one.set_aspect("equal")
        one.grid(False)
    return figure


def noise(data):
    """Relative error of eq. (4) by form and precision."""
    figure, axes = panels(2, 2.6)
    forms = [("printed", "as printed"), ("factors", "in factors"), ("expanded", "expanded, corrected")]
    for one, precision, radius, scallop in ((axes[0], "double", 5, 0.01), (axes[1], "single", 7.5, 0.5)):
        rows = data.rows(f"{PAPER}/noise", radius_mm=radius, scallop_mm=scallop)
        for i, (form, text) in enumerate(forms):
            points = [(x / 1000, y) for x, y in
                      zip(column(rows, "section_radius_mm"), column(rows, f"{form}_{precision}")) if y > 0]
            one.plot(*zip(*points), **look(i), label=text)
        if precision == "double":
            points = [(x / 1000, y) for x, y in
                      zip(column(rows, "section_radius_mm"), column(rows, "stable_double")) if y > 0]
            one.plot(*zip(*points), **look(3), label="stable form")
        one.set(xscale="log", yscale="log")
        label(one, "radius of the section, m", "relative error of $l$",
              f"({'ab'[precision == 'single']}) {precision} precision, $R$ = {radius:g}, $h$ = {scallop:g} mm")
        one.legend()
    return figure


def verified(data):
    """Deepest gouge of the straight steps beside the pass, over the tolerance: the paper's plan and a verified one."""
    figure, (axes,) = panels(1, 2.9)
    rows = data.rows("verification/paths-judged")
    names = list(dict.fromkeys((row["surface"], row["direction"]) for row in rows))
    for i, mode in enumerate(("paper", "verified")):
        chosen = {(row["surface"], row["direction"]): row for row in rows if row["mode"] == mode}
        ratios = [number(chosen[name]["max_motion_gouge_mm"]) / number(chosen[name]["tolerance_mm"])
                  for name in names if name in chosen]
        axes.plot([k for k, name in enumerate(names) if name in chosen], [max(r, 1e-2) for r in ratios], linestyle="",
                  marker=MARKERS[i], color=COLOURS[1 + i], label=f"{mode}",
                  markerfacecolor=COLOURS[1 + i] if i == 0 else "none")
    axes.axhline(1, color="black", linewidth=0.8)
    axes.set(yscale="log", ylim=(8e-3, 30))
    shown = [f"{surface.removeprefix('net_')}" if direction == "u" else "" for surface, direction in names]
    axes.set_xticks([k + 0.5 for k, text in enumerate(shown) if text], [text for text in shown if text], rotation=45,
                    ha="right", rotation_mode="anchor", fontsize=7)
    axes.grid(False, axis="x")
    label(axes, "surface; left along u, right along v", "motion gouge / tolerance")
    axes.legend(loc="lower right", ncols=2)
    return figure


def angles(data):
    """Length of planar passes against their direction, by contacts and by tips."""
    figure, axes = panels(2, 2.4)
    for one, surface, title in zip(axes, ("cylinder", "saddle"), ("(a) cylinder", "(b) saddle")):
        rows = data.rows("economy/directions", "angles", surface=surface, distance="contact")
        for i, (name, text) in enumerate((("cut_contact_mm", "by contacts"), ("cut_tip_mm", "by tips"))):
            one.plot(column(rows, "angle_deg"), column(rows, name), **{**look(i), "marker": ""}, label=text)
        one.set_xticks(range(0, 181, 45))
        label(one, "direction of the passes, degrees", "length of the cuts, mm", title)
        one.legend()
    return figure


FIGURES = {"angles": angles, "scallops": scallops, "cells": cells, "paths": paths, "noise": noise, "verified": verified}
