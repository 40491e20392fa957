// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/import/cad_import.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cad_answers.h"
#include "endmill/core/error.h"
#include "endmill/job/child_process.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

// A STEP file, and shell scripts in place of endmill-cad, which is not needed for what its
// parent does.
class CadImport : public testing::Test {
protected:
    CadImport() : folder_{fs::temp_directory_path()}, file_{folder_.path() / "a b ü.step"}
    {
        put(file_, "ISO-10303-21;\n");
        put(folder_.path() / "answer", test::square_answer());
    }

    static void put(const fs::path& path, const std::string& content)
    {
        std::ofstream{path, std::ios::binary} << content;
    }

    // A program that counts its runs in the file "runs" and then does `act`.
    fs::path program(const std::string& act) const
    {
        fs::path path = folder_.path() / "program";
        put(path, "#!/bin/sh\necho run >> '" + (folder_.path() / "runs").string() +
                      "'\n" + act + "\n");
        fs::permissions(path, fs::perms::owner_all);
        return path;
    }

    fs::path good_program() const
    {
        return program("/bin/cat '" + (folder_.path() / "answer").string() + "'");
    }

    int runs() const
    {
        std::ifstream file{folder_.path() / "runs"};
        return static_cast<int>(
            std::count(std::istreambuf_iterator<char>{file}, {}, '\n'));
    }

    std::string complaint(const std::string& act, const CadImportOptions& options = {},
                          const ReadLimits& limits = {}) const
    {
        try {
            import_cad(program(act), file_, options, limits);
        } catch (const Error& error) {
            return error.code() + ' ' + error.what();
        }
        return {};
    }

    PrivateFolder folder_;
    fs::path file_;
};

TEST(CadFormat, FollowsTheExtension)
{
    EXPECT_EQ(cad_format("a/part.STEP"), CadFormat::Step);
    EXPECT_EQ(cad_format("part.stp"), CadFormat::Step);
    EXPECT_EQ(cad_format("part.iges"), CadFormat::Iges);
    EXPECT_EQ(cad_format("part.IGS"), CadFormat::Iges);
    EXPECT_EQ(cad_format("step"), std::nullopt);
    EXPECT_EQ(cad_format("part.stl"), std::nullopt);
}

TEST_F(CadImport, ReadsTheAnswerOfTheProgram)
{
    EXPECT_EQ(import_cad(good_program(), file_).faces.size(), 2U);
}

TEST_F(CadImport, GivesTheFileAsInputAndTheOptionsAsArguments)
{
    const fs::path seen = folder_.path() / "seen";
    complaint(
        "{ echo \"$@\"; /bin/cat; /usr/bin/env; } > '" + seen.string() + "'; exit 3",
        {.chord_tolerance_mm = 0.5, .angle_deg = 90, .max_faces = 7});
    std::ifstream file{seen};
    const std::string text{std::istreambuf_iterator<char>{file}, {}};
    EXPECT_THAT(text, StartsWith("step 0.5 1.5707963267948966 7 plain\nISO-10303-21;\n"));
    EXPECT_THAT(text, testing::Not(HasSubstr("HOME=")));
}

TEST_F(CadImport, ReportsWhyTheProgramRefuses)
{
    EXPECT_THAT(complaint("echo 'endmill-cad: no surfaces' >&2; exit 3"),
                HasSubstr("ü.step: no surfaces"));
    EXPECT_THAT(complaint("exit 3"), HasSubstr("no reason given"));
    EXPECT_THAT(complaint("printf 'endmill-cad: a\\033[31mb\\n' >&2; exit 3"),
                HasSubstr("a[31mb"));
}

TEST_F(CadImport, ReportsACrash)
{
    EXPECT_THAT(complaint("kill -SEGV $$"),
                testing::AllOf(StartsWith("E_CAD"), HasSubstr("crashed on this file")));
    EXPECT_THAT(complaint("kill -ABRT $$"), HasSubstr("signal 6"));
    EXPECT_THAT(complaint("exit 7"), StartsWith("E_CAD"));
}

TEST_F(CadImport, ReportsLimits)
{
    EXPECT_THAT(complaint("while :; do :; done", {.limit_seconds = 0.5}),
                testing::AllOf(StartsWith("E_LIMIT"), HasSubstr("0.5 s")));
    EXPECT_THAT(complaint("/bin/sleep 60", {.limit_seconds = 0.5}),
                StartsWith("E_LIMIT"));
    EXPECT_THAT(complaint("echo 'endmill-cad: no memory' >&2; exit 6"),
                HasSubstr("more memory than 4 GiB (--limit-gib"));
    EXPECT_THAT(complaint("echo 'endmill-cad: 9 faces' >&2; exit 6"),
                testing::AllOf(StartsWith("E_LIMIT"), HasSubstr("9 faces")));
    EXPECT_THAT(complaint("kill -KILL $$"),
                testing::AllOf(StartsWith("E_LIMIT"), HasSubstr("was killed")));
}

TEST_F(CadImport, StopsAnAnswerWithoutEnd)
{
    EXPECT_THAT(complaint("while :; do echo yyyyyyyyyyyyyyyyyyyyyyyyyy; done", {},
                          {.max_memory_gib = 1e-3}),
                testing::AllOf(StartsWith("E_LIMIT"), HasSubstr("--max-memory")));
}

TEST_F(CadImport, RefusesALie)
{
    EXPECT_THAT(complaint("echo all is well"), StartsWith("E_CAD"));
    EXPECT_THAT(complaint(":"), HasSubstr("damaged answer"));
}

TEST_F(CadImport, RefusesOtherContent)
{
    put(file_, "solid x\n");
    EXPECT_THAT(complaint(":"), StartsWith("E_FORMAT"));
    put(file_, "");
    EXPECT_THAT(complaint(":"), StartsWith("E_EMPTY"));
    fs::remove(file_);
    EXPECT_THAT(complaint(":"), StartsWith("E_OPEN"));
    EXPECT_EQ(runs(), 0);
}

TEST_F(CadImport, NeedsTheProgram)
{
    EXPECT_THROW(import_cad("", file_), DomainError);
    EXPECT_THROW(import_cad("/nowhere/endmill-cad", file_), OutputError);
    EXPECT_THROW(import_cad(good_program(), file_, {.chord_tolerance_mm = 0}),
                 DomainError);
}

TEST_F(CadImport, WithCacheRunsTheProgramOnceForAFile)
{
    const fs::path cache = folder_.path() / "cache";
    const fs::path good = good_program();
    const auto import = [&](const char* version) {
        return import_cad_with_cache(good, file_, cache, version);
    };
    EXPECT_EQ(import("1").faces.size(), 2U);
    EXPECT_EQ(import("1").faces.size(), 2U);
    EXPECT_EQ(runs(), 1);
    import("2");
    EXPECT_EQ(runs(), 2);
    put(file_, "ISO-10303-21; changed");
    import("1");
    EXPECT_EQ(runs(), 3);
    EXPECT_EQ(std::distance(fs::directory_iterator{cache}, {}), 3);
    fs::last_write_time(good, fs::last_write_time(good) + std::chrono::seconds{1});
    import("1");  // another build
    EXPECT_EQ(runs(), 4);
}

TEST_F(CadImport, WithCacheMakesADamagedAnswerAgain)
{
    const fs::path cache = folder_.path() / "cache";
    const fs::path good = good_program();
    import_cad_with_cache(good, file_, cache, "1");
    for (const auto& entry : fs::directory_iterator{cache})
        fs::resize_file(entry.path(), 100);
    EXPECT_EQ(import_cad_with_cache(good, file_, cache, "1").faces.size(), 2U);
    EXPECT_EQ(runs(), 2);
    for (const auto& entry : fs::directory_iterator{cache}) {
        std::fstream file{entry.path(), std::ios::binary | std::ios::in | std::ios::out};
        file.seekp(-5, std::ios::end);
        file.put('\x01');  // of a coordinate or a number, which alone would be valid
    }
    EXPECT_EQ(import_cad_with_cache(good, file_, cache, "1").faces.size(), 2U);
    EXPECT_EQ(runs(), 3);
}

TEST_F(CadImport, WithCacheKeepsNothingOfAFileThatChangesMeanwhile)
{
    const fs::path cache = folder_.path() / "cache";
    const fs::path changing =
        program("/bin/cat '" + (folder_.path() / "answer").string() +
                "'; echo 'ISO-10303-21; changed' > '" + file_.string() + "'");
    EXPECT_THROW(import_cad_with_cache(changing, file_, cache, "1"), FormatError);
    EXPECT_FALSE(fs::exists(cache));
}

TEST_F(CadImport, ACacheThatCannotBeWrittenOnlyCostsTime)
{
    const fs::path cache = folder_.path() / "cache";
    put(cache, "a file");
    EXPECT_EQ(import_cad_with_cache(good_program(), file_, cache, "1").faces.size(), 2U);
}

TEST_F(CadImport, RefusesAnAnswerWithoutTheMeasuresThatWereAskedFor)
{
    const std::string measured = test::square_head;
    const std::size_t begin = measured.find("\"measures\"");
    const std::size_t end = measured.find("\"faces\"");
    const std::string plain = measured.substr(0, begin) + measured.substr(end);
    std::string negative = measured;
    negative.replace(negative.find("[2, 2]"), 6, "[2,-2]");
    CadImportOptions options;
    options.measures = true;
    for (const std::string& head : {plain, negative}) {
        put(folder_.path() / "answer",
            test::cad_answer(head, test::SquareArrays{}.bytes()));
        EXPECT_THAT(
            complaint("/bin/cat '" + (folder_.path() / "answer").string() + "'", options),
            HasSubstr("lacks the areas"));
    }
}

TEST_F(CadImport, RefusesTolerancesBeyondTheirDomain)
{
    for (const double tolerance : {0.0, 1e-9, 1e300})
        EXPECT_THROW(import_cad(good_program(), file_, {.chord_tolerance_mm = tolerance}),
                     DomainError);
}

TEST_F(CadImport, WithoutAFolderKeepsNothing)
{
    import_cad_with_cache(good_program(), file_, "", "1");
    import_cad_with_cache(good_program(), file_, "", "1");
    EXPECT_EQ(runs(), 2);
}

}  // namespace
}  // namespace endmill
