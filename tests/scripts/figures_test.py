# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures are drawn from CSV files, with the same bytes in every run."""
import re
import unittest
import xml.etree.ElementTree as xml

from fake_tree import FakeTree
from reproduction.fault import Fault
from reproduction.figures import curves_of, draw_all, filtered, grid_of
from reproduction.tables import read_table

RESULT = "row,radius_mm,k,interval_mm\na,5,0,2\nb,5,0.1,1.5\nc,10,0,2.8\nd,10,0.1,\n"


def params(**plot):
    described = {"csv": "result.csv", "x": "k", "y": ["interval_mm"]} | plot
    return {"figures": [{"file": "x.svg", "caption": "A figure.", "plot": described}]}


class Figures(FakeTree):
    def setUp(self):
        super().setUp()
        self.write("result.csv", RESULT)

    def drawn(self, **plot):
        draw_all(params(**plot), self.root)
        return (self.root / "x.svg").read_bytes()

    def test_two_runs_write_the_same_bytes(self):
        self.assertEqual(self.drawn(group_by="radius_mm"), self.drawn(group_by="radius_mm"))

    def test_every_kind_is_an_svg(self):
        for kind in ("line", "points", "bar"):
            for x in ("k", "row"):
                root = xml.fromstring(self.drawn(kind=kind, x=x, y_scale="log"))
                self.assertTrue(root.tag.endswith("svg"))

    def test_surface_is_a_net_over_two_columns(self):
        self.write("result.csv", "row,u,v,z\na,1,0,3\nb,0,0,1\nc,0,5,2\nd,1,5,4\ne,2,0,0\nf,2,5,-1\n")
        surface = {"kind": "surface", "x": "u", "group_by": "v", "y": ["z"]}
        self.assertEqual(grid_of(read_table(self.root / "result.csv"), surface),
                         ([0, 1, 2], [0, 5], [[1, 3, 0], [2, 4, -1]]))
        drawn = self.drawn(**surface)
        self.assertEqual(drawn, self.drawn(**surface))
        net = [e for e in xml.fromstring(drawn).iter() if e.get("id", "").startswith("Poly3DCollection")]
        self.assertEqual(len(net), 1)
        self.assertEqual(len([e for e in net[0].iter() if e.tag.endswith("path")]), 2)

    def test_surface_with_a_hole_is_refused(self):
        for csv in ("u,v,z\n0,0,1\n1,0,1\n0,1,1\n", "u,v,z\n0,0,1\n0,1,1\n"):
            self.write("result.csv", csv)
            with self.assertRaises(Fault):
                self.drawn(kind="surface", x="u", group_by="v", y=["z"])
        self.write("result.csv", "u,v,z\n0,0,1\n1,0,1\n0,1,1\n1,1,2\n")
        for plot in ({}, {"group_by": "v", "y": ["z", "u"]}):
            with self.assertRaises(Fault):
                self.drawn(kind="surface", x="u", **({"y": ["z"]} | plot))

    def test_short_logarithmic_scale_has_plain_numbers(self):
        self.write("result.csv", "u,z\n0.1,20\n1,70\n")
        texts = re.findall("<!-- (.*?) -->", self.drawn(x="u", y=["z"], x_scale="log", y_scale="log").decode())
        for number in ("0.1", "0.2", "1", "30"):
            self.assertIn(number, texts)
        self.assertFalse([text for text in texts if "e-" in text or "times" in text], texts)

    def test_group_of_points_is_not_joined(self):
        curve = {"group_by": "radius_mm", "labels": {"5": "printed"}}
        joined, apart = (self.drawn(**curve, **more).decode() for more in ({}, {"points": ["5"]}))
        lines = [text.count("stroke-width: 1.6") for text in (joined, apart)]
        self.assertEqual(lines[0] - lines[1], 2)  # the curve and its sample in the legend

    def test_each_group_is_a_curve_with_gaps_at_empty_cells(self):
        plot = params(group_by="radius_mm")["figures"][0]["plot"]
        curves = list(curves_of(read_table(self.root / "result.csv"), plot))
        self.assertEqual([label for label, _, _ in curves], ["radius_mm 5", "radius_mm 10"])
        self.assertEqual(curves[0][2], [2, 1.5])
        self.assertNotEqual(curves[1][2][1], curves[1][2][1])  # only NaN differs from itself

    def test_filter_compares_numbers_by_value(self):
        plot = params(filter={"radius_mm": 5.0})["figures"][0]["plot"]
        kept = filtered(read_table(self.root / "result.csv"), plot)
        self.assertEqual(kept.column("row"), ["a", "b"])

    def test_plot_of_missing_data_is_refused(self):
        for plot in ({"x": "u"}, {"y": ["z"]}, {"y": "k"}, {"kind": "pie"}, {"colour": "red"},
                     {"csv": "../result.csv"}, {"csv": "none.csv"}, {"filter": {"k": 7}}):
            with self.assertRaises(Fault, msg=plot):
                self.drawn(**plot)

    def test_figure_has_a_plain_name_and_a_caption(self):
        for figure in ({"file": "../x.svg", "caption": "A."}, {"file": "x.html", "caption": "A."},
                       {"file": "x.svg"}, {"caption": "A."}):
            with self.assertRaises(Fault, msg=figure):
                draw_all({"figures": [figure]}, self.root)

    def test_figure_of_the_driver_must_exist(self):
        figures = {"figures": [{"file": "path.svg", "caption": "A path."}]}
        with self.assertRaisesRegex(Fault, "path.svg"):
            draw_all(figures, self.root)
        self.write("path.svg", "<svg/>")
        draw_all(figures, self.root)


if __name__ == "__main__":
    unittest.main()
