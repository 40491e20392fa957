// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/milling_data.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "milling_examples.h"

namespace endmill {
namespace {

using test::steel;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(CuttingMaterial, SteelIsSound)
{
    EXPECT_NO_THROW(require_sound(steel()));
}

TEST(CuttingMaterial, MayHaveNoForceOfTheEdgeAndNoLimitsOfFeed)
{
    CuttingMaterial material = steel();
    material.edge_thickness_mm = 0;
    material.r1 = material.r2 = material.r3 = material.r4 = 0;
    material.max_feed_per_tooth_mm = material.min_feed_per_tooth_mm = std::nullopt;
    EXPECT_NO_THROW(require_sound(material));
}

TEST(CuttingMaterial, RefusesImpossibleConstants)
{
    for (double CuttingMaterial::*const member :
         {&CuttingMaterial::specific_resistance_n_per_mm2,
          &CuttingMaterial::edge_thickness_mm, &CuttingMaterial::r1, &CuttingMaterial::r2,
          &CuttingMaterial::r3, &CuttingMaterial::r4, &CuttingMaterial::alpha,
          &CuttingMaterial::v1_m_per_min})
        for (const double value : {-1e-9, nan, infinity, -infinity}) {
            CuttingMaterial material = steel();
            material.*member = value;
            EXPECT_THROW(require_sound(material), DomainError);
        }
    for (double CuttingMaterial::*const member :
         {&CuttingMaterial::specific_resistance_n_per_mm2, &CuttingMaterial::alpha,
          &CuttingMaterial::v1_m_per_min}) {
        CuttingMaterial material = steel();
        material.*member = 0;
        EXPECT_THROW(require_sound(material), DomainError);
    }
    CuttingMaterial material = steel();
    material.alpha = 1;
    EXPECT_THROW(require_sound(material), DomainError);
}

TEST(CuttingMaterial, RefusesALargestFeedBelowTheLeast)
{
    CuttingMaterial material = steel();
    material.min_feed_per_tooth_mm = material.max_feed_per_tooth_mm;
    EXPECT_NO_THROW(require_sound(material));
    material.min_feed_per_tooth_mm = 2 * *material.max_feed_per_tooth_mm;
    EXPECT_THROW(require_sound(material), DomainError);
    material = steel();
    for (const double feed : {0.0, -1.0, nan, infinity}) {
        material.max_feed_per_tooth_mm = feed;
        EXPECT_THROW(require_sound(material), DomainError);
    }
}

}  // namespace
}  // namespace endmill
