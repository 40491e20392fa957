// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/output_folder.h"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "as_nobody.h"
#include "endmill/core/error.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;
using std::string_literals::operator""s;
using testing::HasSubstr;

// All files in a folder, by relative path.
std::set<std::string> names_in(const fs::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator{folder})
        names.insert(entry.path().lexically_relative(folder));
    return names;
}

using Names = std::set<std::string>;

TEST(OutputFolder, ShowsItsFilesTogetherWhenPublished)
{
    const TemporaryFolder place;
    OutputFolder output{place.path() / "a/b"};
    output.write("summary.json", "{}");
    output.write("u/toolpath.csv", std::string(3000000, 'x'));
    EXPECT_FALSE(fs::exists(place.path() / "a/b/summary.json"));
    EXPECT_FALSE(fs::exists(place.path() / "a/b/u/toolpath.csv"));
    output.publish();
    EXPECT_EQ(names_in(place.path()),
              (Names{"a", "a/b", "a/b/summary.json", "a/b/u", "a/b/u/toolpath.csv"}));
    EXPECT_EQ(content_of(place.path() / "a/b/summary.json"), "{}");
    EXPECT_EQ(content_of(place.path() / "a/b/u/toolpath.csv"), std::string(3000000, 'x'));
}

TEST(OutputFolder, IsNotThereBeforeItIsPublished)
{
    const TemporaryFolder place;
    OutputFolder output{place.path() / "a/"};
    output.write("u/a.csv", "x");
    EXPECT_FALSE(fs::exists(place.path() / "a"));
    output.publish();
    EXPECT_EQ(names_in(place.path()), (Names{"a", "a/u", "a/u/a.csv"}));
    output.write("b.csv", "x");
    output.publish();
    EXPECT_EQ(names_in(place.path()), (Names{"a", "a/b.csv", "a/u", "a/u/a.csv"}));
}

TEST(OutputFolder, IsRestoredIfAFileCannotBePublished)
{
    const TemporaryFolder place;
    place.put("summary.json", "old");
    place.put("b.csv", "old");
    place.put("left.csv", "old");
    OutputFolder output{place.path(), FullFolder::Accept};
    output.remove_unless_written("left.csv");
    for (const char* name : {"a.csv", "b.csv", "summary.json", "u/c.csv"})
        output.write(name, "new");
    place.put("u", "a file in the way");
    EXPECT_THAT([&] { output.publish(); },
                testing::ThrowsMessage<OutputError>(HasSubstr("u/c.csv: ")));
    for (const char* name : {"summary.json", "b.csv", "left.csv"})
        EXPECT_EQ(content_of(place.path() / name), "old") << name;
    EXPECT_FALSE(fs::exists(place.path() / "a.csv"));
}

TEST(OutputFolder, StatesWhyANameCannotBeUsed)
{
    const TemporaryFolder place;
    EXPECT_THAT([&] { OutputFolder{place.path() / std::string(300, 'n')}; },
                testing::ThrowsMessage<OutputError>(HasSubstr("File name too long")));
    fs::create_symlink("nowhere", place.path() / "link");
    EXPECT_THAT([&] { OutputFolder{place.path() / "link"}; },
                testing::ThrowsMessage<OutputError>(
                    HasSubstr("link: it is a link to nowhere, which does not exist")));
    fs::create_symlink("self", place.path() / "self");
    EXPECT_THAT([&] { OutputFolder{place.path() / "self"}; },
                testing::ThrowsMessage<OutputError>(
                    HasSubstr("it is a link to self, which cannot be followed")));
}

TEST(OutputFolder, LeavesNothingUnlessPublished)
{
    const TemporaryFolder place;
    {
        OutputFolder output{place.path() / "a/b"};
        output.write("u/toolpath.csv", "x");
    }
    EXPECT_EQ(names_in(place.path()), Names{});
}

TEST(OutputFolder, KeepsExistingFilesUnlessPublished)
{
    const TemporaryFolder place;
    place.put("old.csv", "old");
    {
        OutputFolder output{place.path(), FullFolder::Accept};
        output.write("old.csv", "new");
        output.write("other.csv", "other");
    }
    EXPECT_EQ(names_in(place.path()), Names{"old.csv"});
    EXPECT_EQ(content_of(place.path() / "old.csv"), "old");
}

TEST(OutputFolder, TheLaterOfTwoFilesOfOneNameStays)
{
    const TemporaryFolder place;
    OutputFolder output{place.path()};
    output.write("a.csv", "first");
    output.write("a.csv", "second");
    output.publish();
    EXPECT_EQ(names_in(place.path()), Names{"a.csv"});
    EXPECT_EQ(content_of(place.path() / "a.csv"), "second");
}

TEST(OutputFolder, WritesWithTheModeOfAnOrdinaryFile)
{
    const TemporaryFolder place;
    OutputFolder output{place.path()};
    output.write("a.csv", "x");
    output.publish();
    const auto ordinary = place.put("b.csv", "x");
    EXPECT_EQ(fs::status(place.path() / "a.csv").permissions(),
              fs::status(ordinary).permissions());
}

TEST(OutputFolder, RefusesAFolderThatIsNotEmptyOrAFile)
{
    const TemporaryFolder place;
    const fs::path file = place.put("a", "x");
    const auto refuses = [](const std::string& message) {
        return testing::ThrowsMessage<DomainError>(HasSubstr(message));
    };
    EXPECT_THAT([&] { OutputFolder{place.path()}; },
                refuses("is not empty; expected a new or empty folder"));
    EXPECT_NO_THROW((OutputFolder{place.path(), FullFolder::Accept}));
    EXPECT_THAT([&] { (OutputFolder{file, FullFolder::Accept}); }, refuses("is a file"));
    EXPECT_THAT([&] { OutputFolder{""}; }, refuses("an empty name"));
}

TEST(OutputFolder, StatesWhyAFolderCannotBeCreated)
{
    const TemporaryFolder place;
    const fs::path file = place.put("a", "x");
    try {
        const OutputFolder output{file / "below"};
        FAIL();
    } catch (const OutputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("Not a directory"));
        EXPECT_THAT(error.what(), HasSubstr("below"));
    }
}

TEST(OutputFolder, RefusesAFolderThatCannotBeWrittenTo)
{
    const TemporaryFolder place;
    fs::create_directory(place.path() / "read-only");
    ::chmod((place.path() / "read-only").c_str(), 0555);
    ::chmod(place.path().c_str(), 0555);
    {
        const AsNobody nobody;
        for (const char* name : {"read-only", "new", "read-only/new"})
            EXPECT_THAT([&] { OutputFolder{place.path() / name}; },
                        testing::ThrowsMessage<OutputError>(testing::EndsWith(
                            std::string{name} + ": Permission denied")));
    }
    ::chmod(place.path().c_str(), 0755);
    EXPECT_EQ(names_in(place.path()), Names{"read-only"});
}

TEST(OutputFolder, RefusesNamesThatLeaveTheFolder)
{
    const TemporaryFolder place;
    OutputFolder output{place.path() / "a"};
    for (const char* name : {"", ".", "..", "../x", "/tmp/x", "u/../../x", "u/"})
        EXPECT_THAT([&] { output.write(name, "x"); },
                    testing::ThrowsMessage<DomainError>(
                        HasSubstr(name + " is not the name of a file in the folder"s)));
}

TEST(OutputFolder, DoesNotReplaceAProtectedInput)
{
    const TemporaryFolder place;
    const fs::path input = place.put("surface.json", "{}");
    OutputFolder output{place.path() / "." / "", FullFolder::Accept};
    output.protect(input);
    EXPECT_THAT(
        [&] { output.write("surface.json", "x"); },
        testing::ThrowsMessage<DomainError>(HasSubstr("surface.json is the input file")));
    output.write("summary.json", "x");
    output.publish();
    EXPECT_EQ(content_of(input), "{}");
}

TEST(OutputFolder, DoesNotReplaceAFolder)
{
    const TemporaryFolder place;
    fs::create_directory(place.path() / "a.csv");
    OutputFolder output{place.path(), FullFolder::Accept};
    EXPECT_THAT([&] { output.write("a.csv", "x"); },
                testing::ThrowsMessage<OutputError>(HasSubstr("a.csv: Is a directory")));
}

class LeftoverTest : public testing::Test {
protected:
    // Publishes a run that writes the first of two files; an earlier run may have left
    // the second.
    void publish_first(const fs::path& input = {})
    {
        OutputFolder output{place.path(), FullFolder::Accept};
        if (!input.empty())
            output.protect(input);
        for (const char* name : {"first.csv", "u/second.csv"})
            output.remove_unless_written(name);
        output.write("first.csv", "new");
        output.publish();
    }

    const TemporaryFolder place;
};

TEST_F(LeftoverTest, IsRemovedWithItsFolderWhenPublished)
{
    place.put("first.csv", "old");
    fs::create_directory(place.path() / "u");
    place.put("u/second.csv", "old");
    publish_first();
    EXPECT_EQ(names_in(place.path()), Names{"first.csv"});
    EXPECT_EQ(content_of(place.path() / "first.csv"), "new");
}

TEST_F(LeftoverTest, IsTheOnlyFileThatIsRemoved)
{
    for (const char* folder : {"u", "u/v", "v"})
        fs::create_directory(place.path() / folder);
    for (const char* name : {"u/second.csv", "u/other.csv", "u/v/second.csv", "mine.txt"})
        place.put(name, "old");
    publish_first();
    EXPECT_EQ(names_in(place.path()), (Names{"first.csv", "mine.txt", "u", "u/other.csv",
                                             "u/v", "u/v/second.csv", "v"}));
}

TEST_F(LeftoverTest, StaysUnlessPublished)
{
    fs::create_directory(place.path() / "u");
    place.put("u/second.csv", "old");
    {
        OutputFolder output{place.path(), FullFolder::Accept};
        output.remove_unless_written("u/second.csv");
        output.write("first.csv", "new");
    }
    EXPECT_EQ(names_in(place.path()), (Names{"u", "u/second.csv"}));
}

TEST_F(LeftoverTest, StaysIfItIsTheInput)
{
    fs::create_directory(place.path() / "u");
    publish_first(place.put("u/second.csv", "the input"));
    EXPECT_EQ(content_of(place.path() / "u/second.csv"), "the input");
}

TEST_F(LeftoverTest, StaysIfALinkLeadsToIt)
{
    const TemporaryFolder elsewhere;
    elsewhere.put("second.csv", "of another");
    fs::create_directory_symlink(elsewhere.path(), place.path() / "u");
    publish_first();
    EXPECT_TRUE(fs::exists(elsewhere.path() / "second.csv"));
    EXPECT_TRUE(fs::is_symlink(place.path() / "u"));
}

TEST_F(LeftoverTest, StaysIfItIsNoPlainFile)
{
    fs::create_directories(place.path() / "u/second.csv");
    publish_first();
    EXPECT_EQ(names_in(place.path()), (Names{"first.csv", "u", "u/second.csv"}));
    fs::remove(place.path() / "u/second.csv");
    fs::create_symlink("../first.csv", place.path() / "u/second.csv");
    publish_first();
    EXPECT_TRUE(fs::is_symlink(place.path() / "u/second.csv"));
}

TEST_F(LeftoverTest, MustHaveAPlainName)
{
    OutputFolder output{place.path()};
    for (const char* name : {"", "..", "../x", "/tmp/x"})
        EXPECT_THROW(output.remove_unless_written(name), DomainError) << name;
}

// A limit on the size of files simulates a full disk.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_{};
};

TEST(OutputFolder, AFullDiskIsAnErrorThatLeavesNothing)
{
    const TemporaryFolder place;
    {
        OutputFolder output{place.path() / "a"};
        output.write("small.csv", "x");
        const FileSizeLimit limit{100000};
        try {
            output.write("large.csv", std::string(200000, 'x'));
            FAIL();
        } catch (const OutputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("large.csv: File too large"));
        }
        EXPECT_FALSE(fs::exists(place.path() / "a"));
    }
    EXPECT_EQ(names_in(place.path()), Names{});
}

TEST(OutputFolder, AnErrorKeepsTheEarlierFileOfTheName)
{
    const TemporaryFolder place;
    OutputFolder output{place.path()};
    output.write("a.csv", "sound");
    {
        const FileSizeLimit limit{10};
        EXPECT_THROW(output.write("a.csv", std::string(20, 'x')), OutputError);
    }
    output.publish();
    EXPECT_EQ(content_of(place.path() / "a.csv"), "sound");
}

TEST(OutputFolder, WritesAFileInPieces)
{
    const TemporaryFolder place;
    OutputFolder output{place.path()};
    output.write_pieces("a.csv", [](const OutputFolder::Sink& sink) {
        sink("one,");
        sink("");
        sink("two");
    });
    output.publish();
    EXPECT_EQ(content_of(place.path() / "a.csv"), "one,two");
}

TEST(OutputFolder, HasNoFileWhosePiecesFailHalfway)
{
    const TemporaryFolder place;
    OutputFolder output{place.path()};
    output.write("a.csv", "sound");
    const auto failing = [](const OutputFolder::Sink& sink) {
        sink("half");
        throw GeometryError{"no more"};
    };
    EXPECT_THROW(output.write_pieces("a.csv", failing), GeometryError);
    EXPECT_THROW(output.write_pieces("b.csv", failing), GeometryError);
    {
        const FileSizeLimit limit{10};
        EXPECT_THROW(output.write_pieces("c.csv",
                                         [](const OutputFolder::Sink& sink) {
                                             sink("12345678");
                                             sink("9ab");
                                         }),
                     OutputError);
    }
    output.publish();
    EXPECT_EQ(names_in(place.path()), Names{"a.csv"});
    EXPECT_EQ(content_of(place.path() / "a.csv"), "sound");
}

// Runs in a separate process, because nothing can be written after `abandon_all`.
TEST(OutputFolderDeathTest, AbandonAllRemovesUnpublishedFilesAndStopsFurtherWrites)
{
    const TemporaryFolder place;
    const auto interrupted = [&] {
        OutputFolder published{place.path() / "published"};
        published.write("a.csv", "x");
        published.publish();
        OutputFolder unpublished{place.path() / "unpublished/u"};
        unpublished.write("a.csv", "x");
        OutputFolder::abandon_all();
        OutputFolder::abandon_all();
        bool refused = true;
        for (OutputFolder* output : {&published, &unpublished}) {
            try {
                output->write("b.csv", "x");
                refused = false;
            } catch (const OutputError&) {
            }
        }
        ::_exit(refused ? 0 : 1);
    };
    EXPECT_EXIT(interrupted(), testing::ExitedWithCode(0), "");
    EXPECT_EQ(names_in(place.path()), (Names{"published", "published/a.csv"}));
}

TEST(WriteFile, ReplacesOneFileAndCreatesItsFolder)
{
    const TemporaryFolder place;
    write_file(place.path() / "x/y.csv", "one");
    write_file(place.path() / "x/y.csv", "two");
    EXPECT_EQ(names_in(place.path()), (Names{"x", "x/y.csv"}));
    EXPECT_EQ(content_of(place.path() / "x/y.csv"), "two");
}

}  // namespace
}  // namespace endmill
