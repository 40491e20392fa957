# SPDX-License-Identifier: GPL-3.0-or-later
"""Bytes and seconds of the visibility of a large part on many ranks: closed formulas, and a simulation of the schedule.

Rank r of P computes the columns of the directions r, r + P, r + 2P, ... Rank 0 then receives the columns of rank 1, of
rank 2 and so on. It sends every rank a share of the facets, finds the nearest cells of its own share, receives those of
the others, fits the setups alone, and writes. paper/notes/visibility-scale.md derives the formulas.
"""
import random
from dataclasses import dataclass
from math import ceil, exp, log, sqrt


@dataclass(frozen=True)
class Rates:
    """Measured rates of one core, and assumed rates of the machine. Times in s, sizes in bytes."""

    pair_s: float  # for one facet and one direction, measured
    spread: float  # standard deviation of the time of a direction over its mean, measured
    read_s: float  # to read and prepare one facet of the part, on every rank, measured
    cones_s: float  # to find the different cones, for one facet and one direction, on rank 0, measured
    nearest_s: float  # to find the nearest cells, for one facet and the square of one direction, measured
    sort_s: float  # to sort cells by nearness, for the square of one direction, measured
    fit_s: float  # to fit setups to the nearest cells, for the square of one direction, measured
    facet_bytes: float  # of a facet while rays are cast, measured
    thread_bytes: float  # more for one facet on each thread, measured
    link_bytes_per_s: float  # into rank 0, assumed
    disk_bytes_per_s: float  # of rank 0, assumed
    message_bytes: float  # of the largest message, which rank 0 holds beside the map
    least_facets: int  # of a share of the search


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

    @property
    def row_bytes(self):
        """Of the nearest cells at all tool axes: bits in words of 64."""
        return 8 * ceil(self.directions / 64) * self.directions

    def searching(self, rates):
        """The number of ranks that search a share of the facets."""
        return max(1, min(self.ranks, self.facets // rates.least_facets))

    def share(self, rank):
        """The number of directions of a rank."""
        return len(range(rank, self.directions, self.ranks))


def part_bytes(task, rates):
    return task.facets * (rates.facet_bytes + task.threads * rates.thread_bytes)


def search_stages(task, rates):
    """Seconds of the stages of the search: what rank 0 does before, sending shares, what each rank does with its share,
    receiving its rows, and what rank 0 does at the end."""
    ranks, squares = task.searching(rates), task.directions**2 / task.threads
    sorting = rates.sort_s * squares
    return {
        "cones": rates.cones_s * task.facets * task.directions,
        "send": task.map_bytes / ranks / rates.link_bytes_per_s,  # to one rank
        "share": rates.nearest_s * task.facets / ranks * squares + sorting,
        "receive": task.row_bytes / rates.link_bytes_per_s,  # from one rank
        "fit": rates.fit_s * squares + (sorting if ranks > 1 else 0.0),
    }


def memory(task, rates):
    """Bytes of rank 0 and of another rank. Rank 0 holds the map three times while it finds the different cones."""
    rays = part_bytes(task, rates)
    searching = task.searching(rates)
    other = max(rays + task.map_bytes / task.ranks,
                task.map_bytes / searching + task.row_bytes if searching > 1 else 0.0)
    return rays + 3 * task.map_bytes + rates.message_bytes, other if task.ranks > 1 else 0.0


def formula(task, rates):
    """Bytes of a rank and seconds of each stage by the closed formulas."""
    gathered = task.map_bytes * (task.ranks - 1) / task.ranks
    rank_0, other = memory(task, rates)
    search, others = search_stages(task, rates), task.searching(rates) - 1
    return {
        "rank_0_gb": rank_0 / 1e9,
        "other_rank_gb": other / 1e9,
        "read_s": task.facets * rates.read_s,
        "rays_s": task.facets * task.directions * rates.pair_s / (task.ranks * task.threads),
        "gather_s": gathered / rates.link_bytes_per_s,
        "disk_s": task.map_bytes / rates.disk_bytes_per_s,
        "search_s": search["cones"] + others * (search["send"] + search["receive"]) + search["share"] + search["fit"],
        "fit_s": search["fit"],
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


def simulate_search(task, rates):
    """Seconds of the search: rank 0 sends all shares, works on its own, and receives in the order of ranks."""
    stages = search_stages(task, rates)
    now, ends = stages["cones"], []
    for _ in range(1, task.searching(rates)):
        now += stages["send"]
        ends.append(now + stages["share"])
    now += stages["share"]
    for end in ends:
        now = max(now, end) + stages["receive"]
    return now + stages["fit"]


def simulate(task, rates, seed=1):
    """Seconds of each stage by a simulation of the schedule. `gather_s` is the time after rank 0 has cast its rays."""
    times = direction_times(task, rates, seed)
    read = task.facets * rates.read_s
    ends = [read + rank_end(times[rank::task.ranks], task.threads) for rank in range(task.ranks)]
    now = ends[0]
    for rank in range(1, task.ranks):
        now = max(now, ends[rank]) + task.column_bytes * task.share(rank) / rates.link_bytes_per_s
    return {"rays_s": ends[0] - read, "slowest_rays_s": max(ends) - read, "gather_s": now - ends[0],
            "until_map_s": now, "search_s": simulate_search(task, rates)}


def limit(task, rates, memory_gb, with_search=True):
    """What limits first: the memory of rank 0, or the longest stage."""
    found = formula(task, rates)
    if found["rank_0_gb"] > memory_gb:
        return "memory of rank 0"
    stages = {"rays_s": "rays", "gather_s": "network", "disk_s": "disk", "read_s": "reading"}
    if with_search:
        stages["search_s"] = "search"
    return stages[max(stages, key=found.__getitem__)]


HEADER = ["row", "facets", "directions", "ranks", "map_gb", "rank_0_gb", "other_rank_gb", "read_s", "rays_s",
          "simulated_slowest_rays_s", "gather_s", "until_map_s", "simulated_until_map_s", "disk_s", "search_s",
          "simulated_search_s", "fit_s", "limit", "limit_of_the_map"]


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
                       simulated["until_map_s"], found["disk_s"], found["search_s"], simulated["search_s"],
                       found["fit_s"]]
            rows.append([f"{facets:.0e} x {directions:.0e}, {ranks} ranks".replace("e+0", "e"), facets, directions,
                         ranks, *(f"{n:.6g}" for n in numbers), limit(task, rates, parameters["rank_0_memory_gb"]),
                         limit(task, rates, float("inf"), with_search=False)])
    return HEADER, rows
