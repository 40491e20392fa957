// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/child_process.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;
using testing::StartsWith;

double seconds_of(const std::function<void()>& act)
{
    const auto start = std::chrono::steady_clock::now();
    act();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
        .count();
}

ChildTask shell(const std::string& script)
{
    return {.program = "/bin/sh",
            .arguments = {"-c", script},
            .environment = minimal_environment("/")};
}

TEST(ChildProcess, ReportsTheExitCode)
{
    const ChildResult result = run_child(shell("exit 3"));
    EXPECT_EQ(result.end, ChildEnd::Exited);
    EXPECT_EQ(result.code, 3);
}

TEST(ChildProcess, ReportsTheSignalThatEndedIt)
{
    const ChildResult result = run_child(shell("kill -SEGV $$"));
    EXPECT_EQ(result.end, ChildEnd::Signalled);
    EXPECT_EQ(result.code, SIGSEGV);
}

TEST(ChildProcess, ReportsAProgramThatCannotBeLoaded)
{
    EXPECT_EQ(run_child({.program = "/nowhere/program", .arguments = {}}).end,
              ChildEnd::NotStarted);
}

TEST(ChildProcess, PassesOnEachLineOfTheStandardError)
{
    ChildTask task = shell("echo hidden; echo one >&2; echo >&2; printf two >&2");
    std::vector<std::string> lines;
    task.error_line = [&](std::string_view line) { lines.emplace_back(line); };
    run_child(task);
    EXPECT_THAT(lines, ElementsAre("one", "", "two"));
}

TEST(ChildProcess, PassesOnMoreThanAPipeHolds)
{
    ChildTask task =
        shell("i=0; while [ $i -lt 20000 ]; do echo line $i >&2; i=$((i+1)); done");
    std::size_t count = 0;
    std::string last;
    task.error_line = [&](std::string_view line) {
        ++count;
        last = line;
    };
    run_child(task);
    EXPECT_EQ(count, 20000);
    EXPECT_EQ(last, "line 19999");
}

TEST(ChildProcess, PassesOnTheStandardOutputUnchanged)
{
    std::string output;
    ChildTask task =
        shell("printf 'a\\0b\\n'; echo hidden >&2; head -c 300000 /dev/zero");
    task.output = [&](std::string_view piece) { output += piece; };
    EXPECT_EQ(run_child(task).code, 0);
    EXPECT_EQ(output, std::string("a\0b\n", 4) + std::string(300000, '\0'));
}

TEST(ChildProcess, EndsTheChildIfTheReceiverOfItsOutputThrows)
{
    ChildTask task = shell("while :; do echo more; done");
    task.output = [](std::string_view) { throw std::length_error{"enough"}; };
    EXPECT_THROW(run_child(task), std::length_error);
}

TEST(ChildProcess, LimitsTheTimeOfAChildThatWritesWithoutEnd)
{
    ChildTask task = shell("while :; do echo more; done");
    task.limits.wall_seconds = 0.3;
    task.output = [](std::string_view) {};
    EXPECT_EQ(run_child(task).end, ChildEnd::OutOfTime);
}

TEST(ChildProcess, HasAFileAsItsInputThatItCannotWrite)
{
    const PrivateFolder folder{"/tmp"};
    folder.write("input", "content\n");
    ChildTask task = shell("cat; echo x >&0 || echo refused");
    task.input = folder.path() / "input";
    std::string output;
    task.output = [&](std::string_view piece) { output += piece; };
    EXPECT_EQ(run_child(task).code, 0);
    EXPECT_EQ(output, "content\nrefused\n");
    task.input = folder.path() / "missing";
    EXPECT_THROW(run_child(task), OutputError);
}

TEST(ChildProcess, CutsALineWithoutEnd)
{
    ChildTask task = shell("head -c 1000000 /dev/zero | tr '\\0' a >&2");
    std::size_t longest = 0;
    task.error_line = [&](std::string_view line) {
        longest = std::max(longest, line.size());
    };
    run_child(task);
    EXPECT_EQ(longest, 65536);
}

TEST(ChildProcess, EndsTheChildAndItsChildrenAtTheLimitOfTime)
{
    ChildTask task = shell("sleep 60 & sleep 60");
    task.limits.wall_seconds = 0.2;
    ChildResult result{};
    EXPECT_LT(seconds_of([&] { result = run_child(task); }), 10);
    EXPECT_EQ(result.end, ChildEnd::OutOfTime);
}

TEST(ChildProcess, LimitsTheDataOfAChild)
{
    ChildTask task = shell("head -c 200000000 /dev/zero | tail -c 200000000 > /dev/null");
    EXPECT_EQ(run_child(task).code, 0);
    task.limits.data_bytes = 50e6;
    EXPECT_NE(run_child(task).code, 0);
}

TEST(ChildProcess, EndsTheChildIfTheReceiverOfLinesThrows)
{
    ChildTask task = shell("echo line >&2; sleep 60");
    task.error_line = [](std::string_view) { throw std::runtime_error{"enough"}; };
    EXPECT_LT(seconds_of([&] { EXPECT_THROW(run_child(task), std::runtime_error); }), 10);
}

TEST(ChildProcess, WritesBothOutputsToItsLog)
{
    const PrivateFolder folder{testing::TempDir()};
    ChildTask task = shell("echo one; echo two >&2");
    task.folder = folder.path();
    task.log = folder.path() / "log.txt";
    run_child(task);
    std::ifstream file{task.log};
    EXPECT_EQ((std::string{std::istreambuf_iterator<char>{file}, {}}), "one\ntwo\n");
}

TEST(ChildProcess, RunsSeveralAtTheSameTime)
{
    const double seconds = seconds_of([] {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 8; ++i)
            threads.emplace_back(
                [] { EXPECT_EQ(run_child(shell("sleep 0.5")).code, 0); });
    });
    EXPECT_LT(seconds, 3);
}

TEST(ChildProcess, PassesArgumentsWithoutAShell)
{
    ChildTask task = shell(R"(echo "$1" >&2)");
    task.arguments.insert(task.arguments.end(), {"name", "$(exit 1); `false` \"x\""});
    std::string line;
    task.error_line = [&](std::string_view text) { line = text; };
    run_child(task);
    EXPECT_EQ(line, "$(exit 1); `false` \"x\"");
}

TEST(InheritedEnvironment, LeavesOutTheVariablesOfMpi)
{
    ::setenv("OMPI_COMM_WORLD_SIZE", "4", 1);
    ::setenv("ENDMILL_TEST", "yes", 1);
    const auto kept = inherited_environment();
    ::unsetenv("OMPI_COMM_WORLD_SIZE");
    EXPECT_THAT(kept, Contains("ENDMILL_TEST=yes"));
    EXPECT_THAT(kept, Not(Contains(StartsWith("OMPI_"))));
}

TEST(RunningProgram, IsThisTest)
{
    EXPECT_EQ(running_program().filename(), "endmill_job_test");
}

}  // namespace
}  // namespace endmill
