// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/control_net.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::StartsWith;
using testing::ThrowsMessage;

// Calls `read(root, rule)` on a document in inches, with a limit of 100 mm.
template <class Read>
auto read_text(std::string_view text, const Read& read)
{
    const JsonDocument document{text, "f.json"};
    const JsonValue root = document.root();
    return read(root, LengthRule{.mm_per_unit = 25.4, .max_extent_mm = 100});
}

ControlNet net_of(std::string_view text, const std::optional<ExpectedCount>& columns = {},
                  const std::optional<ExpectedCount>& rows = {})
{
    return read_text(text, [&](const JsonValue& root, const LengthRule& rule) {
        return read_net(root, rule, columns, rows);
    });
}

TEST(ControlNet, HoldsItsPointsInMmRowByRow)
{
    const ControlNet net = net_of("[[[1, 0, 0], [2, 0, 0]], [[1, 1, 0], [2, 1, 3]]]");
    EXPECT_EQ(net.columns, 2U);
    EXPECT_EQ(net.rows, 2U);
    ASSERT_EQ(net.points.size(), 4U);
    EXPECT_EQ(net.points[1], Vec3(50.8, 0, 0));
    EXPECT_EQ(net.points[2], Vec3(25.4, 25.4, 0));
}

TEST(ControlNet, RefusesOtherCountsThanAskedFor)
{
    const std::string_view two = "[[[1, 0, 0], [2, 0, 0]]]";
    EXPECT_THAT(
        [&] {
            net_of(two, ExpectedCount{3, "why"});
        },
        ThrowsMessage<FormatError>(
            StartsWith("f.json:/0: row has 2 points; expected 3 (why)")));
    EXPECT_THAT(
        [&] {
            net_of(two, {}, ExpectedCount{2, "why"});
        },
        ThrowsMessage<FormatError>(
            StartsWith("f.json: net has 1 row; expected 2 (why)")));
}

TEST(ControlNet, LengthsAreConvertedBeforeTheyAreMeasured)
{
    const auto lengths = [](std::string_view text) {
        return read_text(text, [](const JsonValue& root, const LengthRule& rule) {
            return read_lengths(root, rule);
        });
    };
    EXPECT_THAT(lengths("[1, -3.5]"), ElementsAre(25.4, -3.5 * 25.4));
    EXPECT_THAT(
        [&] { lengths("[1, 4]"); },
        ThrowsMessage<FormatError>(StartsWith(
            "f.json:/1: coordinate 4 (101.6 mm); expected at most 100 mm (--max-")));
}

TEST(ControlNet, WeightsHaveNoUnit)
{
    const auto weights =
        read_text("[[1, 2], [0.5, 4]]", [](const JsonValue& root, const auto&) {
            return read_weights(root, {2, "columns"}, {2, "rows"});
        });
    EXPECT_THAT(weights, ElementsAre(0.25, 0.5, 0.125, 1)) << "in ratio";
}

}  // namespace
}  // namespace endmill
