// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "endmill/offset/section_curve.h"

// The small curves of datasets/offset-curves/vectors.json with their exact results.
namespace endmill::test {

/// The result of a method for a curve.
struct ExpectedTrim {
    std::vector<SectionPoint> points;
    bool is_right;  ///< if false, it is a known failure of the method
};

/// A crossing of two segments of a curve.
struct ExpectedCrossing {
    int segment_a;
    int segment_b;
    SectionPoint at;
};

/// One of the curves.
struct TrimmingVector {
    std::string name;
    SectionCurve curve;
    std::vector<ExpectedCrossing> crossings;
    std::vector<SectionPoint> envelope;
    std::vector<SectionPoint> winding;
    ExpectedTrim literal;
    ExpectedTrim guarded;
    ExpectedTrim repaired;
};

/// The JSON file `name` of datasets/offset-curves.
inline nlohmann::json offset_curves_json(const std::string& name)
{
    std::ifstream file{std::string{ENDMILL_SOURCE_DIR} + "/datasets/offset-curves/" +
                       name};
    if (!file)
        throw std::runtime_error{"cannot read " + name};
    return nlohmann::json::parse(file);
}

/// A number, or a fraction in quotes.
inline double number_or_fraction(const nlohmann::json& value)
{
    if (value.is_number())
        return value.get<double>();
    const auto text = value.get<std::string>();
    return std::stod(text) / std::stod(text.substr(text.find('/') + 1));
}

inline std::vector<SectionPoint> section_points(const nlohmann::json& rows)
{
    std::vector<SectionPoint> points;
    for (const auto& row : rows)
        points.emplace_back(number_or_fraction(row[0]), number_or_fraction(row[1]));
    return points;
}

inline TrimmingVector trimming_vector(const nlohmann::json& json)
{
    TrimmingVector vector;
    vector.name = json["name"];
    vector.curve.points = section_points(json["points"]);
    vector.envelope = section_points(json["envelope"]);
    for (const auto& row : json["crossings"])
        vector.crossings.push_back(
            {row["segments"][0],
             row["segments"][1],
             {number_or_fraction(row["s"]), number_or_fraction(row["z"])}});
    const auto points = [&](const nlohmann::json& result) {
        if (result == "envelope")
            return vector.envelope;
        return result == "unchanged" ? vector.curve.points : section_points(result);
    };
    const auto trim = [&](const char* key) {
        return ExpectedTrim{points(json[key]["result"]), json[key]["right"]};
    };
    vector.winding = points(json["winding"]);
    vector.literal = trim("literal");
    vector.guarded = trim("guarded");
    vector.repaired = trim("3r");
    return vector;
}

inline std::vector<TrimmingVector> trimming_vectors()
{
    std::vector<TrimmingVector> vectors;
    const nlohmann::json json = offset_curves_json("vectors.json");
    for (const auto& row : json["vectors"])
        vectors.push_back(trimming_vector(row));
    return vectors;
}

}  // namespace endmill::test
