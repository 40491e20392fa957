// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/case_results.h"

#include <map>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> files{"a.csv", "b.csv", "c.csv", "d.csv", "e.csv"};

std::string text_of(std::size_t i)
{
    return "case " + std::to_string(i * i) + "\n";
}

class CaseResults : public testing::Test {
protected:
    CaseResults()
        : folder_{fs::path{testing::TempDir()} /
                  ("case_results_" +
                   std::string{
                       testing::UnitTest::GetInstance()->current_test_info()->name()})}
    {
        fs::remove_all(folder_);
    }
    ~CaseResults() override { fs::remove_all(folder_); }

    // What every complete run leaves.
    void expect_all_results() const
    {
        std::size_t found = 0;
        for (const auto& entry : fs::directory_iterator{folder_})
            found += entry.is_regular_file() ? 1 : 0;
        EXPECT_EQ(found, files.size());
        for (std::size_t i = 0; i < files.size(); ++i)
            EXPECT_EQ(read_file(folder_ / files[i]), text_of(i));
    }

    fs::path folder_;
};

TEST_F(CaseResults, GoOnAfterAnInterruptionWithTheSameBytes)
{
    const auto interrupted = [](std::size_t i) {
        if (i == 3)
            throw std::runtime_error{"stopped"};
        return text_of(i);
    };
    EXPECT_THROW(write_missing_results(files, {}, folder_, interrupted),
                 std::runtime_error);
    EXPECT_FALSE(fs::exists(folder_ / files[3]));
    std::map<std::size_t, int> calls;
    const auto counted = [&](std::size_t i) {
        ++calls[i];
        return text_of(i);
    };
    EXPECT_EQ(write_missing_results(files, {}, folder_, counted), 2);
    EXPECT_EQ(calls, (std::map<std::size_t, int>{{3, 1}, {4, 1}}));
    expect_all_results();
    EXPECT_EQ(write_missing_results(files, {}, folder_, counted), 0);
}

TEST_F(CaseResults, OfShardsAreThoseOfOneRun)
{
    EXPECT_EQ(write_missing_results(files, {2, 3}, folder_, text_of), 2);
    EXPECT_EQ(write_missing_results(files, {3, 3}, folder_, text_of), 1);
    EXPECT_EQ(write_missing_results(files, {1, 3}, folder_, text_of), 2);
    expect_all_results();
}

TEST_F(CaseResults, RefuseAShardThatDoesNotExist)
{
    EXPECT_THROW(write_missing_results(files, {0, 2}, folder_, text_of), DomainError);
    EXPECT_THROW(write_missing_results(files, {3, 2}, folder_, text_of), DomainError);
}

}  // namespace
}  // namespace endmill
