// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::HasSubstr;

const std::string whole = R"({"format": "endmill-material/1", "name": "steel",
 "specific_resistance_n_per_mm2": 2000.557, "edge_thickness_mm": 0.016,
 "r1": 0.41, "r2": 0.42, "r3": 0.2, "r4": 0.6, "alpha": 0.3680141,
 "v1_m_per_min": 28.4313, "max_feed_per_tooth_mm": 0.15,
 "min_feed_per_tooth_mm": 0.005, "source": "a test"})";

TEST(MaterialFile, HoldsAMaterial)
{
    const CuttingMaterial material = parse_material(whole, "m.json");
    EXPECT_EQ(material.specific_resistance_n_per_mm2, 2000.557);
    EXPECT_EQ(material.edge_thickness_mm, 0.016);
    EXPECT_EQ(material.r1, 0.41);
    EXPECT_EQ(material.r2, 0.42);
    EXPECT_EQ(material.r3, 0.2);
    EXPECT_EQ(material.r4, 0.6);
    EXPECT_EQ(material.alpha, 0.3680141);
    EXPECT_EQ(material.v1_m_per_min, 28.4313);
    EXPECT_EQ(material.max_feed_per_tooth_mm, 0.15);
    EXPECT_EQ(material.min_feed_per_tooth_mm, 0.005);
    EXPECT_EQ(material.name, "steel");
    EXPECT_EQ(material.source, "a test");
    EXPECT_NO_THROW(require_sound(material));
}

TEST(MaterialFile, NeedsNoFeedsAndNoWords)
{
    const std::string text = R"({"format": "endmill-material/1",
 "specific_resistance_n_per_mm2": 700, "edge_thickness_mm": 0,
 "r1": 0, "r2": 0, "r3": 0, "r4": 0, "alpha": 0.2, "v1_m_per_min": 200})";
    const CuttingMaterial material = parse_material(text, "folder/m.json");
    EXPECT_FALSE(material.max_feed_per_tooth_mm || material.min_feed_per_tooth_mm);
    EXPECT_EQ(material.name, "m");
    EXPECT_EQ(material.source, "");
}

struct Fault {
    std::string from;
    std::string to;
    std::string complaint;
};

class MaterialFileWith : public testing::TestWithParam<Fault> {};

TEST_P(MaterialFileWith, IsRefusedWithThePlace)
{
    const Fault& fault = GetParam();
    const std::string text = replaced(whole, fault.from, fault.to);
    ASSERT_FALSE(text.empty());
    EXPECT_THAT(complaint_of([&] { parse_material(text, "m.json"); }),
                HasSubstr(fault.complaint));
}

INSTANTIATE_TEST_SUITE_P(
    AFault, MaterialFileWith,
    testing::Values(
        Fault{"material/1", "material/2", "made by a newer version"},
        Fault{"material/1", "tool/1", "E_FORMAT"},
        Fault{"2000.557", "-2000", "E_MATERIAL m.json:/specific_resistance_n_per_mm2"},
        Fault{"2000.557", "0", "E_MATERIAL m.json:/specific_resistance_n_per_mm2"},
        Fault{"2000.557", "\"2000\"", "E_JSON m.json:/specific_resistance_n_per_mm2"},
        Fault{"2000.557", "NaN", "E_JSON"}, Fault{"2000.557", "1e999", "E_JSON"},
        Fault{"0.016", "-0.016", "E_MATERIAL m.json:/edge_thickness_mm"},
        Fault{"0.41", "-0.41", "E_MATERIAL m.json:/r1"},
        Fault{"0.42", "-1", "E_MATERIAL m.json:/r2"},
        Fault{"\"r3\": 0.2", "\"r3\": -1", "E_MATERIAL m.json:/r3"},
        Fault{"\"r4\": 0.6", "\"r4\": -1", "E_MATERIAL m.json:/r4"},
        Fault{"\"r4\": 0.6,", "", "key \"r4\" is missing"},
        Fault{"0.3680141", "1", "E_MATERIAL m.json:/alpha"},
        Fault{"0.3680141", "0", "E_MATERIAL m.json:/alpha"},
        Fault{"28.4313", "0", "E_MATERIAL m.json:/v1_m_per_min"},
        Fault{"0.15", "0.004",
              "E_MATERIAL m.json:/max_feed_per_tooth_mm: 0.004; expected at least "
              "min_feed_per_tooth_mm, 0.005"},
        Fault{"0.15", "0", "E_MATERIAL m.json:/max_feed_per_tooth_mm"},
        Fault{"0.005", "-1", "E_MATERIAL m.json:/min_feed_per_tooth_mm"},
        Fault{"\"r1\"", "\"r_1\"", "did you mean \"r1\"?"},
        Fault{"\"alpha\"", "\"alhpa\"", "m.json:/alhpa: unknown key"},
        Fault{"\"r2\"", "\"r1\"", "E_JSON"},
        Fault{"{\"format\"", "solid {\"format\"", "E_FORMAT"}));

TEST(MaterialFile, TheExamplesAreRead)
{
    const std::string folder = std::string{ENDMILL_SOURCE_DIR} + "/datasets/materials/";
    for (const std::string name : {"steel.json", "aluminium.json"}) {
        const CuttingMaterial material = read_material(folder + name);
        EXPECT_NO_THROW(require_sound(material));
        EXPECT_THAT(material.source, HasSubstr("not measured"));
    }
    // docs/methods/ball-end-milling.md, section 8: 204 and 99.55 kgf/mm^2.
    EXPECT_NEAR(read_material(folder + "steel.json").specific_resistance_n_per_mm2,
                204 * 9.80665, 1e-9);
    EXPECT_NEAR(read_material(folder + "aluminium.json").specific_resistance_n_per_mm2,
                99.55 * 9.80665, 1e-9);
    EXPECT_THAT(complaint_of([] { read_material("no such material.json"); }),
                HasSubstr("E_OPEN"));
}

}  // namespace
}  // namespace endmill
