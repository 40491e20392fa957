// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/appended_arrays.h"

#include <gtest/gtest.h>

#include "small_xml.h"

namespace endmill {
namespace {

// The offset of an array is the size of everything before it: sizes of 8 bytes, and
// numbers.
TEST(AppendedArrays, StandBehindEachOther)
{
    AppendedArrays arrays;
    const auto first =
        SmallXml::parse(arrays.append("a", 3, std::vector<float>{1, 2, 3}).substr(4));
    const auto second =
        SmallXml::parse(arrays.append("b", 1, std::vector<double>{}).substr(4));
    const auto third =
        SmallXml::parse(arrays.append("c", 1, std::vector<std::uint8_t>{7}).substr(4));
    EXPECT_EQ(first[0].attributes.at("type"), "Float32");
    EXPECT_EQ(first[0].attributes.at("NumberOfComponents"), "3");
    EXPECT_EQ(first[0].attributes.at("offset"), "0");
    EXPECT_EQ(second[0].attributes.at("offset"), "20");
    EXPECT_EQ(third[0].attributes.at("offset"), "28");
    EXPECT_EQ(arrays.bytes(), std::string("\x0c\0\0\0\0\0\0\0"
                                          "\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40"
                                          "\0\0\0\0\0\0\0\0"
                                          "\x01\0\0\0\0\0\0\0\x07",
                                          37));
}

}  // namespace
}  // namespace endmill
