// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/verification_result.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

const DeviationLimits limits{0.01, 0.1};

// A verification without any violation. Each test below changes one finding.
Verification clean_verification()
{
    return {.on_part = PartFindings{.limits = limits,
                                    .deviation = {},
                                    .collisions = {.bound_mm = part_contact_slack}},
            .removal = {},
            .contacts = {},
            .rest = block_stock({{0, 0, 0}, {1, 1, 1}}, 1),
            .verdict = Verdict::Clean};
}

TEST(VerdictWithContacts, IsThatOfTheDeviationIfNothingTouches)
{
    Verification found = clean_verification();
    EXPECT_EQ(verdict_with_contacts(found), Verdict::Clean);
    found.on_part->deviation.max_scallop_mm = 0.2;
    EXPECT_EQ(verdict_with_contacts(found), Verdict::Uncut);
}

TEST(VerdictWithContacts, IsNotJudgedWithoutAPart)
{
    Verification found = clean_verification();
    found.on_part.reset();
    EXPECT_EQ(verdict_with_contacts(found), Verdict::NotJudged);
    found.contacts.rapid_cuts.count = 1;
    EXPECT_EQ(verdict_with_contacts(found), Verdict::Collides);
    EXPECT_EQ(verdict_name(Verdict::Collides), "collides");
}

TEST(VerdictWithContacts, IsGougedForEveryKindOfContact)
{
    Verification rapid = clean_verification();
    rapid.contacts.rapid_cuts.count = 1;
    Verification collision = clean_verification();
    collision.contacts.collisions.count = 1;
    Verification in_part = clean_verification();
    in_part.on_part->collisions.moves.count = 1;
    for (const Verification* found : {&rapid, &collision, &in_part})
        EXPECT_EQ(verdict_with_contacts(*found), Verdict::Gouged);
}

// A possible gouge takes precedence over uncut material, but not over a measured gouge.
TEST(VerdictWithContacts, IsUndecidedWhereABoundAllowsAContactOrAGouge)
{
    Verification near_part = clean_verification();
    near_part.on_part->collisions.bound_mm = 2 * closed_contact_bound;
    Verification earlier = clean_verification();
    earlier.on_part->earlier_gouge = EarlierGouge{.found_mm = 0.005, .bound_mm = 0.007};
    for (Verification* found : {&near_part, &earlier}) {
        EXPECT_EQ(verdict_with_contacts(*found), Verdict::Undecided);
        found->on_part->deviation.max_scallop_mm = 0.2;
        EXPECT_EQ(verdict_with_contacts(*found), Verdict::Undecided);
        found->on_part->deviation.max_gouge_mm = 0.02;
        EXPECT_EQ(verdict_with_contacts(*found), Verdict::Gouged);
    }
}

TEST(MayBeInPart, IsWhatTheBoundAllowsBeyondRounding)
{
    EXPECT_FALSE(may_be_in_part({.bound_mm = 2 * part_contact_slack}));
    EXPECT_TRUE(may_be_in_part({.bound_mm = 2.1 * part_contact_slack}));
}

// The slack of 0.001 mm also applies to the gouge of an earlier run.
TEST(VerdictWithContacts, IsCleanWhereTheBoundStaysWithinTheSlack)
{
    Verification found = clean_verification();
    found.on_part->earlier_gouge = EarlierGouge{.found_mm = 0.004, .bound_mm = 0.0069};
    found.on_part->collisions.bound_mm = closed_contact_bound;
    EXPECT_EQ(verdict_with_contacts(found), Verdict::Clean);
}

}  // namespace
}  // namespace endmill
