// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/sweep.h"

#include <fstream>
#include <iterator>
#include <regex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/job/child_process.h"
#include "fake_ranks.h"
#include "some_program.h"

namespace endmill {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

// Sweeps over a shell script in place of the program: its summary has the number of planes.
// Cases with 13 planes fail, and cases wait while the file `wait` exists.
class SweepTest : public testing::Test {
protected:
    SweepTest()
    {
        const fs::path script = place.path() / "program.sh";
        std::ofstream{script}
            << "#!/bin/sh\n"
               "for word in \"$@\"; do case $word in\n"
               "--output=*) out=${word#--output=};;\n"
               "--planes=*) planes=${word#--planes=};; esac; done\n"
               "if [ $planes = 13 ]; then echo unlucky >&2; exit 4; fi\n"
               "mkdir $out\n"
               "echo \"{\\\"n\\\": $planes}\" > $out/summary.json\n";
        fs::permissions(script, fs::perms::owner_all);
        put("cases.csv", "planes\n11\n12\n13\n14\n15\n16\n17\n");
    }
    void put(const std::string& name, const std::string& content) const
    {
        std::ofstream{place.path() / name} << content;
    }
    SweepPlan plan(const std::string& name = "n") const
    {
        put("plan.json",
            R"({"format": "endmill-sweep/1", "command": "numbers", "name": ")" + name +
                R"(", "list": "cases.csv", "columns": ["n", "m"]})");
        return read_sweep_plan(place.path() / "plan.json",
                               some_program(place.path() / "program.sh"));
    }
    SweepOptions options(const std::string& folder) const
    {
        return {.program = place.path() / "program.sh", .folder = place.path() / folder};
    }
    SweepTotals run(const SweepOptions& how, int ranks = 1) const
    {
        const auto all = FakeRanks::make(ranks);
        std::vector<std::jthread> others;
        for (int rank = 1; rank < ranks; ++rank)
            others.emplace_back([&all, rank] { serve_sweep(*all[rank]); });
        SweepWorkers workers{*all[0]};
        return run_sweep(plan(), how, workers);
    }
    // results.csv without its times.
    std::string results(const std::string& folder) const
    {
        std::ifstream stream{place.path() / folder / "results.csv", std::ios::binary};
        const std::string text{std::istreambuf_iterator<char>{stream}, {}};
        return std::regex_replace(text, std::regex{",[0-9.e+-]+\n"}, ",T\n");
    }
    std::vector<std::string> files(const std::string& folder) const
    {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator{place.path() / folder})
            names.push_back(entry.path().filename());
        std::ranges::sort(names);
        return names;
    }

    PrivateFolder place{testing::TempDir()};
    const std::string expected =
        "case,planes,n,m,exit_code,message,wall_s\n0,11,11,,0,,T\n1,12,12,,0,,T\n"
        "2,13,,,4,unlucky,T\n3,14,14,,0,,T\n4,15,15,,0,,T\n5,16,16,,0,,T\n6,17,17,,0,,"
        "T\n";
};

TEST_F(SweepTest, HasARowForEachCaseInTheOrderOfThePlan)
{
    for (const int ranks : {1, 3})
        for (const int jobs : {1, 4}) {
            const std::string folder = std::to_string(ranks) + "-" + std::to_string(jobs);
            SweepOptions how = options(folder);
            how.jobs = jobs;
            const SweepTotals totals = run(how, ranks);
            EXPECT_EQ(results(folder), expected);
            EXPECT_THAT(files(folder), testing::ElementsAre("results.csv", "sweep.json"));
            EXPECT_EQ(totals.cases, 7);
            EXPECT_EQ(totals.failed, 1);
            EXPECT_EQ(totals.first_failure, "case 2: unlucky");
            EXPECT_THAT(totals.empty_columns, testing::ElementsAre("m"));
        }
}

// A sweep that is stopped after any case: here by an error of the caller.
TEST_F(SweepTest, GoesOnAfterAnyCase)
{
    for (std::uint64_t last = 1; last < 7; ++last) {
        const std::string folder = "after-" + std::to_string(last);
        SweepOptions how = options(folder);
        how.progress = [&](const SweepProgress& state) {
            if (state.done == last)
                throw OutputError{"stopped"};
        };
        EXPECT_EQ(error_of([&] { run(how); }), "E_OUTPUT stopped");
        EXPECT_THAT(error_of([&] { run(options(folder)); }),
                    HasSubstr("has the begun results of this plan; expected --resume"));
        SweepOptions resumed = options(folder);
        resumed.resume = true;
        EXPECT_EQ(run(resumed).before, last);
        EXPECT_EQ(results(folder), expected);
        EXPECT_EQ(run(resumed).before, 7);
    }
}

TEST_F(SweepTest, RefusesFoldersOfOthers)
{
    run(options("mine"));
    EXPECT_THAT(error_of([&] { run(options("mine")); }),
                HasSubstr("has the results of this plan; expected --resume"));
    SweepOptions how = options("mine");
    how.resume = true;
    how.shard = {1, 2};
    EXPECT_THAT(error_of([&] { run(how); }),
                HasSubstr("has results of the shard 1/1; found --shard 1/2"));
    const std::string mine = plan().sha256();
    OneRank one;
    SweepWorkers workers{one};
    const SweepPlan other = plan("other");
    EXPECT_THAT(error_of([&] { run_sweep(other, options("mine"), workers); }),
                testing::AllOf(HasSubstr(mine), HasSubstr(other.sha256())));
    fs::create_directory(place.path() / "full");
    put("full/file", "x");
    EXPECT_THAT(error_of([&] { run(options("full")); }),
                HasSubstr("is not empty; expected a new or empty folder, or --force"));
    SweepOptions forced = options("full");
    forced.full_folder = FullFolder::Accept;
    EXPECT_EQ(run(forced).cases, 7);
    EXPECT_THAT(error_of([&] { run(options("full/file")); }), HasSubstr("is a file"));
}

TEST_F(SweepTest, KeepsFolders)
{
    SweepOptions how = options("kept");
    how.kept = KeptCases::Failed;
    run(how);
    EXPECT_THAT(files("kept/cases"), testing::ElementsAre("0000002"));
    EXPECT_THAT(files("kept/cases/0000002"), testing::ElementsAre("case.json"));
}

TEST_F(SweepTest, MergesItsShards)
{
    std::vector<fs::path> folders;
    for (const std::uint64_t number : {3, 1, 2}) {
        SweepOptions how = options("shard" + std::to_string(number));
        how.shard = {number, 3};
        run(how);
        folders.push_back(how.folder);
    }
    const fs::path whole = place.path() / "whole";
    const SweepTotals totals = merge_sweeps(folders, whole, FullFolder::Refuse);
    EXPECT_EQ(totals.cases, 7);
    EXPECT_EQ(totals.failed, 1);
    EXPECT_EQ(results("whole"), expected);

    const auto complaint = [&](std::vector<fs::path> shards) {
        return error_of(
            [&] { merge_sweeps(shards, place.path() / "x", FullFolder::Refuse); });
    };
    EXPECT_THAT(complaint({folders[0], folders[1]}),
                HasSubstr("the shard 2/3 is missing"));
    EXPECT_THAT(complaint({folders[1], folders[2]}),
                HasSubstr("the shard 3/3 is missing"));
    EXPECT_THAT(complaint({folders[0], folders[1], folders[2], folders[0]}),
                HasSubstr("the shard 3/3 occurs twice"));
    EXPECT_THAT(complaint({folders[0], whole}),
                HasSubstr("has results of the shard 1/1"));
    EXPECT_THAT(complaint({place.path() / "nowhere"}), HasSubstr("has no sweep.json"));
    EXPECT_THAT(complaint({}), HasSubstr("--merge: found no folder"));
    put("shard1/.endmill-journal.jsonl", "");
    EXPECT_THAT(complaint(folders), HasSubstr("has a sweep that has not ended"));
}

TEST_F(SweepTest, RefusesToMergeDamagedTables)
{
    std::vector<fs::path> folders;
    for (const std::uint64_t number : {1, 2}) {
        SweepOptions how = options("part" + std::to_string(number));
        how.shard = {number, 2};
        run(how);
        folders.push_back(how.folder);
    }
    const std::string header = "case,planes,n,m,exit_code,message,wall_s\n";
    const auto complaint = [&](const std::string& table) {
        put("part2/results.csv", table);
        return error_of(
            [&] { merge_sweeps(folders, place.path() / "x", FullFolder::Refuse); });
    };
    const std::string sound =
        header + "1,12,12,,0,,1\n3,14,14,,4,\"a, \"\"b\"\"\",1\n5,16,16,,0,,1\n";
    EXPECT_THAT(complaint(header + "1,12,12,,0,,1\n3,x\n5,16,16,,0,,1\n"),
                testing::AllOf(HasSubstr("E_CSV"), HasSubstr("results.csv:3: a row of "
                                                             "case 3 with another")));
    EXPECT_THAT(complaint(header + "1,12,12,,0,,1\n3,14,14,,0,\"a,1\n"),
                HasSubstr("results.csv:3: a row of case 3 with another"));
    EXPECT_THAT(complaint(header + "1,12,12,,0,,1\n5,16,16,,0,,1\n"),
                HasSubstr("results.csv:3: no row of case 3"));
    EXPECT_THAT(complaint(sound.substr(0, sound.size() - 1)),
                HasSubstr("results.csv:4: no row of case 5"));
    EXPECT_THAT(complaint(sound + "7,18,18,,0,,1\n"),
                HasSubstr("results.csv:5: a line after the last case"));
    EXPECT_THAT(complaint("case,n\n"), HasSubstr("results.csv:1: other columns"));
    EXPECT_THAT(complaint(""), HasSubstr("results.csv: file is empty"));
    EXPECT_FALSE(fs::exists(place.path() / "x"));
    EXPECT_EQ(complaint(sound), "accepted");
}

// Results name files relative to themselves: "../../part.json" must hold after a move.
TEST_F(SweepTest, RunsCasesAsDeepAsItKeepsThem)
{
    const fs::path script = place.path() / "program.sh";
    std::ofstream{script} << "#!/bin/sh\n"
                             "for word in \"$@\"; do case $word in\n"
                             "--output=*) out=${word#--output=};; esac; done\n"
                             "mkdir $out && test -f $out/../../../cases.csv\n";
    SweepOptions how = options("deep");
    fs::create_directories(how.folder / ".endmill-cases-killed/0000000");
    how.resume = true;
    how.kept = KeptCases::All;
    EXPECT_EQ(run(how).failed, 0);
    EXPECT_THAT(results("deep"), HasSubstr("6,17,,,0,,T"));
    EXPECT_TRUE(fs::exists(how.folder / "cases/0000006/../../../cases.csv"));
    EXPECT_THAT(files("deep"),
                testing::ElementsAre("cases", "results.csv", "sweep.json"));
}

TEST_F(SweepTest, OfAnEmptyShardHasNoRow)
{
    SweepOptions how = options("empty");
    how.shard = {9, 9};
    EXPECT_EQ(run(how).cases, 0);
    EXPECT_EQ(results("empty"), "case,planes,n,m,exit_code,message,wall_s\n");
}

}  // namespace
}  // namespace endmill
