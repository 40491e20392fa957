# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures on Park and Maeng."""
import numpy as np

from .style import COLOURS, HATCHES, column, label, look, number, panels

PAPER = "ball-end-milling"


def coefficient(data):
    """The coefficient I1 against both slopes."""
    figure, axes = panels(2, 2.6, sharey=True)
    for i, slope in enumerate((-60, -30, 0, 30, 60)):
        curve = data.rows(f"{PAPER}/figure-3", lambda_deg=slope)
        for one, name in zip(axes, ("i1", "i1_exact_chip")):
            one.plot(column(curve, "mu_deg"), column(curve, name), **look(i),
                     label=f"$\\lambda$ = {slope}°".replace("-", "−"))
    label(axes[0], "slope of the pick feed $\\mu$, degrees", "$I_1$", "(a) chip of the paper")
    label(axes[1], "slope of the pick feed $\\mu$, degrees", "", "(b) exact chip")
    axes[1].legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    return figure


def tool_life(data):
    """The data of figure 4 and the fitted speed."""
    figure, (axes,) = panels(1, 2.4)
    rows = [row for row in data.rows(f"{PAPER}/figure-4") if row["row"].startswith("datum")]
    fit = data.row(f"{PAPER}/figure-4", "refit")
    shares = np.linspace(0.1, 0.55, 100)
    speeds = number(fit["v1_m_per_min"]) * shares ** -number(fit["alpha"])
    axes.plot(shares, speeds, color=COLOURS[1], label="fit, $V = V_1 (\\varphi/\\pi)^{-\\alpha}$")
    axes.plot(column(rows, "phi_over_pi"), column(rows, "v_m_per_min"), "o", color=COLOURS[0], label="printed data")
    axes.set(xscale="log", yscale="log")
    axes.set_xticks([0.1, 0.2, 0.3, 0.4, 0.5], ["0.1", "0.2", "0.3", "0.4", "0.5"])
    axes.set_yticks([35, 40, 50, 60, 70], ["35", "40", "50", "60", "70"])
    axes.minorticks_off()
    label(axes, "engaged angle $\\varphi/\\pi$", "cutting speed, m/min")
    axes.legend()
    return figure


def feed_along_path(data):
    """Depth, slopes and feed of the first passes of the reference path, for both materials."""
    figure, axes = panels(1, 4.2)
    figure.clear()
    axes = figure.subplots(4, 1, sharex=True)
    for i, material in enumerate(("steel", "aluminium")):
        rows = [row for row in data.rows(f"{PAPER}/figure-8-9", material) if 10 <= number(row["pass"]) < 14]
        ends = np.cumsum(column(rows, "length_mm"))
        feeds = [number(row["feed_per_tooth_mm"]) for row in rows]
        axes[3].plot(ends, feeds, **{**look(i), "marker": ""}, drawstyle="steps-pre", label=material)
        if i:
            continue
        axes[0].plot(ends, column(rows, "mu_deg"), **{**look(0), "marker": ""}, label="$\\mu$")
        axes[0].plot(ends, column(rows, "lambda_deg"), **{**look(2), "marker": ""}, label="$\\lambda$")
        axes[1].plot(ends, column(rows, "pick_feed_mm"), **{**look(0), "marker": ""}, label="$f_p$")
        axes[1].plot(ends, column(rows, "pick_feed_horizontal_mm"), **{**look(2), "marker": ""}, label="horizontal")
        axes[2].plot(ends, column(rows, "depth_mm"), **{**look(0), "marker": ""})
    for one, text in zip(axes, ("slope, degrees", "pick feed, mm", "depth $l$, mm", "feed $f_t$, mm")):
        one.set_ylabel(text)
        if one.get_legend_handles_labels()[0]:
            one.legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    axes[-1].set_xlabel("length along the passes, mm")
    return figure


def forces(data):
    """Forces along stroke A at constant and at varied feed, right-hand cutter."""
    figure, axes = panels(3, 2.5)
    for i, feed in enumerate(("constant", "varied")):
        rows = data.rows(f"{PAPER}/figure-10", "steel-right-hand-forces", feed=feed)
        for one, axis in zip(axes, "xyz"):
            for side in ("least", "greatest"):
                one.plot(column(rows, "travel_mm"), [v / 1000 for v in column(rows, f"{side}_{axis}_n")],
                         **{**look(i), "marker": ""}, label=feed if side == "least" else None)
    for one, axis in zip(axes, "xyz"):
        label(one, "travel, mm", "force, kN", f"$F_{axis}$")
    axes[2].legend(fontsize=7)
    return figure


def sensitivity(data):
    """Total times by one choice changed at a time."""
    figure, (axes,) = panels(1, 3.0)
    rows = [row for row in data.rows(f"{PAPER}/sensitivity") if row["total_min"]]
    names = list(dict.fromkeys(row["row"].split(", ", 1)[1] for row in rows))
    for i, material in enumerate(("steel", "aluminium")):
        times = [number(data.row(f"{PAPER}/sensitivity", f"{material}, {name}")["total_min"]) for name in names]
        axes.barh([k + (i - 0.5) * 0.4 for k in range(len(names))], times, height=0.36, label=material,
                  color=COLOURS[1 + 3 * i], hatch=HATCHES[i], edgecolor="white")
        axes.axvline(times[0], color=COLOURS[1 + 3 * i], linewidth=0.8, linestyle="--")
    axes.set_yticks(range(len(names)), names)
    axes.invert_yaxis()
    axes.grid(False, axis="y")
    label(axes, "total time, min", "")
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0)
    return figure


FIGURES = {"coefficient": coefficient, "tool-life": tool_life, "feed-along-path": feed_along_path,
           "stroke-forces": forces, "sensitivity": sensitivity}
