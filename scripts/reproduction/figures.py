# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the figures that params.json describes as SVG. The result is reproducible."""
import math
import re

import matplotlib
import numpy as np

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402 (the backend is chosen first)
from matplotlib.ticker import LogFormatter, LogFormatterSciNotation  # noqa: E402

from .fault import Fault  # noqa: E402
from .tables import Table, number, read_table  # noqa: E402

# A plain name keeps the file inside the results folder.
FILE_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,59}\.(svg|csv)")
FIGURE_KEYS = ("file", "caption", "published_caption", "plot")
PLOT_KEYS = {"csv", "x", "y", "group_by", "filter", "labels", "x_scale", "y_scale",
             "x_label", "y_label", "title", "kind", "points"}
KINDS = {"line", "points", "bar", "surface"}
STYLE = {
    "svg.hashsalt": "endmill",  # ids in the file would otherwise be random
    "font.size": 10,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#dddddd",
    "axes.spines.top": False,
    "axes.spines.right": False,
    # Okabe and Ito's colours, which colour-blind readers can distinguish.
    "axes.prop_cycle": matplotlib.cycler(color=["#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                "#E69F00", "#56B4E9", "#000000"]),
}
MARKERS = "osD^vP*"


class PlainLogFormatter(LogFormatter):
    """Labels the same ticks as 0.2 instead of 2e-01."""

    def __call__(self, x, pos=None):
        return f"{x:g}" if super().__call__(x, pos) else ""


def figures_of(params):
    """The figures of params.json. Checks that each has a plain file name and a caption.

    `published_caption` quotes the caption of the paper's figure that this one shows again.
    """
    figures = params.get("figures", [])
    for figure in figures:
        name = figure.get("file", "")
        if not FILE_NAME.fullmatch(name) or not name.endswith(".svg"):
            raise Fault(f"params.json: figure file {name!r}: expected a plain name ending in .svg")
        if not figure.get("caption"):
            raise Fault(f"params.json: figure {name} has no caption")
        if figure.keys() - set(FIGURE_KEYS):
            raise Fault(f"params.json: figure {name}: unknown keys, expected {', '.join(FIGURE_KEYS)}")
        if not isinstance(figure.get("published_caption", "words"), str):
            raise Fault(f"params.json: figure {name}: published_caption is a text")
    return figures


def draw_all(params, folder):
    """Draws every figure with a "plot" into `folder`, where the CSV files are.

    The driver writes the figures without "plot", and they must exist.
    """
    for figure in figures_of(params):
        path = folder / figure["file"]
        if "plot" in figure:
            draw(figure["plot"], folder, path)
        elif not path.is_file():
            raise Fault(f"{figure['file']}: not written by the driver, and no plot in params.json")


def draw(plot, folder, path):
    """Draws one plot of params.json into the SVG file `path`."""
    check(plot, path.name)
    table = filtered(read_table(folder / plot["csv"]), plot)
    with plt.rc_context(STYLE):
        if plot.get("kind") == "surface":
            draw_surface(plot, table, path)
            return
        figure, axes = plt.subplots(figsize=(7.2, 4.2), layout="constrained")
        curves = list(curves_of(table, plot))
        if plot.get("kind") == "bar":
            draw_bars(axes, curves)
        else:
            draw_curves(axes, curves, plot)
        dress(axes, plot, legend=len(curves) > 1)
        figure.savefig(path, metadata={"Date": None, "Creator": None})
        plt.close(figure)


def check(plot, name):
    """Raises Fault if `plot` has unknown, missing or wrong values."""
    where = f"params.json: plot of {name}"
    unknown = plot.keys() - PLOT_KEYS
    missing = {"csv", "x", "y"} - plot.keys()
    if unknown or missing:
        raise Fault(f"{where}: unknown keys {sorted(unknown)}, missing {sorted(missing)}")
    if not isinstance(plot["y"], list):
        raise Fault(f"{where}: y is a list of columns")
    if plot.get("kind", "line") not in KINDS:
        raise Fault(f"{where}: kind is one of {sorted(KINDS)}")
    if plot.get("kind") == "surface" and ("group_by" not in plot or len(plot["y"]) != 1):
        raise Fault(f"{where}: a surface has one column y, over x and group_by")
    if not FILE_NAME.fullmatch(plot["csv"]):
        raise Fault(f"{where}: csv {plot['csv']!r} is no plain file name")


def filtered(table, plot):
    """The rows that "filter" keeps. Raises Fault if the table lacks a column of the plot."""
    kept = plot.get("filter", {})
    named = {plot["x"], *plot["y"], *kept, plot.get("group_by", plot["x"])}
    absent = named - set(table.header)
    if absent:
        raise Fault(f"{plot['csv']}: a plot names columns that are not there: {sorted(absent)}")
    places = {table.header.index(column): value for column, value in kept.items()}
    rows = [row for row in table.rows if all(same(row[i], v) for i, v in places.items())]
    if not rows:
        raise Fault(f"{plot['csv']}: nothing to plot, no row or none that the filter keeps")
    return Table(table.header, rows)


def same(text, value):
    """Whether a cell has the value of a filter. Numbers such as 0.5 and 0.50 are equal."""
    return text == str(value) or (number(text) is not None and number(text) == number(str(value)))


def curves_of(table, plot):
    """(label, x texts, y numbers) of each curve: one per y column and value of group_by."""
    groups = table.column(plot["group_by"]) if "group_by" in plot else [None] * len(table.rows)
    for group in dict.fromkeys(groups):
        for column in plot["y"]:
            points = [(x, number(y)) for x, y, its_group
                      in zip(table.column(plot["x"]), table.column(column), groups)
                      if its_group == group]
            ys = [math.nan if y is None else y for _, y in points]  # a gap in the curve
            yield label_of(plot, group, column), [x for x, _ in points], ys


def label_of(plot, group, column):
    """The label of a curve in the legend."""
    labels = plot.get("labels", {})
    if group is None:
        return labels.get(column, column)
    grouped_by = labels.get(plot["group_by"], plot["group_by"])
    words = labels.get(group, f"{grouped_by} {group}")
    return f"{words}, {labels.get(column, column)}" if len(plot["y"]) > 1 else words


def positions(axes, curves):
    """Maps texts to positions on the x axis. Words keep their order at unit distance, with ticks."""
    texts = list(dict.fromkeys(text for _, xs, _ in curves for text in xs))
    if all(number(text) is not None for text in texts):
        return {text: number(text) for text in texts}
    name_ticks(axes, texts)
    return {text: i for i, text in enumerate(texts)}


def name_ticks(axes, texts):
    crowded = sum(len(text) for text in texts) > 60
    axes.set_xticks(range(len(texts)), texts, rotation=45 if crowded else 0,
                    ha="right" if crowded else "center", rotation_mode="anchor")
    axes.grid(False, axis="x")


def draw_curves(axes, curves, plot):
    """Draws lines, or points for the groups of "points"."""
    place = positions(axes, curves)
    unjoined = {label_of(plot, group, column) for group in plot.get("points", []) for column in plot["y"]}
    for i, (label, xs, ys) in enumerate(curves):
        are_points = plot.get("kind") == "points" or label in unjoined
        few = len(xs) <= 30 and not unjoined  # markers would only thicken a dense curve
        marker = MARKERS[i % len(MARKERS)] if are_points or few else ""
        axes.plot([place[x] for x in xs], ys, label=label, marker=marker, markersize=5,
                  linewidth=1.6, linestyle="" if are_points else "-")


def draw_bars(axes, curves):
    """Draws bars side by side. The x of a bar is a name, even if it is a number."""
    texts = list(dict.fromkeys(text for _, xs, _ in curves for text in xs))
    name_ticks(axes, texts)
    width = 0.8 / len(curves)
    for i, (label, xs, ys) in enumerate(curves):
        offset = (i - (len(curves) - 1) / 2) * width
        axes.bar([texts.index(x) + offset for x in xs], ys, width=width, label=label)


def grid_of(table, plot):
    """Sorted values of x and group_by, and the rows of y over them. Raises Fault for a missing value."""
    across, along = (sorted({number(text) for text in table.column(plot[key])}) for key in ("x", "group_by"))
    cells = {(number(x), number(other)): number(y) for x, other, y in
             zip(*(table.column(column) for column in (plot["x"], plot["group_by"], plot["y"][0])))}
    if len(across) < 2 or len(along) < 2 or len(cells) != len(across) * len(along):
        raise Fault(f"{plot['csv']}: a surface needs a number for every x with every {plot['group_by']}")
    return across, along, [[cells[x, other] for x in across] for other in along]


def draw_surface(plot, table, path):
    """Draws a column over two others, as a net seen from above. Nearer faces cover farther ones."""
    across, along, rows = grid_of(table, plot)
    labels = plot.get("labels", {})
    figure = plt.figure(figsize=(7.2, 5.2), layout="constrained")
    axes = figure.add_subplot(projection="3d", proj_type="ortho")
    axes.plot_surface(np.array([across] * len(along)), np.array([[y] * len(across) for y in along]), np.array(rows),
                      rstride=1, cstride=1, color="#cfe0f2", edgecolor="#12365f", linewidth=0.5, shade=False)
    axes.view_init(elev=30, azim=-55)
    axes.set_box_aspect((1, 1, 0.7), zoom=1.05)
    axes.set_xlabel(plot.get("x_label", labels.get(plot["x"], plot["x"])), labelpad=8)
    axes.set_ylabel(labels.get(plot["group_by"], plot["group_by"]), labelpad=8)
    axes.set_zlabel(plot.get("y_label", labels.get(plot["y"][0], plot["y"][0])), labelpad=8)
    if "title" in plot:
        axes.set_title(plot["title"], fontsize=11, loc="left")
    figure.savefig(path, metadata={"Date": None, "Creator": None})
    plt.close(figure)


def dress(axes, plot, legend):
    """Sets scales, labels with units, title, and the legend beside the data."""
    labels = plot.get("labels", {})
    if plot.get("kind") != "bar":
        axes.set_xscale(plot.get("x_scale", "linear"))
    axes.set_yscale(plot.get("y_scale", "linear"))
    for axis in (axes.xaxis, axes.yaxis):
        if axis.get_scale() == "log":  # a scale of a decade or two shows more than one number
            low, high = axis.get_view_interval()
            plain = 1e-3 <= low and high <= 1e4 and high < 30 * low  # 0.2, not 2 times a power of ten
            formatter = PlainLogFormatter if plain else LogFormatterSciNotation
            axis.set_minor_formatter(formatter(minor_thresholds=(2, 0.5)))
            if plain:
                axis.set_major_formatter(formatter())
    axes.set_xlabel(plot.get("x_label", labels.get(plot["x"], plot["x"])))
    axes.set_ylabel(plot.get("y_label", ", ".join(labels.get(y, y) for y in plot["y"])))
    if "title" in plot:
        axes.set_title(plot["title"], fontsize=11, loc="left")
    if legend:
        axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0, frameon=False)
