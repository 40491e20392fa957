// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/error.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

template <class Kind>
void expect_kind(const char* code)
{
    try {
        throw Kind{"what happened"};
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code);
        EXPECT_STREQ(error.what(), "what happened");
        EXPECT_NE(dynamic_cast<const Kind*>(&error), nullptr);
    }
}

TEST(Error, OfEveryKindHasItsCodeAndKeepsItsMessage)
{
    expect_kind<DomainError>("E_PARAM");
    expect_kind<GeometryError>("E_GEOMETRY");
    expect_kind<OutputError>("E_OUTPUT");
    expect_kind<LimitError>("E_LIMIT");
}

TEST(Error, IsCaughtAsARuntimeError)
{
    EXPECT_THROW(throw GeometryError{"x"}, std::runtime_error);
}

TEST(FormatError, NamesFilePlaceFoundAndExpected)
{
    const FormatError error{"E_JSON", {"part.json", "3:7", "a comma", "a number"}};
    EXPECT_STREQ(error.what(), "part.json:3:7: a comma; expected a number");
    EXPECT_EQ(error.code(), "E_JSON");
    EXPECT_EQ(error.file(), "part.json");
    EXPECT_EQ(error.place(), "3:7");
}

TEST(FormatError, NamesAByteOfABinaryFile)
{
    const FormatError error{"E_STL_SIZE", {"part.stl", "@80", "too short", "more"}};
    EXPECT_STREQ(error.what(), "part.stl@80: too short; expected more");
    EXPECT_EQ(error.place(), "@80");
}

TEST(FormatError, LeavesOutUnknownParts)
{
    EXPECT_STREQ((FormatError{"E_FILE", {"part.json", "", "it is empty", ""}}.what()),
                 "part.json: it is empty");
    EXPECT_STREQ((FormatError{"E_FILE", {"a b", "/x/0", "null", ""}}.what()),
                 "a b:/x/0: null");
}

TEST(Require, ThrowsOnlyWhereItDoesNotHold)
{
    EXPECT_NO_THROW(require(true, "f: need x"));
    try {
        require(false, "f: need x");
        FAIL() << "expected a DomainError";
    } catch (const DomainError& error) {
        EXPECT_STREQ(error.what(), "f: need x");
    }
}

}  // namespace
}  // namespace endmill
