// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/file_format.h"

#include <string>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// First lines as printed in the documents of the formats.
TEST(RecognizedFormat, RecognisesTheBeginningsOfTheUsualFiles)
{
    EXPECT_EQ(recognized_format("solid cube\n facet normal 0 0 1\n"), "STL");
    EXPECT_EQ(recognized_format("# Blender\nmtllib a.mtl\n"), "OBJ");
    EXPECT_EQ(recognized_format("\n# made by hand\r\n\r\nv 0 0 1\n"), "OBJ");
    EXPECT_EQ(recognized_format("OFF\n8 6 12\n"), "OFF");
    EXPECT_EQ(recognized_format("ply\nformat ascii 1.0\n"), "PLY");
    EXPECT_EQ(recognized_format("ISO-10303-21;\nHEADER;"), "STEP");
    EXPECT_EQ(recognized_format("# vtk DataFile Version 3.0\n"), "VTK");
    EXPECT_EQ(recognized_format("<?xml version=\"1.0\"?>"), "XML");
    EXPECT_EQ(recognized_format("%\nO1000\n"), "G-code");
    EXPECT_EQ(recognized_format("\xff\xfe{\0"), "UTF-16 text");
    EXPECT_EQ(recognized_format("\xef\xbb\xbf \n{}"), "JSON");
    EXPECT_EQ(recognized_format("[]"), "JSON");
}

TEST(RecognizedFormat, RecognisesABinaryStlByItsSize)
{
    std::string stl = "{\"format\": " + std::string(68, ' ');
    stl.resize(80, ' ');
    stl += std::string{"\x03\0\0\0", 4} + std::string(3 * 50, 'x');
    EXPECT_EQ(recognized_format(stl), "STL");
    stl += 'x';
    EXPECT_EQ(recognized_format(stl), "JSON");
}

TEST(RecognizedFormat, IsEmptyForUnknownContent)
{
    EXPECT_EQ(recognized_format("hello"), std::nullopt);
    EXPECT_EQ(recognized_format(""), std::nullopt);
    EXPECT_EQ(recognized_format("# only a comment"), std::nullopt);
}

}  // namespace
}  // namespace endmill
