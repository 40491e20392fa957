// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/sweep_journal.h"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/job/child_process.h"
#include "some_program.h"

namespace endmill {
namespace {

using testing::HasSubstr;

const SweepIdentity identity{"abc", 10, {2, 3}};  // the cases 1, 4 and 7

class SweepJournalTest : public testing::Test {
protected:
    std::string content() const
    {
        std::ifstream stream{file, std::ios::binary};
        return {std::istreambuf_iterator<char>{stream}, {}};
    }
    void put(const std::string& text) const
    {
        std::ofstream{file, std::ios::binary} << text;
    }

    PrivateFolder folder{testing::TempDir()};
    std::filesystem::path file = folder.path() / "journal";
};

TEST_F(SweepJournalTest, KeepsRowsForTheNextProcess)
{
    const CaseRow row{7, {"x"}, 3, "bad", 0.5};
    {
        SweepJournal journal{file, identity};
        journal.append(row);
        journal.append({1, {"y"}, 0, "", 0.5});
    }
    const SweepJournal journal{file, identity};
    EXPECT_EQ(journal.count(), 2);
    EXPECT_EQ(journal.failed(), 1);
    EXPECT_TRUE(journal.has(0));
    EXPECT_FALSE(journal.has(1));
    EXPECT_TRUE(journal.has(2));
    EXPECT_EQ(journal.row(2), row);
    EXPECT_EQ(SweepJournal::identity_in(file), identity);
}

// A kill may leave any beginning of the file.
TEST_F(SweepJournalTest, GoesOnFromEveryBeginningOfItself)
{
    {
        SweepJournal journal{file, identity};
        journal.append({4, {"x"}, 0, "", 0.5});
        journal.append({1, {"y"}, 0, "", 0.5});
    }
    const std::string whole = content();
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        put(whole.substr(0, length));
        {
            SweepJournal journal{file, identity};
            for (std::uint64_t i = 0; i < 3; ++i)
                if (!journal.has(i))
                    journal.append({identity.shard.at(i), {"z"}, 0, "", 0.5});
        }
        const SweepJournal journal{file, identity};
        ASSERT_EQ(journal.count(), 3) << length;
    }
}

TEST_F(SweepJournalTest, HasNoIdentityUntilItsFirstLineIsComplete)
{
    EXPECT_EQ(SweepJournal::identity_in(file), std::nullopt);
    put("{\"format\": ");
    EXPECT_EQ(SweepJournal::identity_in(file), std::nullopt);
}

TEST_F(SweepJournalTest, RefusesWhatEndmillDidNotWrite)
{
    const auto complaint = [&] {
        return error_of([&] { const SweepJournal journal{file, identity}; });
    };
    put("hello\n");
    EXPECT_THAT(complaint(), HasSubstr("journal:1: a line that endmill did not write"));
    EXPECT_THAT(error_of([&] { SweepJournal::identity_in(file); }),
                HasSubstr(":1: a line"));
    std::filesystem::remove(file);
    {
        SweepJournal journal{file, identity};
        journal.append({4, {"x"}, 0, "", 0.5});
    }
    const std::string sound = content();
    put(sound + row_line({5, {}, 0, "", 0}) + "\n");
    EXPECT_THAT(complaint(), HasSubstr("journal:3: a line"));
    put(sound + row_line({13, {}, 0, "", 0}) + "\n");
    EXPECT_THAT(complaint(), HasSubstr("journal:3: a line"));
}

}  // namespace
}  // namespace endmill
