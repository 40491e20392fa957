// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/case_workers.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/job/child_process.h"
#include "fake_ranks.h"
#include "some_program.h"

namespace endmill {
namespace {

// Runs `count` cases of a shell script on some ranks. \return the numbers of the rows.
std::vector<std::uint64_t> numbers_of_rows(int ranks, int jobs, std::uint64_t count,
                                           const std::string& script,
                                           std::uint64_t record_fails_at = ~0ULL)
{
    const PrivateFolder place{testing::TempDir()};
    const auto all = FakeRanks::make(ranks);
    std::vector<std::jthread> others;
    for (int rank = 1; rank < ranks; ++rank)
        others.emplace_back([&all, rank] { serve_cases(*all[rank]); });
    std::uint64_t next = 0;
    std::vector<std::uint64_t> rows;
    SweepWorkers workers{*all[0]};
    const CaseTraffic traffic{[&]() -> std::optional<CaseTask> {
                                  if (next == count)
                                      return std::nullopt;
                                  return CaseTask{
                                      .number = next++,
                                      .program = "/bin/sh",
                                      .arguments = {"-c", script},
                                      .folder = place.path() / std::to_string(next)};
                              },
                              [&](const CaseRow& row) {
                                  if (row.number == record_fails_at)
                                      throw OutputError{"cannot record"};
                                  rows.push_back(row.number);
                              }};
    run_cases(traffic, jobs, workers);
    std::ranges::sort(rows);
    return rows;
}

std::vector<std::uint64_t> first_numbers(std::uint64_t count)
{
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t i = 0; i < count; ++i)
        numbers.push_back(i);
    return numbers;
}

TEST(RunCases, RunsEachCaseOnceOnAnyJobsAndRanks)
{
    for (const int ranks : {1, 2, 5})
        for (const int jobs : {1, 3})
            for (const std::uint64_t count : {0, 1, 20})
                EXPECT_EQ(numbers_of_rows(ranks, jobs, count, "exit 0"),
                          first_numbers(count))
                    << ranks << " ranks, " << jobs << " jobs, " << count << " cases";
}

TEST(RunCases, EndsWithTheErrorOfAnyRankAndEndsTheOthers)
{
    const std::string full_disk =
        "echo '{\"error\":{\"message\":\"No space left on device\"}}' >&2; exit 5";
    for (const int ranks : {1, 3})
        EXPECT_THAT(error_of([&] { numbers_of_rows(ranks, 1, 20, full_disk); }),
                    testing::HasSubstr("No space left on device"));
    for (const int ranks : {1, 3})
        EXPECT_EQ(error_of([&] { numbers_of_rows(ranks, 2, 20, "exit 0", 4); }),
                  "E_OUTPUT cannot record");
}

// Five cases of 0.4 s on five ranks.
TEST(RunCases, RunAtTheSameTime)
{
    const auto start = std::chrono::steady_clock::now();
    numbers_of_rows(5, 1, 5, "sleep 0.4");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds{1600});
}

}  // namespace
}  // namespace endmill
