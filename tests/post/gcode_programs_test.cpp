// SPDX-License-Identifier: GPL-3.0-or-later

// The programs in tests/data/gcode, written by hand in the dialects of several controls.
// programs.csv lists for each whether it is read; the number of points and the last one,
// counted by hand; and words of a remark or of the error.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/post/fed_gcode.h"
#include "read_program.h"

namespace endmill {
namespace {

const std::filesystem::path folder = ENDMILL_SOURCE_DIR "/tests/data/gcode";

struct Listed {
    std::string file;
    std::string outcome;
    std::string points;
    std::string end;
    std::string words;
};

std::string content(const std::string& name)
{
    std::ifstream file{folder / name, std::ios::binary};
    return {std::istreambuf_iterator<char>{file}, {}};
}

// The fields of a row of the table; a field in quotes has its quotes doubled.
std::vector<std::string> fields(const std::string& row)
{
    std::vector<std::string> found(1);
    bool is_quoted = false;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] == '"' && is_quoted && i + 1 < row.size() && row[i + 1] == '"')
            found.back() += row[i++];
        else if (row[i] == '"')
            is_quoted = !is_quoted;
        else if (row[i] == ',' && !is_quoted)
            found.emplace_back();
        else
            found.back() += row[i];
    }
    return found;
}

std::vector<Listed> listed_programs()
{
    std::istringstream table{content("programs.csv")};
    std::vector<Listed> programs;
    std::string row;
    std::getline(table, row);
    while (std::getline(table, row)) {
        const auto f = fields(row);
        programs.push_back({f.at(0), f.at(1), f.at(2), f.at(3), f.at(4)});
    }
    return programs;
}

std::ostream& operator<<(std::ostream& out, const Listed& listed)
{
    return out << listed.file;
}

class ListedProgram : public testing::TestWithParam<Listed> {};

TEST_P(ListedProgram, IsReadOrRefusedAsListed)
{
    const Listed& listed = GetParam();
    const std::string text = content(listed.file);
    ASSERT_FALSE(text.empty());
    if (listed.outcome == "refused") {
        EXPECT_THAT(gcode_refusal(text), testing::HasSubstr(listed.words));
        EXPECT_THAT(gcode_refusal(text), testing::StartsWith("E_GCODE f.ngc"));
        return;
    }
    ASSERT_EQ(listed.outcome, "read");
    const Program program = read_gcode(text);
    EXPECT_EQ(std::to_string(program.path.points.size()), listed.points);
    std::istringstream end{listed.end};
    Vec3 last;
    end >> last.x() >> last.y() >> last.z();
    EXPECT_NEAR((program.path.points.back().location.tip - last).norm(), 0, 1e-9);
    EXPECT_THAT(testing::PrintToString(program.remarks),
                testing::HasSubstr(listed.words));

    // The program with half of its feeds has the same points.
    ToolPath slower = program.path;
    for (PathPoint& point : slower.points)
        if (point.conditions.feed_mm_per_min)
            *point.conditions.feed_mm_per_min /= 2;
    const Program again = read_gcode(fed_gcode(text, "f.ngc", {}, slower));
    EXPECT_EQ(tips(again), tips(program));
    for (std::size_t i = 0; i < slower.points.size(); ++i)
        EXPECT_NEAR(again.path.points[i].conditions.feed_mm_per_min.value_or(-1),
                    slower.points[i].conditions.feed_mm_per_min.value_or(-1), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Dialects, ListedProgram, testing::ValuesIn(listed_programs()));

TEST(ListedPrograms, AreAllOfTheFolder)
{
    std::vector<std::string> names{"programs.csv"};
    for (const Listed& listed : listed_programs())
        names.push_back(listed.file);
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator{folder})
        files.push_back(entry.path().filename().string());
    EXPECT_THAT(names, testing::UnorderedElementsAreArray(files));
    EXPECT_GE(files.size(), 31U);
}

}  // namespace
}  // namespace endmill
