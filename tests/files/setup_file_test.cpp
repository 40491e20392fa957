// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/setup_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string facet_list_complaint(const std::string& list)
{
    const TemporaryFolder folder;
    const auto file = folder.put("list.txt", list);
    return complaint_of([&] { read_facet_list(file, 12); });
}

TEST(FacetList, HasCommentsEmptyLinesAndAnyOrder)
{
    const TemporaryFolder folder;
    const auto file = folder.put("list.txt", "# bottom\n11\n\n 3 # edge\r\n\t0\n7");
    EXPECT_THAT(read_facet_list(file, 12), ElementsAre(0, 3, 7, 11));
}

TEST(FacetList, IsRefusedWithFileAndLine)
{
    EXPECT_THAT(facet_list_complaint("0\n12\n"),
                AllOf(HasSubstr("E_FACET"), HasSubstr("list.txt:2: \"12\""),
                      HasSubstr("from 0 to 11")));
    EXPECT_THAT(facet_list_complaint("4\n#\n4\n"),
                AllOf(HasSubstr("list.txt:3: \"4\""), HasSubstr("line 1")));
    for (const char* word : {"-1", "1.5", "x", "1 2", "1,2", "99999999999999999999"})
        EXPECT_THAT(facet_list_complaint(std::string{"0\n"} + word),
                    AllOf(HasSubstr("list.txt:2: \""), HasSubstr("facet number")))
            << word;
    EXPECT_THAT(facet_list_complaint("# nothing\n"), HasSubstr("E_EMPTY"));
    EXPECT_THAT(complaint_of([] { read_facet_list("missing.txt", 12); }),
                HasSubstr("E_OPEN"));
}

std::string directions_complaint(const std::string& summary)
{
    const TemporaryFolder folder;
    const auto file = folder.put("summary.json", summary);
    return complaint_of([&] { read_setup_directions(file); });
}

TEST(SetupDirections, AreTheToolAxesOfTheSetups)
{
    const TemporaryFolder folder;
    const auto several = folder.put("several.json", R"({"configuration": "W/xyBz/T",
        "tool_axis": [0, 0, 1], "setups": [{"tool_axis": [0.6, 0, 0.8]},
                                           {"tool_axis": [0, -1, 0]}]})");
    const SetupDirections directions = read_setup_directions(several);
    EXPECT_EQ(directions.machine, "W/xyBz/T");
    ASSERT_EQ(directions.axes.size(), 2U);
    EXPECT_LT((directions.axes[0] - Vec3{0.6, 0, 0.8}).norm(), 1e-15);
    EXPECT_LT((directions.axes[1] - Vec3{0, -1, 0}).norm(), 1e-15);
    const auto one =
        folder.put("one.json", R"({"setups": null, "tool_axis": [0.0, 0.0, 1.0]})");
    EXPECT_EQ(read_setup_directions(one).axes.size(), 1U);
    EXPECT_EQ(read_setup_directions(one).machine, "");
}

TEST(SetupDirections, AreRefusedWithTheKey)
{
    EXPECT_THAT(directions_complaint("{}"), HasSubstr("no setup"));
    EXPECT_THAT(directions_complaint(R"({"setups": []})"), HasSubstr("no setup"));
    EXPECT_THAT(directions_complaint(R"({"setups": [{}]})"), HasSubstr("tool_axis"));
    EXPECT_THAT(directions_complaint(R"({"setups": [{"tool_axis": [0, 0]}]})"),
                HasSubstr("/setups/0/tool_axis"));
    EXPECT_THAT(directions_complaint(R"({"setups": [{"tool_axis": [0, 0, 2]}]})"),
                AllOf(HasSubstr("length 2"), HasSubstr("unit vector")));
}

TEST(SetupSubject, IsTheNamedPartWithItsFacets)
{
    const TemporaryFolder folder;
    const SetupSubject known = read_setup_subject(
        folder.put("a.json", R"({"name": "prism", "facets": 12, "setups": []})"));
    EXPECT_EQ(known.name, "prism");
    EXPECT_EQ(known.facets, 12U);
    const SetupSubject unknown = read_setup_subject(folder.put("b.json", "{}"));
    EXPECT_EQ(unknown.name, "");
    EXPECT_FALSE(unknown.facets);
    const auto bad = folder.put("c.json", R"({"facets": -3})");
    EXPECT_THROW(read_setup_subject(bad), FormatError);
}

}  // namespace
}  // namespace endmill
