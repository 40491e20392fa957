// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/parallel.h"

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

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

TEST(SetThreadCount, RefusesCountsOutsideItsRange)
{
    for (const int count : {0, -1, 1025})
        EXPECT_THROW(set_thread_count(count), DomainError) << count;
    EXPECT_NO_THROW(set_thread_count(1024));
    EXPECT_EQ(visits(100), std::vector<int>(100, 1));
}

}  // namespace
}  // namespace endmill
