// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/files/csv.h"

namespace endmill {
namespace {

std::string csv_of(const VisibilityMap& map)
{
    std::string text;
    write_visibility_csv(map, [&](std::string_view piece) { text += piece; });
    return text;
}

TEST(WriteVisibilityCsv, HasZeroWhereAFacetIsAccessible)
{
    VisibilityMap map{3, 2};
    map.column(0)[0] = 0b001;
    map.column(1)[0] = 0b101;
    EXPECT_EQ(csv_of(map), "facet,cell_0,cell_1\n0,0,0\n1,1,1\n2,1,0\n");
    EXPECT_EQ(csv_of(VisibilityMap{0, 2}), "facet,cell_0,cell_1\n");
}

TEST(WriteVisibilityCsv, HasARowForEachFacet)
{
    VisibilityMap map{130, 3};
    map.column(1)[2] = 0b10;
    map.column(2)[0] = std::uint64_t{1} << 63;
    const CsvTable table = parse_csv(csv_of(map), "visibility.csv");
    ASSERT_EQ(table.rows(), 130U);
    for (std::size_t facet = 0; facet < 130; ++facet) {
        EXPECT_EQ(table.number(facet, "facet"), static_cast<double>(facet));
        for (std::size_t cell = 0; cell < 3; ++cell)
            EXPECT_EQ(table.number(facet, "cell_" + std::to_string(cell)),
                      map.is_accessible(facet, cell) ? 0 : 1);
    }
}

TEST(ConesCsv, HasSharesOfTheSphere)
{
    PartVisibility visibility{{3, 2}, {1}};
    visibility.map.column(0)[0] = 0b001;
    visibility.map.column(1)[0] = 0b101;
    const std::vector<double> solid_angles{1, 3};
    EXPECT_EQ(cones_csv(visibility, solid_angles),
              "facet,visible_fraction\n0,1\n1,\n2,0.75\n");
    EXPECT_THROW(cones_csv(visibility, std::vector<double>{1}), DomainError);
}

}  // namespace
}  // namespace endmill
