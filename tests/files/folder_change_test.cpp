// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/folder_change.h"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/files/output_folder.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;
using std::string_literals::operator""s;
using testing::HasSubstr;
using Names = std::set<std::string>;

// All files in a folder, by relative path.
Names names_in(const fs::path& folder)
{
    Names names;
    for (const auto& entry : fs::recursive_directory_iterator{folder})
        names.insert(entry.path().lexically_relative(folder));
    return names;
}

// A run whose process is gone: no process has this number. It was killed at some time while
// it replaced a.csv and summary.json, wrote u/b.csv for the first time, and removed left.csv.
class KilledRunTest : public testing::Test {
protected:
    static constexpr const char* staging = ".endmill-4194305-0.tmp";

    void put(const fs::path& name, const std::string& content) const
    {
        fs::create_directories((place.path() / name).parent_path());
        place.put(name, content);
    }

    // The state after a number of its renames, 0 to 6.
    void kill_after(int renames) const
    {
        const fs::path hidden = staging;
        put(hidden / "names", "oa.csv\0nu/b.csv\0osummary.json\0rleft.csv\0du\0"s);
        fs::create_directories(place.path() / hidden / "old");
        put(renames > 0 ? hidden / "old/summary.json" : "summary.json", "old");
        put(renames > 1 ? hidden / "old/a.csv" : "a.csv", "old");
        put(renames > 2 ? hidden / "old/left.csv" : "left.csv", "old");
        put(renames > 3 ? "a.csv" : hidden / "new/a.csv", "new");
        put(renames > 4 ? "u/b.csv" : hidden / "new/u/b.csv", "new");
        put(renames > 5 ? "summary.json" : hidden / "new/summary.json", "new");
    }

    const TemporaryFolder place;
};

TEST_F(KilledRunTest, IsUndoneUnlessAllItsFilesArePublished)
{
    for (int renames = 0; renames <= 6; ++renames) {
        for (const auto& entry : fs::directory_iterator{place.path()})
            fs::remove_all(entry.path());
        kill_after(renames);
        const OutputFolder next{place.path(), FullFolder::Accept};
        const bool is_new = renames == 6;
        EXPECT_FALSE(fs::exists(place.path() / staging)) << renames;
        EXPECT_EQ(content_of(place.path() / "summary.json"), is_new ? "new" : "old");
        EXPECT_EQ(content_of(place.path() / "a.csv"), is_new ? "new" : "old");
        EXPECT_EQ(fs::exists(place.path() / "u/b.csv"), is_new);
        EXPECT_EQ(fs::exists(place.path() / "u"), is_new);
        EXPECT_EQ(fs::exists(place.path() / "left.csv"), !is_new);
    }
}

// The next run may be killed as well while it undoes: between two of its renames, or while
// it removes the staging folder.
TEST_F(KilledRunTest, CanBeUndoneAgain)
{
    for (int renames = 0; renames < 6; ++renames) {
        for (const auto& entry : fs::directory_iterator{place.path()})
            fs::remove_all(entry.path());
        kill_after(renames);
        EXPECT_TRUE((FolderChange{place.path(), place.path() / staging}.undo()));
        EXPECT_TRUE((FolderChange{place.path(), place.path() / staging}.undo()));
        fs::remove_all(place.path() / staging / "new/u");
        const OutputFolder next{place.path(), FullFolder::Accept};
        EXPECT_EQ(content_of(place.path() / "summary.json"), "old") << renames;
        EXPECT_EQ(content_of(place.path() / "a.csv"), "old");
        EXPECT_EQ(content_of(place.path() / "left.csv"), "old");
        EXPECT_FALSE(fs::exists(place.path() / "u"));
        EXPECT_FALSE(fs::exists(place.path() / staging));
    }
}

TEST_F(KilledRunTest, KeepsTheOldFilesIfItsJournalCannotBeRead)
{
    for (const char* names : {"", "oa.csv", "xa.csv\n", "osummary.json"}) {
        kill_after(3);
        put(fs::path{staging} / "names", names);  // no zero byte at the end
        EXPECT_THAT([&] { OutputFolder(place.path(), FullFolder::Accept); },
                    testing::ThrowsMessage<OutputError>(
                        testing::AllOf(HasSubstr("cannot restore"), HasSubstr(staging))));
        EXPECT_EQ(content_of(place.path() / staging / "old/a.csv"), "old");
        fs::remove_all(place.path() / staging);
    }
}

TEST_F(KilledRunTest, DoesNotCountAsContent)
{
    put(fs::path{staging} / "new/a.csv", "new");
    put(fs::path{staging} / ".part-1", "n");
    EXPECT_NO_THROW(OutputFolder{place.path()});
    EXPECT_EQ(names_in(place.path()), Names{});
}

TEST_F(KilledRunTest, CannotTouchFilesOutsideItsFolder)
{
    const TemporaryFolder elsewhere;
    elsewhere.put("b.csv", "of another");
    fs::create_directory_symlink(elsewhere.path(), place.path() / "u");
    const std::string outside = (elsewhere.path() / "b.csv").string();
    for (const std::string& entry : {"nu/b.csv"s, "n" + outside, "n../b.csv"s}) {
        put(fs::path{staging} / "names", entry + "\0na.csv\0"s);
        put(fs::path{staging} / "new/a.csv", "new");
        fs::create_directories(place.path() / staging / "old");
        static_cast<void>(FolderChange{place.path(), place.path() / staging}.undo());
        EXPECT_EQ(content_of(elsewhere.path() / "b.csv"), "of another");
    }
}

TEST_F(KilledRunTest, StaysWhileItsProcessLives)
{
    const OutputFolder living{place.path()};
    EXPECT_THAT([&] { OutputFolder{place.path()}; },
                testing::ThrowsMessage<DomainError>(HasSubstr("is not empty")));
    const OutputFolder other{place.path(), FullFolder::Accept};
    EXPECT_EQ(names_in(place.path()).size(), 4U);  // two staging folders
}

}  // namespace
}  // namespace endmill
