// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/certified_inflow.h"

#include <random>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/bound/detail/covered_sets.h"
#include "endmill/bound/detail/inflow.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

struct Certifier {
    explicit Certifier(test::SidedSurfaces surfaces, const BoundProblem& tool)
        : sided{std::move(surfaces)},
          problem{tool}
    {
    }

    CertifiedInflow inflow(const ContactBox& box) const
    {
        return certified_inflow(part, problem, grid, density, enclosures, box);
    }

    test::SidedSurfaces sided;
    BoundedPart part = sided.part();
    BoundProblem problem;
    DensityGrid grid{part, 3};
    std::vector<double> density = varied(grid.nodes());
    EnclosureGrid enclosures{part, problem, grid, density, 0.5, 4};

private:
    static std::vector<double> varied(std::size_t count)
    {
        std::vector<double> result(count);
        for (std::size_t node = 0; node < count; ++node)
            result[node] = 0.15 + 0.02 * static_cast<double>(node % 7) / 7;
        return result;
    }
};

// The bound of a box is at least the inflow at random contacts in it, which rays find
// without intervals; for small boxes it is hardly more. Boxes lie everywhere, also at the
// border.
TEST(CertifiedInflow, IsAboveTheInflowAtRandomContacts)
{
    std::mt19937_64 engine{1};
    std::uniform_real_distribution<double> share{0, 1};
    for (const BoundedLength length : {BoundedLength::Contact, BoundedLength::Tip})
        for (const char* const name : {"saddle", "gaussian-bump"}) {
            BoundProblem problem = test::usual_problem();
            problem.length = length;
            const Certifier certifier{test::dataset(name), problem};
            const CoveredSets sets{certifier.part, problem};
            int known = 0;
            double excess = 0;
            for (int k = 0; k < 60; ++k) {
                const auto& cells = certifier.grid.cells();
                const DensityCell& cell = cells[engine() % cells.size()];
                const auto box_of = [&](const Interval& range, double mm) -> Interval {
                    const double size = 0.3 / mm * range.length();
                    const double low =
                        range.low + share(engine) * (range.length() - size);
                    return {low, low + size};
                };
                const ParameterBox box{box_of(cell.u, cell.length_u),
                                       box_of(cell.v, cell.length_v)};
                const auto place = [&](double s, double t) -> ContactPlace {
                    return {0,
                            cell.i,
                            cell.j,
                            {std::lerp(box.u.low, box.u.high, s),
                             std::lerp(box.v.low, box.v.high, t)}};
                };
                const CertifiedInflow found = certifier.inflow({place(0.5, 0.5), box});
                if (found.kind != CertifiedInflow::Kind::Bounded)
                    continue;
                ++known;
                double greatest = 0;
                for (int sample = 0; sample < 5; ++sample) {
                    const auto set = sets.set_at(place(share(engine), share(engine)),
                                                 CoveredSets::Want::BoundaryAndPieces);
                    ASSERT_TRUE(set);
                    const auto flows = stored_flows(set->boundary, certifier.grid);
                    greatest = std::max(greatest, greatest_inflow(flows, certifier.grid,
                                                                  certifier.density));
                    double disc = 0;
                    for (const CoveredPiece& piece : set->pieces)
                        disc += piece.area *
                                certifier.grid.value(
                                    std::span<const double>{certifier.density},
                                    certifier.grid.place(piece.surface, piece.at));
                    EXPECT_LE(disc, found.disc * 1.001);
                }
                // Rays find the inflow to 0.05 %.
                EXPECT_LE(greatest, found.inflow * 1.0005);
                excess += found.inflow / greatest - 1;
            }
            EXPECT_GE(known, 50) << name;
            EXPECT_LT(excess / known, 0.12) << name;
        }
}

TEST(CertifiedInflow, IsUnknownWhereASecondSurfaceIsCovered)
{
    const Surface left = test::graph(test::monomial(1, 0, 0.0), {{-20, 0}, {-10, 10}});
    const Surface right = test::graph(test::monomial(1, 0, 0.0), {{0, 20}, {-10, 10}});
    const Certifier certifier{test::SidedSurfaces{{left, right}}, test::usual_problem()};
    const CertifiedInflow at_seam =
        certifier.inflow({{0, 0, 0, {0.99, 0.5}}, {{0.98, 1}, {0.49, 0.51}}});
    EXPECT_EQ(at_seam.kind, CertifiedInflow::Kind::Unknown);
    EXPECT_FALSE(at_seam.cells.empty());
    EXPECT_FALSE(at_seam.reason.empty());
    EXPECT_EQ(
        certifier.inflow({{0, 0, 0, {0.5, 0.5}}, {{0.49, 0.51}, {0.49, 0.51}}}).kind,
        CertifiedInflow::Kind::Bounded);
}

// In a valley of radius 5 the ball of radius 7.5 touches nowhere at the bottom.
TEST(CertifiedInflow, KnowsThatTheBallDoesNotFit)
{
    const Surface valley = test::graph(test::monomial(2, 0, 0.1), {{-3, 3}, {-10, 10}});
    const Certifier certifier{test::SidedSurfaces{{valley}}, test::usual_problem()};
    EXPECT_EQ(
        certifier.inflow({{0, 0, 0, {0.5, 0.5}}, {{0.49, 0.51}, {0.49, 0.51}}}).kind,
        CertifiedInflow::Kind::NoContact);
}

}  // namespace
}  // namespace endmill
