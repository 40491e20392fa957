# SPDX-License-Identifier: GPL-3.0-or-later
"""Bytes and seconds of the visibility of a large part on many ranks: closed formulas, and a simulation of the schedule.

Rank r of P computes the columns of the directions r, r + P, r + 2P, ... Rank 0 then receives the columns of rank 1, of
rank 2 and so on, writes the map, and searches the setup alone. paper/notes/visibility-scale.md derives the formulas.
"""
import random
from dataclasses import dataclass, replace
from math import ceil, exp, log, sqrt


@dataclass(frozen=True)
class Rates:
    """Measured rates of one core, and assumed rates of the machine. Times in s, sizes in bytes."""

    pair_s: float  # for one facet and one direction, measured
    spread: float  # standard deviation of the time of a direction over its mean, measured
    read_s: float  # to read and prepare one facet of the part, on every rank, measured
    search_s: float  # of the search, for one facet and the square of one direction, measured
    facet_bytes: float  # of a facet while rays are cast, measured
    thread_bytes: float  # more for one facet on each thread, measured
    link_bytes_per_s: float  # into rank 0, assumed
    disk_bytes_per_s: float  # of rank 0, assumed
    message_bytes: float  # of the largest message, which rank 0 holds beside the map


@dataclass(frozen=True)
class Task:
    """A part and a grid of directions, on ranks with some threads each."""

    facets: int
    directions: int
    ranks: int
    threads: int = 1

    @property
    def column_bytes(self):
        """Of one direction: bits in words of 64."""
        return 8 * ceil(self.facets / 64)

    @property
    def map_bytes(self):
        return self.column_bytes * self.directions

    def share(self, rank):
        """The number of directions of a rank."""
        return len(range(rank, self.directions, self.ranks))


def part_bytes(task, rates):
    return task.facets * (rates.facet_bytes + task.threads * rates.thread_bytes)


def formula(task, rates):
    """Bytes of a rank and seconds of each stage by the closed formulas."""
    gathered = task.map_bytes * (task.ranks - 1) / task.ranks
    return {
        "rank_0_gb": (part_bytes(task, rates) + task.map_bytes + rates.message_bytes) / 1e9,
        "other_rank_gb": (part_bytes(task, rates) + task.map_bytes / task.ranks) / 1e9 if task.ranks > 1 else 0.0,
        "read_s": task.facets * rates.read_s,
        "rays_s": task.facets * task.directions * rates.pair_s / (task.ranks * task.threads),
        "gather_s": gathered / rates.link_bytes_per_s,
        "disk_s": task.map_bytes / rates.disk_bytes_per_s,
        "search_s": rates.search_s * task.facets * task.directions**2 / task.threads,
    }


def direction_times(task, rates, seed):
    """The time of every direction: log-normal, with the mean and the spread of the rates."""
    variance = log(1 + rates.spread**2)
    middle = log(task.facets * rates.pair_s) - variance / 2
    draw = random.Random(seed).gauss
    return [exp(middle + sqrt(variance) * draw(0, 1)) for _ in range(task.directions)]


def rank_end(times, threads):
    """When the last thread of a rank ends: each takes the next direction as soon as it is free."""
    free = [0.0] * threads
    for time in times:
        first = min(range(threads), key=free.__getitem__)
        free[first] += time
    return max(free)


def simulate(task, rates, seed=1):
    """Seconds of each stage by a simulation of the schedule. `gather_s` is the time after rank 0 has cast its rays."""
    times = direction_times(task, rates, seed)
    read = task.facets * rates.read_s
    ends = [read + rank_end(times[rank::task.ranks], task.threads) for rank in range(task.ranks)]
    now = ends[0]
    for rank in range(1, task.ranks):
        now = max(now, ends[rank]) + task.column_bytes * task.share(rank) / rates.link_bytes_per_s
    return {"rays_s": ends[0] - read, "slowest_rays_s": max(ends) - read, "gather_s": now - ends[0],
            "until_map_s": now}


def limit(task, rates, memory_gb):
    """What limits first: the memory of rank 0, or the longest stage."""
    found = formula(task, rates)
    if found["rank_0_gb"] > memory_gb:
        return "memory of rank 0"
    stages = {"rays_s": "rays", "gather_s": "network", "disk_s": "disk", "search_s": "search", "read_s": "reading"}
    return stages[max(stages, key=found.__getitem__)]


HEADER = ["row", "facets", "directions", "ranks", "map_gb", "rank_0_gb", "other_rank_gb", "read_s", "rays_s",
          "simulated_slowest_rays_s", "gather_s", "until_map_s", "simulated_until_map_s", "disk_s", "search_s",
          "limit", "limit_of_the_map"]


def table(parameters):
    """The rows of result.csv for the sizes and ranks of params.json."""
    rates = Rates(**parameters["rates"])
    rows = []
    for facets, directions in parameters["sizes"]:
        for ranks in parameters["ranks"]:
            task = Task(facets, directions, ranks, parameters["threads"])
            found, simulated = formula(task, rates), simulate(task, rates)
            until_map = found["read_s"] + found["rays_s"] + found["gather_s"]
            numbers = [task.map_bytes / 1e9, found["rank_0_gb"], found["other_rank_gb"], found["read_s"],
                       found["rays_s"], simulated["slowest_rays_s"], found["gather_s"], until_map,
                       simulated["until_map_s"], found["disk_s"], found["search_s"]]
            rows.append([f"{facets:.0e} x {directions:.0e}, {ranks} ranks".replace("e+0", "e"), facets, directions,
                         ranks, *(f"{n:.6g}" for n in numbers), limit(task, rates, parameters["rank_0_memory_gb"]),
                         limit(task, replace(rates, search_s=0.0), float("inf"))])
    return HEADER, rows
