// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/setup_rules.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

// The table of modes in docs/methods/five-axis-setup.md: `paper` corrects one misprint
// of `paper-literal`, and `corrected` drops every other restriction of the paper.
TEST(SetupRules, AreThoseOfTheTableOfModes)
{
    for (const SetupMode mode : {SetupMode::PaperLiteral, SetupMode::Paper,
                                 SetupMode::Corrected, SetupMode::WholeCones}) {
        const SetupRules& rules = setup_rules(mode);
        const bool is_printed =
            mode == SetupMode::PaperLiteral || mode == SetupMode::Paper;
        EXPECT_EQ(rules.mode, mode);
        EXPECT_EQ(rules.takes_hull_vertices_only, mode == SetupMode::PaperLiteral);
        EXPECT_EQ(rules.has_wide_sectors, !is_printed);
        EXPECT_EQ(rules.has_both_hulls, !is_printed);
        EXPECT_EQ(rules.takes_low_directions, !is_printed);
        EXPECT_EQ(rules.has_signed_limits, !is_printed);
    }
}

}  // namespace
}  // namespace endmill
