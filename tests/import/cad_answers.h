// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace endmill::test {

/// Bytes of numbers as an answer of endmill-cad has them.
template <typename Number>
std::string bytes_of(const std::vector<Number>& numbers)
{
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    if (!numbers.empty())
        std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

/// An answer of endmill-cad with this head, and these bytes after it.
inline std::string cad_answer(const std::string& head, const std::string& arrays)
{
    return "endmill-cad/1\n" + bytes_of<std::uint64_t>({head.size()}) + head + arrays;
}

/// The head of a square of two faces, each a triangle; the first face is a bilinear spline.
inline const std::string square_head =
    R"({"unit": "INCH", "sewn": false, "lost_faces": 0, "solids": 0, "shells": 1, "points": 4, "triangles": 2,
        "unmeshed": [], "measures": {"face_areas_mm2": [2, 2],
        "trimmed_balls_mm": [[], [0, 7.5]], "area_mm2": 4,
        "centre_mm": [1, 1, 0]}, "faces": [
        {"kind": "nurbs", "trimmed": false, "reversed": false, "name": "floor",
         "colour": "#ff8000", "surface": {"degree_u": 1, "degree_v": 1, "points_u": 2,
         "points_v": 2, "rational": true}},
        {"kind": "plane", "trimmed": true, "reversed": true}]})";

/// Its numbers.
struct SquareArrays {
    std::vector<double> points{0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0};
    std::vector<std::int32_t> corners{0, 1, 2, 0, 2, 3};
    std::vector<std::int32_t> faces{0, 1};
    std::vector<double> knots{0, 0, 1, 1, 0, 0, 1, 1};
    std::vector<double> control_points{0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0};
    std::vector<double> weights{1, 1, 1, 1};

    std::string bytes() const
    {
        return bytes_of(points) + bytes_of(corners) + bytes_of(faces) + bytes_of(knots) +
               bytes_of(control_points) + bytes_of(weights);
    }
};

inline std::string square_answer()
{
    return cad_answer(square_head, SquareArrays{}.bytes());
}

}  // namespace endmill::test
