// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "posed_setups.h"
#include "test_meshes.h"
#include "vtp_reader.h"

namespace endmill {
namespace {

using test::range_deg;
using test::setup_turned;

const TriangleMesh part = test::box_mesh({-1, 2, 3}, {4, 5, 7});

FacetAccess access_of(const TriangleMesh& mesh)
{
    FacetAccess access;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        access.visible_fraction.push_back(0.5 / static_cast<double>(k + 1));
        access.reached_at_zero.push_back(k % 3 == 0 ? 1 : 0);
    }
    return access;
}

ShownSetup some_setup(RotaryFamily family)
{
    ShownSetup setup =
        setup_turned(family, test::some_turn(), {range_deg(-30, 60), range_deg(-20, 45)});
    setup.limits = RotaryLimits{range_deg(-50, 80), range_deg(-60, 70)};
    return setup;
}

// All cells in the order of VTK: vertices, lines, polygons.
struct ReadCells {
    std::vector<std::vector<std::int64_t>> cells;
    std::vector<std::int32_t> objects;
    std::vector<double> fractions;
    std::vector<std::uint8_t> reached;
    std::vector<Vec3> points;

    explicit ReadCells(const std::string& file)
    {
        const VtpReader reader{file};
        for (int kind = 0; kind < 3; ++kind) {
            const auto connectivity =
                reader.array<std::int64_t>("connectivity", "Int64", kind);
            std::int64_t begin = 0;
            for (const auto end : reader.array<std::int64_t>("offsets", "Int64", kind)) {
                cells.emplace_back(connectivity.begin() + begin,
                                   connectivity.begin() + end);
                begin = end;
            }
            EXPECT_EQ(begin, std::ssize(connectivity));
        }
        objects = reader.array<std::int32_t>("object", "Int32");
        fractions = reader.array<double>("visible_fraction", "Float64");
        reached = reader.array<std::uint8_t>("reached_at_zero", "UInt8");
        const auto numbers = reader.array<double>("point_mm", "Float64");
        for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
            points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
        EXPECT_EQ(reader.attribute("Piece", "NumberOfPoints"),
                  std::to_string(points.size()));
    }

    std::vector<Vec3> places(std::size_t cell) const
    {
        std::vector<Vec3> found;
        for (const std::int64_t number : cells.at(cell))
            found.push_back(points.at(static_cast<std::size_t>(number)));
        return found;
    }

    std::vector<std::size_t> of(SetupObject object) const
    {
        std::vector<std::size_t> found;
        for (std::size_t k = 0; k < objects.size(); ++k)
            if (objects[k] == static_cast<std::int32_t>(object))
                found.push_back(k);
        return found;
    }
};

// The height of a point along the tool axis, in the part's coordinates, is its Z in the
// machine's.
TEST(SetupVtp, HasThePartsFacetsInItsPose)
{
    const ShownSetup setup = some_setup(RotaryFamily::CA);
    const FacetAccess access = access_of(part);
    const ReadCells read{setup_vtp(part, access, setup)};
    ASSERT_EQ(read.objects.size(), read.cells.size());
    ASSERT_EQ(read.fractions.size(), read.cells.size());
    ASSERT_EQ(read.reached.size(), read.cells.size());
    const auto facets = read.of(SetupObject::Facet);
    ASSERT_EQ(facets.size(), part.triangles().size());
    for (std::size_t k = 0; k < facets.size(); ++k) {
        const auto corners = part.corners(k);
        const auto places = read.places(facets[k]);
        ASSERT_EQ(places.size(), 3U);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(places[c].z(), setup.frame.tool_axis.dot(corners[c]), 1e-13);
            EXPECT_NEAR(places[c].norm(), corners[c].norm(), 1e-13);
        }
        EXPECT_EQ(read.fractions[facets[k]], access.visible_fraction[k]);
        EXPECT_EQ(read.reached[facets[k]], access.reached_at_zero[k]);
    }
}

TEST(SetupVtp, HasTheMachinesAxesThroughTheMiddle)
{
    const ReadCells read{setup_vtp(part, access_of(part), some_setup(RotaryFamily::AB))};
    const auto along = [&](SetupObject object) {
        const auto cells = read.of(object);
        EXPECT_EQ(cells.size(), 1U);
        const auto ends = read.places(cells.at(0));
        return Vec3{(ends.at(1) - ends.at(0)).normalized()};
    };
    EXPECT_NEAR(along(SetupObject::ToolAxis).z(), 1, 1e-14);
    EXPECT_NEAR(along(SetupObject::FirstAxis).x(), 1, 1e-14);
    EXPECT_NEAR(along(SetupObject::SecondAxis).y(), 1, 1e-14);
    const auto first = read.places(read.of(SetupObject::FirstAxis).at(0));
    const auto second = read.places(read.of(SetupObject::SecondAxis).at(0));
    const auto tool = read.places(read.of(SetupObject::ToolAxis).at(0));
    EXPECT_LT((first[0] + first[1] - second[0] - second[1]).norm(), 1e-12);
    EXPECT_LT((first[0] + first[1] - 2 * tool[0]).norm(), 1e-12);
}

class SetupVtpOfBoth : public testing::TestWithParam<RotaryFamily> {};

// A point of the border, seen from the centre of the sphere, is a feasible direction;
// some directions slightly farther from the pole are not, so the border is not in the
// interior.
TEST_P(SetupVtpOfBoth, HasBordersOfDirectionsOnASphereAroundThePart)
{
    const ShownSetup setup = some_setup(GetParam());
    const ReadCells read{setup_vtp(part, access_of(part), setup)};
    const Vec3 middle = read.places(read.of(SetupObject::ToolAxis).at(0)).at(0);
    const RotaryFrame machine = test::axes_of_machine(GetParam());
    for (const SetupObject object :
         {SetupObject::NeededMotion, SetupObject::MachineMotion}) {
        const bool is_needed = object == SetupObject::NeededMotion;
        const FeasibleDirections motion{machine,
                                        is_needed ? setup.needed : *setup.limits};
        const auto cells = read.of(object);
        ASSERT_FALSE(cells.empty());
        const double radius = (read.places(cells[0]).at(0) - middle).norm();
        EXPECT_GT(radius, 0.5 * Vec3(5, 3, 4).norm());
        for (const std::size_t cell : cells)
            for (const Vec3& place : read.places(cell)) {
                EXPECT_NEAR((place - middle).norm(), radius, 1e-12);
                const Vec3 direction = (place - middle).normalized();
                EXPECT_TRUE(motion.contains(direction));
                int outside = 0;
                for (const Vec3& shift : {Vec3{Vec3::UnitX()}, Vec3{Vec3::UnitY()}})
                    for (const double side : {-1e-3, 1e-3})
                        outside +=
                            motion.contains((direction + side * shift).normalized()) ? 0
                                                                                     : 1;
                EXPECT_GT(outside, 0);
            }
    }
}

INSTANTIATE_TEST_SUITE_P(CAndAAndAAndB, SetupVtpOfBoth,
                         testing::Values(RotaryFamily::CA, RotaryFamily::AB));

TEST(SetupVtp, ASetupWithoutTurnsHasAVertexAtThePole)
{
    const ReadCells read{
        setup_vtp(part, access_of(part),
                  setup_turned(RotaryFamily::CA, test::some_turn(), {{0, 0}, {0, 0}}))};
    const auto cells = read.of(SetupObject::NeededMotion);
    ASSERT_EQ(cells.size(), 1U);
    EXPECT_EQ(cells[0], 0U);  // the only vertex
    const Vec3 middle = read.places(read.of(SetupObject::ToolAxis).at(0)).at(0);
    EXPECT_NEAR((read.places(0).at(0) - middle).normalized().z(), 1, 1e-14);
}

TEST(SetupVtp, RefusesAnotherNumberOfFacets)
{
    const ShownSetup setup = some_setup(RotaryFamily::CA);
    FacetAccess access = access_of(part);
    EXPECT_THROW(setup_vtp({}, {}, setup), DomainError);
    access.reached_at_zero.pop_back();
    EXPECT_THROW(setup_vtp(part, access, setup), DomainError);
    access = access_of(part);
    access.visible_fraction[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(setup_vtp(part, access, setup), DomainError);
}

}  // namespace
}  // namespace endmill
