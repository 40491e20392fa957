// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>

namespace endmill {

/// Four points and two faces among other properties and elements.
inline const std::string ply_header_without_format =
    "comment made by a test\n"
    "element camera 1\n"
    "property float fov\n"
    "element vertex 4\n"
    "property uchar red\n"
    "property double z\n"
    "property list uchar short rings\n"
    "property float x\n"
    "property short y\n"
    "element face 2\n"
    "property list uchar int vertex_indices\n"
    "property float quality\n"
    "element edge 1\n"
    "property int vertex1\n"
    "end_header\n";

inline const std::string ascii_ply = "ply\nformat ascii 1.0\n" +
                                     ply_header_without_format +
                                     "45.5\n"
                                     "255 0 0 0 0\n"
                                     "255 0 2 -7 9 1.5 0\n"
                                     "255 0 1 8 1.5 1\n"
                                     "255 0.5 0 0 1\n"
                                     "3 0 1 2 0.9\n"
                                     "3 0 2 3 0.8\n"
                                     "7\n";

/// Appends the bytes of `number`, in reverse order if `is_big_endian`.
template <class Number>
void append_number(std::string& text, Number number, bool is_big_endian)
{
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (is_big_endian)
        std::ranges::reverse(bytes);
    text.append(bytes.data(), bytes.size());
}

/// The items of `ascii_ply` in binary.
inline std::string binary_ply(bool is_big_endian)
{
    std::string text = "ply\nformat binary_";
    text += is_big_endian ? "big" : "little";
    text += "_endian 1.0\n" + ply_header_without_format;
    const auto append = [&](auto number) { append_number(text, number, is_big_endian); };
    const auto append_point = [&](float x, std::int16_t y, double z, std::uint8_t rings) {
        append(std::uint8_t{255});
        append(z);
        append(rings);
        for (int i = 0; i < rings; ++i)
            append(std::int16_t{-7});
        append(x);
        append(y);
    };
    const auto append_face = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
        append(std::uint8_t{3});
        append(a);
        append(b);
        append(c);
        append(0.9F);
    };
    append(45.5F);
    append_point(0, 0, 0, 0);
    append_point(1.5F, 0, 0, 2);
    append_point(1.5F, 1, 0, 1);
    append_point(0, 1, 0.5, 0);
    append_face(0, 1, 2);
    append_face(0, 2, 3);
    append(std::int32_t{7});
    return text;
}

}  // namespace endmill
