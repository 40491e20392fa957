# SPDX-License-Identifier: GPL-3.0-or-later
"""The formulas for the visibility of large parts, against the simulated schedule and closed forms."""
import dataclasses
import json
import unittest

from fake_tree import ROOT
from studies.scale import Rates, Task, direction_times, formula, limit, part_bytes, rank_end, simulate, table

PARAMS = json.loads((ROOT / "experiments/sweeps/scale/params.json").read_text(encoding="utf-8"))["parameters"]
RATES = Rates(**PARAMS["rates"])
EVEN = dataclasses.replace(RATES, spread=0.0)


class Scale(unittest.TestCase):
    def test_a_map_has_a_bit_for_each_pair_in_words(self):
        self.assertEqual(Task(640, 10, 1).map_bytes, 640 * 10 / 8)
        self.assertEqual(Task(641, 10, 1).map_bytes, 704 * 10 / 8)

    def test_every_direction_has_one_rank(self):
        for directions, ranks in ((10, 1), (10, 3), (10_000, 64), (5, 8)):
            task = Task(64, directions, ranks)
            self.assertEqual(sum(map(task.share, range(ranks))), directions)

    def test_directions_have_the_mean_and_the_spread_of_the_rates(self):
        times = direction_times(Task(1000, 100_000, 1), RATES, seed=5)
        mean = sum(times) / len(times)
        spread = (sum((t - mean)**2 for t in times) / len(times))**0.5 / mean
        self.assertAlmostEqual(mean, 1000 * RATES.pair_s, delta=0.01 * mean)
        self.assertAlmostEqual(spread, RATES.spread, delta=0.03)

    def test_without_spread_the_simulation_is_the_formula(self):
        for task in (Task(64_000, 1024, 64), Task(64_000, 1024, 1), Task(64_000, 1024, 4, threads=4)):
            found, simulated = formula(task, EVEN), simulate(task, EVEN)
            self.assertAlmostEqual(simulated["rays_s"], found["rays_s"], delta=1e-9)
            self.assertAlmostEqual(simulated["until_map_s"], found["read_s"] + found["rays_s"] + found["gather_s"],
                                   delta=1e-9)

    def test_with_spread_the_simulation_stays_near_the_formula_while_shares_are_long(self):
        task = Task(1_000_000, 10_000, 64)
        found, simulated = formula(task, RATES), simulate(task, RATES)
        expected = found["read_s"] + found["rays_s"] + found["gather_s"]
        # A share is the sum of 156 times: its relative deviation is the spread / sqrt(156), and the largest of
        # 64 is about 2.4 of them above the mean.
        self.assertLess(simulated["slowest_rays_s"], found["rays_s"] * (1 + 4 * RATES.spread / 156**0.5))
        self.assertGreater(simulated["until_map_s"], 0.9 * expected)
        self.assertLess(simulated["until_map_s"], 1.25 * expected)

    def test_threads_take_the_next_direction_when_they_are_free(self):
        self.assertEqual(rank_end([3, 1, 1, 1], 2), 3)
        self.assertEqual(rank_end([1, 1, 1, 3], 2), 4)
        self.assertEqual(rank_end([1, 2, 3], 1), 6)

    def test_limits(self):
        small, large = Task(1_000_000, 10_000, 64), Task(10_000_000, 100_000, 64)
        self.assertEqual(limit(large, RATES, 64), "memory of rank 0")
        self.assertEqual(limit(small, RATES, 64), "search")
        no_search = dataclasses.replace(RATES, search_s=0.0)
        self.assertEqual(limit(Task(1_000_000, 10_000, 1), no_search, 64), "rays")
        self.assertEqual(limit(dataclasses.replace(large, ranks=1024), no_search, 1000), "disk")
        self.assertAlmostEqual(part_bytes(small, RATES), 1_000_000 * (RATES.facet_bytes + RATES.thread_bytes))

    def test_table_is_the_expected_one(self):
        _, rows = table(PARAMS)
        self.assertEqual(len(rows), len(PARAMS["sizes"]) * len(PARAMS["ranks"]))
        self.assertEqual(rows, table(PARAMS)[1])


if __name__ == "__main__":
    unittest.main()
