// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/offset_contact.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(OffsetContact, KeepsItsMembers)
{
    const OffsetContact contact{{0.25, 0.75}, Vec3::UnitZ(), 3, ContactKind::Border};
    EXPECT_EQ(contact.at.u, 0.25);
    EXPECT_EQ(contact.at.v, 0.75);
    EXPECT_EQ(contact.normal, Vec3::UnitZ());
    EXPECT_EQ(contact.surface, 3);
    EXPECT_EQ(contact.kind, ContactKind::Border);
}

}  // namespace
}  // namespace endmill
