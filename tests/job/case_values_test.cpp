// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/case_values.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/text.h"
#include "endmill/job/child_process.h"
#include "endmill/job/detail/drawn_fraction.h"
#include "some_program.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const CaseCommand& plan_command()
{
    static const CaseCommand command{some_program(), "plan", "/nowhere/plan.json"};
    return command;
}

CaseGrid grid(const std::string& text)
{
    const JsonDocument document{text, "f"};
    const JsonValue root = document.root();
    return {root, plan_command()};
}

CaseSamples samples(const std::string& text)
{
    const JsonDocument document{text, "f"};
    const JsonValue root = document.root();
    return {root, plan_command()};
}

CaseList list(const std::string& text)
{
    return {text, "f.csv", plan_command()};
}

template <class Make>
std::string complaint(const Make& make, const std::string& text)
{
    return error_of([&] { make(text); });
}

std::vector<std::vector<std::string>> all_of(const auto& cases)
{
    std::vector<std::vector<std::string>> all;
    for (std::uint64_t i = 0; i < cases.count(); ++i)
        all.push_back(cases.values(i));
    return all;
}

TEST(CaseGrid, VariesTheLastAxisFastest)
{
    const CaseGrid cases = grid(R"([{"scallop": [1, 2]}, {"cutter": ["a", "b", "c"]}])");
    EXPECT_THAT(cases.keys(), ElementsAre("scallop", "cutter"));
    EXPECT_THAT(all_of(cases), ElementsAre(ElementsAre("1", "a"), ElementsAre("1", "b"),
                                           ElementsAre("1", "c"), ElementsAre("2", "a"),
                                           ElementsAre("2", "b"), ElementsAre("2", "c")));
}

TEST(CaseGrid, VariesTheKeysOfAnAxisTogether)
{
    const CaseGrid cases =
        grid(R"([{"scallop": [1, 2], "cutter": ["a", "b"]}, {"arcs": [true, false]}])");
    EXPECT_THAT(cases.keys(), ElementsAre("cutter", "scallop", "arcs"));
    EXPECT_THAT(
        all_of(cases),
        ElementsAre(ElementsAre("a", "1", "true"), ElementsAre("a", "1", "false"),
                    ElementsAre("b", "2", "true"), ElementsAre("b", "2", "false")));
}

TEST(CaseGrid, RefusesWhatIsNoGrid)
{
    EXPECT_THAT(complaint(grid, R"([{"scallop": [1, 2], "cutter": ["a"]}])"),
                HasSubstr("f:/0/scallop: 2 values; expected 1 as for the other keys"));
    EXPECT_THAT(complaint(grid, "[]"), HasSubstr("f: an empty array; expected"));
    EXPECT_THAT(complaint(grid, "[{}]"), HasSubstr("f:/0: an object without keys"));
    EXPECT_THAT(complaint(grid, R"([{"scallop": []}])"),
                HasSubstr("f:/0/scallop: an empty"));
    EXPECT_THAT(complaint(grid, R"([{"scallop": [1]}, {"scallop": [1]}])"),
                HasSubstr("f:/1/scallop: key \"scallop\" occurs twice"));
    EXPECT_THAT(complaint(grid, R"([{"scalop": [1]}])"),
                HasSubstr("f:/0/scalop: unknown key \"scalop\"; expected"));
    EXPECT_THAT(complaint(grid, R"([{"arcs": [true, 1]}])"),
                HasSubstr("f:/0/arcs/1: found 1; expected true or false"));
    EXPECT_THAT(
        complaint(grid, R"([{"tool_file": ["x.json"]}])"),
        HasSubstr("f:/0/tool_file/0: found /nowhere/x.json, which does not exist"));
}

TEST(CaseGrid, StatesTheNumberOfTooManyCases)
{
    std::string values;
    for (int i = 0; i < 4000; ++i)
        values += (i == 0 ? "" : ",") + std::to_string(i);
    EXPECT_THAT(complaint(grid, R"([{"scallop": [)" + values + R"(]}, {"cutter": [)" +
                                    values + "]}]"),
                HasSubstr("f: a grid of 16000000 cases; expected at most 10000000"));
}

TEST(CaseList, HasACaseInEachRow)
{
    const CaseList cases =
        list("\xef\xbb\xbfscallop,cutter\r\n0.1,\"a, b\"\r\n,ball:3\n0.30,x");
    EXPECT_THAT(cases.keys(), ElementsAre("scallop", "cutter"));
    EXPECT_THAT(all_of(cases),
                ElementsAre(ElementsAre("0.1", "a, b"), ElementsAre("", "ball:3"),
                            ElementsAre("0.30", "x")));
}

TEST(CaseList, RefusesWhatIsNoList)
{
    EXPECT_THAT(complaint(list, ""), HasSubstr("f.csv"));
    EXPECT_THAT(complaint(list, "scallop\n"), HasSubstr("no row after the header"));
    EXPECT_THAT(complaint(list, "scallop,scallop\n1,2\n"),
                HasSubstr("f.csv:1: key \"scallop\" occurs twice"));
    EXPECT_THAT(complaint(list, "scalop\n1\n"),
                HasSubstr("f.csv:1: unknown key \"scalop\"; expected"));
    EXPECT_THAT(complaint(list, "scallop,cutter\n1\n"),
                HasSubstr("f.csv:2: 1 cell; expected 2 as in the header"));
    EXPECT_THAT(complaint(list, "scallop\n1\n\n2\n"),
                HasSubstr("f.csv:3: an empty line; expected a value"));
    EXPECT_THAT(complaint(list, "arcs,scallop\ntrue,1\nyes,2\n"),
                HasSubstr("f.csv:3: found yes; expected true or false"));
    EXPECT_THAT(complaint(list, "input,scallop\n,1\n"),
                HasSubstr("f.csv:2: found an empty cell under input"));
    EXPECT_THAT(complaint(list, "cutter\na\x01\n"), HasSubstr("a control character"));
}

// The documented rule, computed here by the standard library's power.
TEST(CaseSamples, FollowTheDocumentedRule)
{
    const CaseSamples cases = samples(R"({"count": 500, "seed": 11, "parameters": {
        "scallop": {"from": 0.01, "to": 0.5, "scale": "log"},
        "chord_tolerance": {"from": -1, "to": 3},
        "max_memory": {"from": 1, "to": 6, "whole": true},
        "cutter": {"one_of": ["a", "b", "c"]}}})");
    EXPECT_THAT(cases.keys(),
                ElementsAre("chord_tolerance", "cutter", "max_memory", "scallop"));
    for (std::uint64_t i = 0; i < cases.count(); ++i) {
        const auto values = cases.values(i);
        const auto share = [&](const char* key) { return drawn_fraction(11, key, i); };
        EXPECT_EQ(values[0], to_text(-1 + 4 * share("chord_tolerance")));
        EXPECT_EQ(values[1],
                  std::string(1, "abc"[static_cast<int>(3 * share("cutter"))]));
        EXPECT_EQ(values[2],
                  std::to_string(1 + static_cast<int>(6 * share("max_memory"))));
        EXPECT_NEAR(number_from_text(values[3]).value(),
                    0.01 * std::pow(50, share("scallop")), 1e-13);
    }
}

TEST(CaseSamples, OfAKeyDoNotDependOnOtherKeysAndTheCount)
{
    const CaseSamples one = samples(
        R"({"count": 1, "seed": 1, "parameters": {"scallop": {"from": 0, "to": 1}}})");
    const CaseSamples two = samples(R"({"count": 9, "seed": 1, "parameters": {
        "cutter": {"one_of": ["a"]}, "scallop": {"from": 0, "to": 1}}})");
    EXPECT_EQ(one.values(0)[0], two.values(0)[1]);
}

TEST(CaseSamples, RefuseRangesThatAreNone)
{
    const auto range = [](const std::string& text) {
        return complaint(
            samples,
            R"({"count": 1, "seed": 1, "parameters": {"scallop": )" + text + "}}");
    };
    EXPECT_EQ(range(R"({"from": 2, "to": 2})"), "accepted");
    EXPECT_THAT(range(R"({"from": 2, "to": 1})"),
                HasSubstr("f:/parameters/scallop/to: 1; expected a number from 2 on"));
    EXPECT_THAT(range(R"({"from": -1e308, "to": 1e308})"),
                HasSubstr("expected a number"));
    EXPECT_THAT(range(R"({"from": 0, "to": 1, "scale": "log"})"),
                HasSubstr("f:/parameters/scallop/from: 0; expected a number above 0"));
    EXPECT_THAT(range(R"({"from": 0.5, "to": 1, "whole": true})"),
                HasSubstr("0.5; expected a whole number"));
    EXPECT_THAT(range(R"({"from": 1, "to": 2, "scale": "lin"})"),
                HasSubstr("\"linear\""));
    EXPECT_THAT(range(R"({"from": 1, "to": 2, "step": 1})"), HasSubstr("unknown key"));
    EXPECT_THAT(range(R"({"one_of": [1], "from": 1})"), HasSubstr("unknown key"));
    EXPECT_THAT(range(R"({"one_of": []})"), HasSubstr("an empty array"));
    EXPECT_THAT(complaint(samples, R"({"count": 0, "seed": 1, "parameters": {}})"),
                HasSubstr("expected a whole number from 1 to 10000000"));
    EXPECT_THAT(complaint(samples, R"({"count": 1, "seed": 1, "parameters": {}})"),
                HasSubstr("an object without keys"));
    EXPECT_THAT(complaint(samples, R"({"count": 1, "seed": 1, "parameters":
                                       {"arcs": {"from": 0, "to": 1}}})"),
                HasSubstr("a range of numbers; expected one_of"));
}

}  // namespace
}  // namespace endmill
