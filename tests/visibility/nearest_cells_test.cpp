// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/visibility.h"

#include <cstdint>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/visibility/sphere_grid.h"
#include "random.h"

namespace endmill {
namespace {

void make_accessible(VisibilityMap& map, std::size_t facet, std::size_t cell)
{
    map.column(cell)[facet / 64] |= std::uint64_t{1} << (facet % 64);
}

// The definition: for each facet of Group II the accessible cell of the largest dot
// product, the lowest of those within 1e-12 of it.
std::set<std::size_t> nearest_by_definition(const VisibilityMap& map,
                                            const std::vector<Vec3>& centres,
                                            std::size_t pose)
{
    std::set<std::size_t> found;
    for (std::size_t facet = 0; facet < map.facets(); ++facet) {
        if (map.is_accessible(facet, pose))
            continue;
        double largest = -2;
        for (std::size_t cell = 0; cell < map.cells(); ++cell) {
            if (map.is_accessible(facet, cell))
                largest = std::max(largest, centres[pose].dot(centres[cell]));
        }
        for (std::size_t cell = 0; cell < map.cells(); ++cell) {
            if (map.is_accessible(facet, cell) &&
                centres[pose].dot(centres[cell]) >= largest - 1e-12) {
                found.insert(cell);
                break;
            }
        }
    }
    return found;
}

class NearestCells : public testing::TestWithParam<std::string> {};

TEST_P(NearestCells, AgreeWithTheDefinitionOnGridsWithManyTies)
{
    const SphereGrid grid = sphere_grid(GetParam());
    test::Random random{5};
    for (int round = 0; round < 30; ++round) {
        VisibilityMap map{70, grid.centres.size()};
        const double share = random.log_uniform(0.002, 0.5);
        for (std::size_t cell = 0; cell < map.cells(); ++cell) {
            for (std::size_t facet = 0; facet + 1 < map.facets(); ++facet) {
                if (random.uniform(0, 1) < share)
                    make_accessible(map, facet, cell);
            }
        }
        for (std::size_t pose = 0; pose < map.cells(); pose += 7) {
            const std::vector<std::uint32_t> found =
                nearest_cells(map, grid.centres, pose);
            EXPECT_EQ(std::set<std::size_t>(found.begin(), found.end()),
                      nearest_by_definition(map, grid.centres, pose));
            EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [&](auto a, auto b) {
                return grid.centres[pose].dot(grid.centres[a]) >
                       grid.centres[pose].dot(grid.centres[b]) + 1e-12;
            }));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OnEachKindOfGrid, NearestCells,
                         testing::Values("hex:4", "cube:3", "latlong:8x6", "ico:1"));

TEST(NearestCells, AreEmptyIfThePoseReachesEverything)
{
    const SphereGrid grid = sphere_grid("hex:2");
    VisibilityMap map{65, grid.centres.size()};
    for (std::size_t facet = 0; facet < map.facets(); ++facet)
        make_accessible(map, facet, 3);
    EXPECT_TRUE(nearest_cells(map, grid.centres, 3).empty());
    EXPECT_EQ(nearest_cells(map, grid.centres, 4), std::vector<std::uint32_t>{3});
}

// Two cells are equally near to the pole up to rounding, and lie in different classes of
// the dot product, with the border 1 - 1 / 32. The lower cell counts.
TEST(NearestCells, TakeTheLowestOfEqualCellsInDifferentClasses)
{
    const double border = 1 - 1.0 / 32;
    const auto at = [](double dot, double azimuth) {
        const double rho = std::sqrt(1 - dot * dot);
        return Vec3{rho * std::cos(azimuth), rho * std::sin(azimuth), dot};
    };
    const std::vector<Vec3> centres{Vec3::UnitZ(), at(border - 2e-13, 1),
                                    at(border + 2e-13, 2)};
    VisibilityMap map{1, 3};
    make_accessible(map, 0, 1);
    make_accessible(map, 0, 2);
    EXPECT_EQ(nearest_cells(map, centres, 0), std::vector<std::uint32_t>{1});
}

// A map whose facets reach caps of different sizes: some are reached by most
// tool axes, others by few. Some facets have no cell.
VisibilityMap map_of_caps(std::size_t facets, const std::vector<Vec3>& centres,
                          test::Random& random)
{
    VisibilityMap map{facets, centres.size()};
    for (std::size_t facet = 0; facet < facets; ++facet) {
        const double turn =
            6.3 * static_cast<double>(facet) / static_cast<double>(facets);
        const Vec3 normal{std::cos(turn), std::sin(turn), 0};
        const double least = facet % 11 == 3 ? 2 : random.uniform(-0.9, 0.9);
        for (std::size_t cell = 0; cell < centres.size(); ++cell) {
            if (normal.dot(centres[cell]) > least)
                make_accessible(map, facet, cell);
        }
    }
    return map;
}

class NearestCellsAtEveryPose : public testing::TestWithParam<std::size_t> {};

// Facets in less than one word of 64, at the ends of a word and of the eight that are copied at
// once, and in several of these; tool axes in two groups of 64.
TEST_P(NearestCellsAtEveryPose, AgreeWithTheDefinitionAndWithEachPoseOnItsOwn)
{
    const SphereGrid grid = sphere_grid("hex:3");
    test::Random random{7};
    const VisibilityMap map = map_of_caps(GetParam(), grid.centres, random);
    for (const int threads : {1, 4}) {
        set_thread_count(threads);
        std::vector<std::vector<std::uint32_t>> found(map.cells());
        std::vector<int> visits(map.cells());
        for_each_nearest_cells(map, grid.centres, [&](std::size_t pose, auto cells) {
            found[pose] = std::move(cells);
            ++visits[pose];
        });
        EXPECT_EQ(visits, std::vector<int>(map.cells(), 1));
        for (std::size_t pose = 0; pose < map.cells(); ++pose) {
            EXPECT_EQ(found[pose], nearest_cells(map, grid.centres, pose));
            EXPECT_EQ(std::set<std::size_t>(found[pose].begin(), found[pose].end()),
                      nearest_by_definition(map, grid.centres, pose));
        }
    }
    set_thread_count(2);
}

INSTANTIATE_TEST_SUITE_P(WithFewAndManyFacets, NearestCellsAtEveryPose,
                         testing::Values(0, 1, 63, 64, 65, 512, 513, 1600));

// A map in which each facet is accessible along a random number of random directions.
VisibilityMap random_map(std::size_t facets, std::size_t cells, test::Random& random)
{
    VisibilityMap map{facets, cells};
    for (std::size_t facet = 0; facet < facets; ++facet) {
        const double share = random.log_uniform(0.002, 0.9);
        for (std::size_t cell = 0; cell < cells; ++cell)
            if (random.uniform(0, 1) < share)
                make_accessible(map, facet, cell);
    }
    return map;
}

// The nearest cells of shares of the facets, put together.
std::vector<std::vector<std::uint32_t>> cells_of_shares(const VisibilityMap& map,
                                                        const std::vector<Vec3>& centres,
                                                        std::size_t shares)
{
    std::vector<std::uint64_t> rows;
    for (std::size_t k = 0; k < shares; ++k) {
        const auto found = nearest_cell_rows(facet_share(map, k, shares), centres);
        rows.resize(found.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i] |= found[i];
    }
    std::vector<std::vector<std::uint32_t>> cells(centres.size());
    for_each_row_of_cells(rows, centres, [&](std::size_t pose, auto found) {
        cells[pose] = std::move(found);
    });
    return cells;
}

// Fewer groups of 64 facets than shares, as many, and more.
TEST(NearestCells, OfSharesOfTheFacetsAreThoseOfAllFacets)
{
    test::Random random{17};
    for (const char* name : {"hex:3", "cube:4", "latlong:8x6"}) {
        const std::vector<Vec3> centres = sphere_grid(name).centres;
        for (const std::size_t facets : {0, 1, 64, 130, 256, 1000}) {
            const VisibilityMap map = random_map(facets, centres.size(), random);
            std::vector<std::vector<std::uint32_t>> whole(centres.size());
            for_each_nearest_cells(map, centres, [&](std::size_t pose, auto cells) {
                whole[pose] = std::move(cells);
            });
            for (const std::size_t shares : {1, 2, 4, 7})
                EXPECT_EQ(cells_of_shares(map, centres, shares), whole)
                    << name << ", " << facets << " facets, " << shares << " shares";
        }
    }
}

// Facet 64 a + b of a share is facet 64 (first + a step) + b of the map.
TEST(NearestCells, OfAShareAreThoseOfEveryThirdGroupOf64Facets)
{
    test::Random random{18};
    const VisibilityMap map = random_map(300, 20, random);
    std::size_t facets = 0;
    for (std::size_t first = 0; first < 3; ++first) {
        const VisibilityMap share = facet_share(map, first, 3);
        facets += share.facets();
        for (std::size_t facet = 0; facet < share.facets(); ++facet)
            for (std::size_t cell = 0; cell < map.cells(); ++cell)
                EXPECT_EQ(
                    share.is_accessible(facet, cell),
                    map.is_accessible(64 * (first + facet / 64 * 3) + facet % 64, cell));
    }
    EXPECT_EQ(facets, map.facets());
    EXPECT_EQ(facet_share(map, 5, 3).facets(), 0U);
    EXPECT_EQ(facet_share(map, 5, 3).cells(), 20U);
    EXPECT_THROW(facet_share(map, 0, 0), DomainError);
}

TEST(NearestCells, ReportEveryToolAxisOfTheirRows)
{
    const SphereGrid grid = sphere_grid("hex:3");
    const VisibilityMap map{3, grid.centres.size()};
    std::size_t told = 0;
    nearest_cell_rows(map, grid.centres,
                      [&](std::size_t done) { EXPECT_EQ(done, ++told); });
    EXPECT_EQ(told, grid.centres.size());
}

TEST(NearestCells, EndWithTheExceptionOfAVisit)
{
    const SphereGrid grid = sphere_grid("hex:3");
    const VisibilityMap map{3, grid.centres.size()};
    const auto visit = [](std::size_t pose, const auto&) {
        require(pose != 40, "ended");
    };
    EXPECT_THROW(for_each_nearest_cells(map, grid.centres, visit), DomainError);
}

TEST(NearestCells, NeedACentreForEachCellAndAPoseAmongThem)
{
    const VisibilityMap map{3, 2};
    const std::vector<Vec3> centres{Vec3::UnitZ(), Vec3::UnitX()};
    EXPECT_TRUE(nearest_cells(map, centres, 0).empty());
    EXPECT_THROW(nearest_cells(map, centres, 2), DomainError);
    EXPECT_THROW(nearest_cells(map, std::vector<Vec3>{Vec3::UnitZ()}, 0), DomainError);
    const auto visit = [](std::size_t, const auto&) {};
    EXPECT_THROW(for_each_nearest_cells(map, std::vector<Vec3>{Vec3::UnitZ()}, visit),
                 DomainError);
    EXPECT_THROW(nearest_cell_rows(map, std::vector<Vec3>{Vec3::UnitZ()}), DomainError);
    EXPECT_THROW(for_each_row_of_cells(std::vector<std::uint64_t>(1), centres, visit),
                 DomainError);
}

}  // namespace
}  // namespace endmill
