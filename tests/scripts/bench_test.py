# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs and compares benchmarks whose drivers are shell scripts."""
import csv
import unittest

from fake_tree import ROOT, FakeTree

from benchmarking.__main__ import UsageError, read
from benchmarking.history import draw, keep, series
from benchmarking.measure import COMPARE_HEAD, RUN_HEAD, compare, judged, measure, pairs_of, write_csv
from benchmarking.rows import Row, peer_ratio, sense, slowdown, spread_percent, verdict
from benchmarking.trees import Tree, checked_out
from reproduction.experiments import find_experiments
from reproduction.fault import Fault
from reproduction.tables import read_table

HEAD = "row,measured,unit\n"


def kept_row(revision, row, median, ratio=""):
    values = {"revision": revision, "benchmark": "b", "row": row, "unit": "ms", "runs": 3, "median": median,
              "spread_percent": 1, "ratio_to_peer": ratio}
    return [values.get(name, "m") for name in RUN_HEAD]


class History(FakeTree):
    def test_runs_are_kept_and_their_curves_share_the_axis_of_runs(self):
        path = self.root / "history.csv"
        keep(path, [kept_row("r1", "fast", 2), kept_row("r1", "slow", 9, 3)], "2030-01-01T00:00:00Z")
        keep(path, [kept_row("r2", "slow", 8, 2.5)], "2030-01-02T00:00:00Z")
        rows = keep(path, [kept_row("r3", "fast", 1), kept_row("r3", "slow", 7, 2)], "2030-01-03T00:00:00Z")
        runs, medians = series(rows, "median")
        self.assertEqual([revision for _, revision in runs], ["r1", "r2", "r3"])
        self.assertEqual(medians, {("b", "fast, ms"): [(0, 2.0), (2, 1.0)],
                                   ("b", "slow, ms"): [(0, 9.0), (1, 8.0), (2, 7.0)]})
        self.assertEqual(series(rows, "ratio_to_peer")[1], {("b", "slow, ms"): [(0, 3.0), (1, 2.5), (2, 2.0)]})

    def test_each_benchmark_with_two_runs_is_drawn(self):
        path = self.root / "history.csv"
        one = keep(path, [kept_row("r1", "fast", 2)], "2030-01-01T00:00:00Z")
        self.assertEqual(draw(self.root, one), [])
        two = keep(path, [kept_row("r2", "fast", 3)], "2030-01-02T00:00:00Z")
        self.assertEqual(draw(self.root, two), ["bench-b.svg"])
        self.assertIn("<svg", (self.root / "bench-b.svg").read_text(encoding="utf-8"))

    def test_a_history_with_another_head_is_begun_anew(self):
        path = self.root / "history.csv"
        path.write_text("other,head\n1,2\n", encoding="utf-8")
        self.assertEqual(len(keep(path, [kept_row("r1", "fast", 2)], "2030-01-01T00:00:00Z")), 1)


class Rows(unittest.TestCase):
    def test_more_time_or_memory_is_slower_and_more_speed_is_faster(self):
        for unit in ("s", "ms a segment", "ns/pair", "us a point", "bytes a cell", "GiB", "MB"):
            self.assertEqual(sense(unit), 1, unit)
        for unit in ("million/s", "million points/s", "times as fast"):
            self.assertEqual(sense(unit), -1, unit)
        for unit in ("times", "times ours", "of unturned", "1", "pairs"):
            self.assertEqual(sense(unit), 0, unit)

    def test_slowdown_exceeds_one_for_more_time_or_less_speed(self):
        self.assertEqual(slowdown(Row("a", "s", 2), Row("a", "s", 3)), 1.5)
        self.assertEqual(slowdown(Row("a", "million/s", 3), Row("a", "million/s", 2)), 1.5)

    def test_verdicts_begin_at_three_percent(self):
        self.assertEqual([verdict(r) for r in (1.031, 1.029, 1.0, 0.972, 0.969)],
                         ["slower", "same", "same", "same", "faster"])

    def test_spread_is_the_range_of_all_runs_over_their_median(self):
        self.assertAlmostEqual(spread_percent([9, 10, 12]), 30)

    def test_peer_is_compared_with_our_row_of_the_same_run(self):
        run = {"ours": Row("ours", "ms", 2), "theirs": Row("theirs", "ms", 9)}
        self.assertEqual(peer_ratio(run["theirs"], run, {"theirs": "ours"}), 4.5)
        self.assertIsNone(peer_ratio(run["ours"], run, {"theirs": "ours"}))
        self.assertEqual(peer_ratio(Row("x, CGAL", "times ours", 80), run, {}), 80)


class Peers(unittest.TestCase):
    def test_peers_of_params_are_rows_of_the_benchmark(self):
        for experiment in find_experiments(ROOT):
            peers = experiment.params().get("peers", {})
            if peers:
                rows = read_table(experiment.folder / "expected.csv", labelled=True).column("row")
                self.assertLessEqual({*peers, *peers.values()}, set(rows), experiment.name)


class CommandLine(unittest.TestCase):
    def test_defaults_are_all_benchmarks_three_runs_and_ten_pairs(self):
        found = read([], ["a", "b"])
        self.assertEqual((found.names, found.compare, found.runs, found.pairs), (["a", "b"], "", 3, 10))

    def test_names_may_carry_their_folder(self):
        self.assertEqual(read(["experiments/benchmarks/a/"], ["a", "b"]).names, ["a"])

    def test_errors_of_the_command_line_are_named(self):
        for words, said in ((["--pairs", "3"], "--compare"), (["--runs", "0"], "whole number"),
                            (["--compare"], "value"), (["c"], "there are: a, b"), (["--x"], "--x"),
                            (["--compare", "HEAD", "--runs", "2"], "--pairs")):
            with self.assertRaisesRegex(UsageError, said):
                read(words, ["a", "b"])


class Runs(FakeTree):
    def add(self, folder, name, result):
        """Adds a benchmark that writes `result`, in which $N is the number of the run."""
        root = self.root / folder
        self.write(f"{folder}/experiments/benchmarks/{name}/main.cpp")
        program = self.write(
            f"{folder}/build/release/experiments/benchmarks-{name}",
            f'#!/bin/sh\necho run >> "{root}/runs"\nN=$(wc -l < "{root}/runs")\n'
            f'cat > "$1/result.csv" <<TEXT\n{HEAD}{result}TEXT\n')
        program.chmod(0o755)
        return Tree(root, folder)

    def quiet(self, _text):
        """Collects the output."""

    def test_several_runs_give_medians_spreads_and_ratios_to_peers(self):
        tree = self.add("new", "slicing", "ours,$N,ms\ntheirs,$((4 * $N)),ms\nerror,0,pairs\n")
        self.write("new/experiments/benchmarks/slicing/params.json", '{"peers": {"theirs": "ours"}}')
        rows = [dict(zip(RUN_HEAD, row)) for row in measure(tree, ["slicing"], 3, self.quiet)]
        self.assertEqual([(r["row"], r["runs"], r["median"], r["spread_percent"], r["ratio_to_peer"])
                          for r in rows],
                         [("ours", 3, 2, 100, ""), ("theirs", 3, 8, 100, 4), ("error", 3, 0, 0, "")])
        self.assertEqual(rows[0]["revision"], "new")
        write_csv(self.root / "results/bench.csv", RUN_HEAD, [list(rows[0].values())])
        with open(self.root / "results/bench.csv", encoding="utf-8", newline="") as file:
            self.assertEqual([row["median"] for row in csv.DictReader(file)], ["2.0"])

    def test_pairs_alternate_and_give_the_median_ratio_with_a_verdict(self):
        old = self.add("old", "post", "write,10,ms\nspeed,10,million/s\ngone,1,s\nratio,2,times\n")
        new = self.add("new", "post", "write,11,ms\nspeed,12,million/s\nadded,1,s\nratio,3,times\n")
        rows = [dict(zip(COMPARE_HEAD, row)) for row in compare(old, new, ["post"], 4, self.quiet)]
        self.assertEqual({r["row"]: r["verdict"] for r in rows},
                         {"write": "slower", "speed": "faster", "added": "only new",
                          "gone": "only old", "ratio": "not judged"})
        self.assertEqual((rows[0]["ratio"], rows[0]["pairs"]), (1.1, 4))
        self.assertEqual(len((self.root / "old/runs").read_text().splitlines()), 4)

    def test_peer_gets_no_verdict(self):
        run = {"theirs": Row("theirs", "ms", 9)}
        slow = {"theirs": Row("theirs", "ms", 20)}
        self.assertEqual(judged("x", [(run, slow)], {"theirs": "ours"})[0][-1], "not judged")

    def test_crash_is_named(self):
        tree = self.add("new", "post", "")
        self.write("new/build/release/experiments/benchmarks-post", "#!/bin/sh\nexit 3\n")
        with self.assertRaisesRegex(Fault, "post of new ended with exit code 3"):
            pairs_of(tree, tree, "post", 1, self.quiet)

    def test_other_revision_is_checked_out_once(self):
        self.git("init", "--initial-branch=main")
        self.write("a.txt", "old")
        self.git("add", ".")
        self.git("commit", "-m", "one")
        self.write("a.txt", "new")
        self.git("commit", "-am", "two")
        tree = checked_out(self.root, "HEAD~1")
        self.assertEqual((tree.root / "a.txt").read_text(), "old")
        self.assertEqual(checked_out(self.root, "HEAD~1"), tree)
        with self.assertRaisesRegex(Fault, "no-such-revision"):
            checked_out(self.root, "no-such-revision")


if __name__ == "__main__":
    unittest.main()
