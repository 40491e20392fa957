// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/structureless_tables.h"

#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "endmill/planning/detail/portable_uniform.h"

namespace endmill {
namespace {

// log NCL = a + b log delta + c log R, and the standard deviation of the residuals.
struct PointsLaw {
    Eigen::Vector3d coefficients;
    double deviation;

    static Eigen::RowVector3d terms(int tolerance, int diameter)
    {
        return {1, std::log(table_tolerances_mm[tolerance]),
                std::log(table_diameters_mm[diameter] / 2)};
    }

    double points(int tolerance, int diameter) const
    {
        return std::exp(terms(tolerance, diameter).dot(coefficients.transpose()));
    }
};

PointsLaw points_law(const EconomyTables& printed, Parameter direction)
{
    Eigen::Matrix<double, 9, 3> terms;
    Eigen::Matrix<double, 9, 1> logs;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            terms.row(3 * i + j) = PointsLaw::terms(i, j);
            logs[3 * i + j] = std::log(printed.cell(TableQuantity::Ncl, direction, i, j));
        }
    const Eigen::Vector3d coefficients = terms.colPivHouseholderQr().solve(logs);
    const double squares = (terms * coefficients - logs).squaredNorm();
    return {coefficients, std::sqrt(squares / (9 - 3))};
}

// s(delta) by least squares of log s against log delta.
std::array<double, 3> slopes(const EconomyTables& printed, Parameter direction,
                             const std::array<double, 3>& link_mm)
{
    Eigen::Matrix<double, 3, 2> terms;
    Eigen::Vector3d logs;
    for (int i = 0; i < 3; ++i) {
        double travel = 0;
        double points = 0;
        for (int j = 0; j < 3; ++j) {
            travel += printed.cell(TableQuantity::Tcd, direction, i, j) - link_mm[i];
            points += printed.cell(TableQuantity::Ncl, direction, i, j);
        }
        terms.row(i) << 1, std::log(table_tolerances_mm[i]);
        logs[i] = std::log(travel / points);
    }
    const Eigen::Vector2d law = terms.colPivHouseholderQr().solve(logs);
    std::array<double, 3> smooth{};
    for (int i = 0; i < 3; ++i)
        smooth[i] = std::exp(terms.row(i).dot(law.transpose()));
    return smooth;
}

}  // namespace

EconomyTables structureless_tables(const EconomyTables& printed, std::uint32_t seed)
{
    PortableUniform uniform{seed};
    EconomyTables tables;
    for (int k = 0; k < 2; ++k) {
        const Parameter direction = table_directions[k];
        const PointsLaw law = points_law(printed, direction);
        const double link = uniform(100, 500);
        std::array<double, 3> links{};
        for (double& row : links)
            row = link + uniform(-10, 10);
        const std::array<double, 3> slope = slopes(printed, direction, links);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const double factor = 1 + law.deviation * uniform.normal();
                const double points = std::round(law.points(i, j) * factor);
                const double travel = slope[i] * points + links[i] + uniform(-0.5, 0.5);
                tables.runs[k][i][j] = {static_cast<std::size_t>(points),
                                        std::round(10 * travel) / 10};
            }
    }
    return tables;
}

}  // namespace endmill
