# SPDX-License-Identifier: GPL-3.0-or-later
"""The house style of the paper's figures: vector, readable in grey and with colour-blind eyes."""
import matplotlib

matplotlib.use("pdf")
import matplotlib.pyplot as plt  # noqa: E402 (the backend is chosen first)

from reproduction.fault import Fault  # noqa: E402
from reproduction.tables import number, read_table  # noqa: E402

WIDTH = 6.3  # inches, the width of the text
# Okabe and Ito's colours in the order of rising lightness, so that they differ in grey too.
COLOURS = ["#000000", "#0072B2", "#D55E00", "#009E73", "#56B4E9", "#E69F00"]
LINES = ["-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (1, 1))]
MARKERS = "os^Dv*"
HATCHES = ["", "///", "...", "xxx", "\\\\\\", "++"]
STYLE = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 9,
    "axes.labelsize": 9,
    "axes.titlesize": 9,
    "axes.titlelocation": "left",
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "legend.fontsize": 8,
    "legend.frameon": False,
    "axes.linewidth": 0.6,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "lines.linewidth": 1.2,
    "lines.markersize": 4,
    "hatch.linewidth": 0.5,
    "pdf.fonttype": 42,
}


class Data:
    """The tables of the experiments' results for the figures."""

    def __init__(self, results):
        self.results = results

    def table(self, experiment, name="result"):
        path = self.results / experiment / f"{name}.csv"
        if not path.is_file():
            raise Fault(f"{path} does not exist; scripts/reproduce.sh {experiment} makes it")
        return read_table(path)

    def rows(self, experiment, name="result", **conditions):
        """The rows as dictionaries, those only whose cells equal the conditions."""
        table = self.table(experiment, name)
        rows = [dict(zip(table.header, row)) for row in table.rows]
        return [row for row in rows if all(same(row[key], value) for key, value in conditions.items())]

    def row(self, experiment, label):
        """The row of result.csv with a label. Raises Fault if there is none."""
        found = self.rows(experiment, row=label)
        if not found:
            raise Fault(f"{self.results / experiment}/result.csv has no row {label!r}")
        return found[0]


def same(text, value):
    """Whether a cell has a value; numbers are equal in any notation."""
    return text == str(value) or (number(text) is not None and number(text) == number(str(value)))


def column(rows, name):
    """The numbers of a column; a cell without number is not a number."""
    return [float("nan") if number(row[name]) is None else number(row[name]) for row in rows]


def panels(count=1, height=2.6, **options):
    """A figure with `count` panels side by side, and its axes as a list."""
    figure, axes = plt.subplots(1, count, figsize=(WIDTH, height), layout="constrained", squeeze=False, **options)
    return figure, list(axes[0])


def look(i):
    """Colour, line and marker of curve number `i`."""
    return {"color": COLOURS[i % len(COLOURS)], "linestyle": LINES[i % len(LINES)],
            "marker": MARKERS[i % len(MARKERS)]}


def label(axes, x, y, title=""):
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.set_title(title)


def bars(axes, names, series, bottom=None):
    """Bars side by side: `series` maps a label to one value for each name."""
    width = 0.8 / len(series)
    for i, (text, values) in enumerate(series.items()):
        places = [k + (i - (len(series) - 1) / 2) * width for k in range(len(names))]
        axes.bar(places, values, width=0.9 * width, label=text, color=COLOURS[(i + 1) % len(COLOURS)],
                 hatch=HATCHES[i % len(HATCHES)], edgecolor="white", bottom=bottom)
    axes.set_xticks(range(len(names)), names)
    axes.grid(False, axis="x")


def save(figure, path):
    """Writes the figure; the same bytes for the same data."""
    figure.savefig(path, metadata={"CreationDate": None, "Creator": None, "Producer": None})
    plt.close(figure)
