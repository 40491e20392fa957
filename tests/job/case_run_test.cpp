// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/case_run.h"

#include <csignal>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/job/child_process.h"
#include "some_program.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

namespace fs = std::filesystem;

// Cases whose program is a shell. Its last argument is --output=FOLDER.
class CaseRunTest : public testing::Test {
protected:
    CaseTask task(const std::string& script) const
    {
        return {.number = 3,
                .program = "/bin/sh",
                .arguments = {"-c", "out=${0#--output=}; mkdir $out; " + script},
                .folder = place.path() / "case",
                .kept_folder = place.path() / "cases/0000003"};
    }

    PrivateFolder place{testing::TempDir()};
};

TEST_F(CaseRunTest, ReadsItsColumnsFromTheSummaries)
{
    CaseTask reading = task(
        R"(mkdir $out/02-plan; echo '{"a": 0.10, "b": {"c": "x, y", "d": [1, 2.5]},
            "e": true, "f": null}' > $out/summary.json;
            echo '{"a": 7}' > $out/02-plan/summary.json)");
    for (const auto& keys : std::vector<std::vector<std::string>>{{"a"},
                                                                  {"b", "c"},
                                                                  {"b", "d", "1"},
                                                                  {"b", "d", "2"},
                                                                  {"b", "d"},
                                                                  {"e"},
                                                                  {"f"},
                                                                  {"a", "x"},
                                                                  {"g"}})
        reading.columns.push_back({"", "summary.json", keys});
    reading.columns.push_back({"", "02-plan/summary.json", {"a"}});
    reading.columns.push_back({"", "03-trim/summary.json", {"a"}});
    const CaseRow row = run_case(reading);
    EXPECT_THAT(row.columns,
                ElementsAre("0.1", "x, y", "2.5", "", "", "true", "", "", "", "7", ""));
    EXPECT_EQ(row.number, 3);
    EXPECT_EQ(row.exit_code, 0);
    EXPECT_EQ(row.message, "");
    EXPECT_FALSE(row.is_failed());
    EXPECT_GT(row.wall_s, 0);
}

TEST_F(CaseRunTest, TakesTheMessageOfAnErrorAsJson)
{
    const CaseRow row = run_case(task(
        R"(echo noise >&2; echo '{"error":{"code":"E","message":"too \"wide\"","exit":4}}' >&2;
           exit 4)"));
    EXPECT_EQ(row.exit_code, 4);
    EXPECT_EQ(row.message, "too \"wide\"");
    EXPECT_TRUE(row.is_failed());
    EXPECT_EQ(run_case(task("echo last >&2; exit 9")).message, "last");
    EXPECT_FALSE(run_case(task("exit 1")).is_failed());
}

TEST_F(CaseRunTest, ReportsACrash)
{
    const CaseRow row = run_case(task("echo broken >&2; kill -SEGV $$"));
    EXPECT_EQ(row.exit_code, 128 + SIGSEGV);
    EXPECT_EQ(row.message, "ended by signal 11: broken");
    EXPECT_THAT(run_case(task("kill -KILL $$")).message, HasSubstr("no memory"));
}

TEST_F(CaseRunTest, EndsAtTheLimitOfTime)
{
    CaseTask slow = task("sleep 60");
    slow.most_seconds = 0.1;
    const CaseRow row = run_case(slow);
    EXPECT_EQ(row.exit_code, 6);
    EXPECT_EQ(row.message, "ended after 0.1 s; expected less time (--limit-seconds)");
}

TEST_F(CaseRunTest, StopsTheSweepIfTheDiskIsFull)
{
    const auto ends_with = [&](const std::string& reason) {
        return error_of([&] {
            run_case(task("echo '{\"error\":{\"message\":\"cannot write x: " + reason +
                          "\"}}' >&2; exit 5"));
        });
    };
    EXPECT_EQ(ends_with("No space left on device"),
              "E_OUTPUT case 3: cannot write x: No space left on device");
    EXPECT_EQ(ends_with("File name too long"), "accepted");
}

TEST_F(CaseRunTest, KeepsTheFoldersThatItShould)
{
    const auto is_kept = [&](KeptCases kept, const std::string& script) {
        CaseTask keeping = task("echo x > $out/file; " + script);
        keeping.kept = kept;
        run_case(keeping);
        EXPECT_FALSE(fs::exists(keeping.folder));
        const bool found = fs::exists(keeping.kept_folder / "file") &&
                           fs::exists(keeping.kept_folder / "case.json");
        EXPECT_EQ(fs::exists(keeping.kept_folder), found);
        fs::remove_all(keeping.kept_folder);
        return found;
    };
    EXPECT_FALSE(is_kept(KeptCases::None, "exit 2"));
    EXPECT_FALSE(is_kept(KeptCases::Failed, "exit 1"));
    EXPECT_TRUE(is_kept(KeptCases::Failed, "exit 2"));
    EXPECT_TRUE(is_kept(KeptCases::All, "exit 0"));
}

TEST_F(CaseRunTest, ReplacesTheFolderOfARunThatWasKilled)
{
    CaseTask keeping = task("echo x > $out/file");
    keeping.kept = KeptCases::All;
    fs::create_directories(keeping.kept_folder / "old");
    run_case(keeping);
    EXPECT_FALSE(fs::exists(keeping.kept_folder / "old"));
    EXPECT_TRUE(fs::exists(keeping.kept_folder / "file"));
}

TEST(CaseTask, GoesThroughALine)
{
    const CaseTask sent{.number = 9'999'999,
                        .program = "/bin/endmill",
                        .arguments = {"plan", "--cutter=a\"b"},
                        .folder = "x/y",
                        .kept_folder = "x/z",
                        .kept = KeptCases::Failed,
                        .columns = {{"n", "f", {"a", "b"}}},
                        .most_seconds = 1.5};
    const CaseTask came = task_of_line(task_line(sent));
    EXPECT_EQ(task_line(came), task_line(sent));
    EXPECT_EQ(came.arguments, sent.arguments);
    EXPECT_EQ(came.kept, KeptCases::Failed);
    EXPECT_EQ(came.columns[0].keys, sent.columns[0].keys);
    EXPECT_EQ(came.most_seconds, 1.5);
    EXPECT_FALSE(came.most_gib);
}

TEST(CaseRow, GoesThroughALine)
{
    const CaseRow row{12, {"1", "", "a\"b"}, 139, "ended, \"so\"", 0.25};
    EXPECT_EQ(row_line(row).find('\n'), std::string::npos);
    EXPECT_EQ(row_of_line(row_line(row)), row);
    EXPECT_FALSE(row_of_line("{}"));
    EXPECT_FALSE(row_of_line("x"));
}

}  // namespace
}  // namespace endmill
