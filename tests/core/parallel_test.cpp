// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

std::vector<int> visits(std::size_t count)
{
    std::vector<int> visits(count, 0);
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            ++visits[k];
    });
    return visits;
}

TEST(ParallelFor, VisitsEveryIndexOnce)
{
    for (const std::size_t count : {1, 2, 7, 1000, 100000})
        EXPECT_EQ(visits(count), std::vector<int>(count, 1));
}

TEST(ParallelFor, OverAnEmptyRangeCallsNothing)
{
    parallel_for(0, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(ParallelFor, SumsToTheFormulaOfGauss)
{
    std::atomic<std::size_t> sum = 0;
    parallel_for(10000, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            sum += k;
    });
    EXPECT_EQ(sum, 10000U * 9999 / 2);
}

TEST(ParallelFor, ThrowsForTheLowestIndexAtFault)
{
    for (const int threads : {1, 2, 8})
        for (int trial = 0; trial < 50; ++trial) {
            set_thread_count(threads);
            try {
                parallel_for(10000, [](std::size_t begin, std::size_t end) {
                    for (std::size_t k = begin; k < end; ++k)
                        if (k % 1000 == 137)
                            throw std::runtime_error{std::to_string(k)};
                });
                FAIL() << "nothing thrown";
            } catch (const std::runtime_error& error) {
                EXPECT_STREQ(error.what(), "137");
            }
        }
}

TEST(ParallelFor, GivesTheSameResultsByIndexOnAnyNumberOfThreads)
{
    const auto results = [] {
        std::vector<double> values(5000);
        parallel_for(values.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                values[k] = std::sin(0.1 * double(k)) / (1 + double(k));
        });
        return values;
    };
    set_thread_count(1);
    const std::vector<double> expected = results();
    for (const int threads : {2, 3, 16, 1}) {
        set_thread_count(threads);
        EXPECT_EQ(results(), expected) << threads;
    }
}

TEST(ParallelFor, RethrowsTheExceptionOfABody)
{
    const auto throw_at = [](std::size_t bad) {
        parallel_for(1000, [&](std::size_t begin, std::size_t end) {
            if (begin <= bad && bad < end)
                throw GeometryError{"at 500"};
        });
    };
    for (const int threads : {1, 4}) {
        set_thread_count(threads);
        EXPECT_THROW(throw_at(500), GeometryError);
        EXPECT_NO_THROW(throw_at(1000));
    }
}

TEST(ParallelFor, MayBeNested)
{
    std::vector<int> counts(50, 0);
    parallel_for(counts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            for (const int visit : visits(20))
                counts[k] += visit;
    });
    EXPECT_EQ(counts, std::vector<int>(50, 20));
}

TEST(ParallelInOrder, FinishesEveryNumberInOrderAfterItsWork)
{
    for (const int threads : {1, 2, 8})
        for (const std::size_t count : {0, 1, 2, 7, 1000}) {
            set_thread_count(threads);
            std::vector<int> works(count, 0);
            std::vector<std::size_t> finished;
            parallel_in_order(
                count, [&](std::size_t i) { ++works[i]; },
                [&](std::size_t i) {
                    EXPECT_EQ(works[i], 1);
                    finished.push_back(i);
                });
            std::vector<std::size_t> expected(count);
            std::iota(expected.begin(), expected.end(), std::size_t{0});
            EXPECT_EQ(finished, expected);
            EXPECT_EQ(works, std::vector<int>(count, 1));
        }
}

// What is thrown by the calls one after the other, and what they finish.
struct Fault {
    std::string thrown;
    std::size_t finished = 0;
};

Fault fault_of(std::size_t bad_work, std::size_t bad_finish)
{
    Fault fault;
    try {
        parallel_in_order(
            500,
            [&](std::size_t i) {
                if (i >= bad_work)
                    throw std::runtime_error{"work " + std::to_string(i)};
            },
            [&](std::size_t i) {
                if (i >= bad_finish)
                    throw std::runtime_error{"finish " + std::to_string(i)};
                ++fault.finished;
            });
    } catch (const std::runtime_error& error) {
        fault.thrown = error.what();
    }
    return fault;
}

TEST(ParallelInOrder, ThrowsAsTheCallsOneAfterTheOther)
{
    for (const int threads : {1, 2, 8})
        for (int trial = 0; trial < 20; ++trial) {
            set_thread_count(threads);
            for (const auto& [work, finish, thrown] :
                 {std::tuple{137, 900, "work 137"}, std::tuple{900, 137, "finish 137"},
                  std::tuple{137, 136, "finish 136"}, std::tuple{137, 137, "work 137"},
                  std::tuple{0, 0, "work 0"}, std::tuple{900, 900, ""}}) {
                const Fault fault = fault_of(work, finish);
                EXPECT_EQ(fault.thrown, thrown);
                EXPECT_EQ(fault.finished, std::min({work, finish, 500}));
            }
        }
}

// Whether a forked process ends with the exit code 0 within ten seconds.
bool ends_well(pid_t child)
{
    int status = 0;
    for (int tenths = 0; tenths < 100; ++tenths) {
        if (waitpid(child, &status, WNOHANG) == child)
            return WIFEXITED(status) && WEXITSTATUS(status) == 0;
        std::this_thread::sleep_for(std::chrono::milliseconds{100});
    }
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return false;
}

TEST(ParallelFor, WorksInAForkedProcess)
{
    set_thread_count(4);
    EXPECT_EQ(visits(1000), std::vector<int>(1000, 1));  // the helpers exist
    for (int trial = 0; trial < 10; ++trial) {
        const pid_t child = fork();
        if (child == 0)
            _exit(visits(1000) == std::vector<int>(1000, 1) ? 0 : 1);
        EXPECT_TRUE(ends_well(child));
    }
}

TEST(SetThreadCount, RefusesCountsOutsideItsRange)
{
    for (const int count : {0, -1, 1025})
        EXPECT_THROW(set_thread_count(count), DomainError) << count;
    EXPECT_NO_THROW(set_thread_count(1024));
    EXPECT_EQ(visits(100), std::vector<int>(100, 1));
}

}  // namespace
}  // namespace endmill
