# SPDX-License-Identifier: GPL-3.0-or-later
"""The formulas for the visibility of large parts, against the simulated schedule and closed forms."""
import dataclasses
import json
import unittest

from fake_tree import ROOT
from studies.scale import (Rates, Task, direction_times, formula, limit, part_bytes, rank_end, search_stages, simulate,
                           table)

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

    def test_the_search_of_the_simulation_is_the_formula(self):
        for task in (Task(10_000, 1200, 4), Task(1_000_000, 10_000, 1), Task(1_000_000, 10_000, 2),
                     Task(10_000_000, 1000, 1024, threads=8)):
            found, simulated = formula(task, RATES), simulate(task, RATES)
            self.assertAlmostEqual(simulated["search_s"], found["search_s"], delta=1e-9 * found["search_s"])

    def test_the_search_is_divided_among_ranks_with_enough_facets(self):
        self.assertEqual(Task(2 * RATES.least_facets - 1, 100, 8).searching(RATES), 1)
        self.assertEqual(Task(3 * RATES.least_facets, 100, 8).searching(RATES), 3)
        self.assertEqual(Task(1_000_000, 100, 8).searching(RATES), 8)
        source = (ROOT / "src/cli/setup_nearest_cells.cpp").read_text(encoding="utf-8").replace("'", "")
        self.assertIn(f"least_facets_of_a_rank = {RATES.least_facets};", source)

    def test_of_the_search_only_the_nearest_cells_are_divided(self):
        one, four = (search_stages(Task(1_000_000, 10_000, ranks), RATES) for ranks in (1, 4))
        sorting = RATES.sort_s * 10_000**2
        self.assertAlmostEqual(four["share"] - sorting, (one["share"] - sorting) / 4)
        self.assertEqual(four["cones"], one["cones"])
        self.assertAlmostEqual(four["fit"], one["fit"] + sorting)

    def test_threads_take_the_next_direction_when_they_are_free(self):
        self.assertEqual(rank_end([3, 1, 1, 1], 2), 3)
        self.assertEqual(rank_end([1, 1, 1, 3], 2), 4)
        self.assertEqual(rank_end([1, 2, 3], 1), 6)

    def test_limits(self):
        small, large = Task(1_000_000, 10_000, 64), Task(10_000_000, 100_000, 64)
        self.assertEqual(limit(large, RATES, 64), "memory of rank 0")
        self.assertEqual(limit(small, RATES, 64), "search")
        self.assertEqual(limit(Task(1_000_000, 10_000, 1), RATES, 64, with_search=False), "rays")
        self.assertEqual(limit(dataclasses.replace(large, ranks=1024), RATES, 1000, with_search=False), "disk")
        self.assertAlmostEqual(part_bytes(small, RATES), 1_000_000 * (RATES.facet_bytes + RATES.thread_bytes))

    def test_table_is_the_expected_one(self):
        _, rows = table(PARAMS)
        self.assertEqual(len(rows), len(PARAMS["sizes"]) * len(PARAMS["ranks"]))
        self.assertEqual(rows, table(PARAMS)[1])


if __name__ == "__main__":
    unittest.main()
