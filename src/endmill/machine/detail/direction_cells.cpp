// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/detail/direction_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;

// Shifts an angle by whole turns into [0, 2 pi).
double first_turn(double angle)
{
    const double within = angle - 2 * pi * std::floor(angle / (2 * pi));
    return within < 2 * pi ? within : 0;
}

// Sorts cuts and merges those that are equal up to rounding.
void keep_distinct(std::vector<double>& cuts)
{
    std::ranges::sort(cuts);
    const auto are_one = [](double a, double b) { return b - a <= thinnest_angle; };
    cuts.erase(std::unique(cuts.begin(), cuts.end(), are_one), cuts.end());
}

bool holds(const DirectionPatch& patch, double azimuth, double latitude)
{
    return first_turn(azimuth - patch.from) <= patch.width && patch.low <= latitude &&
           latitude <= patch.high;
}

}  // namespace

DirectionCells::DirectionCells(std::span<const DirectionPatch> patches)
    : latitudes_{-pi / 2, pi / 2}
{
    for (const DirectionPatch& patch : patches) {
        if (patch.width < 2 * pi - thinnest_angle) {
            azimuths_.push_back(first_turn(patch.from));
            azimuths_.push_back(first_turn(patch.from + patch.width));
        }
        latitudes_.push_back(patch.low);
        latitudes_.push_back(patch.high);
    }
    keep_distinct(azimuths_);
    keep_distinct(latitudes_);
    // The last cut may equal the first one, a whole turn on.
    if (azimuths_.size() > 1 &&
        azimuths_.front() + 2 * pi - azimuths_.back() <= thinnest_angle)
        azimuths_.pop_back();
    if (azimuths_.empty())
        azimuths_.push_back(0);
    is_in_.assign(columns() * rows(), 0);
    for (std::size_t i = 0; i < columns(); ++i)
        for (std::size_t j = 0; j < rows(); ++j) {
            const double azimuth = (azimuths_[i] + end_azimuth(i)) / 2;
            const double latitude = (latitudes_[j] + latitudes_[j + 1]) / 2;
            for (const DirectionPatch& patch : patches)
                if (holds(patch, azimuth, latitude))
                    is_in_[i * rows() + j] = 1;
        }
}

double DirectionCells::end_azimuth(std::size_t column) const
{
    return column + 1 < columns() ? azimuths_[column + 1] : azimuths_.front() + 2 * pi;
}

double DirectionCells::solid_angle() const
{
    double sum = 0;
    for (std::size_t i = 0; i < columns(); ++i)
        for (std::size_t j = 0; j < rows(); ++j)
            if (is_in(i, j))
                sum += (end_azimuth(i) - azimuths_[i]) *
                       (std::sin(latitudes_[j + 1]) - std::sin(latitudes_[j]));
    return sum;
}

void DirectionCells::add_meridians(std::vector<DirectionEdge>& edges) const
{
    for (std::size_t i = 0; i < columns(); ++i) {
        const std::size_t before = (i + columns() - 1) % columns();
        bool goes_on = false;
        for (std::size_t j = 0; j < rows(); ++j) {
            const bool is_edge = is_in(before, j) != is_in(i, j);
            if (is_edge && goes_on)
                edges.back().to_latitude = latitudes_[j + 1];
            else if (is_edge)
                edges.push_back(
                    {azimuths_[i], azimuths_[i], latitudes_[j], latitudes_[j + 1]});
            goes_on = is_edge;
        }
    }
}

void DirectionCells::add_parallels(std::vector<DirectionEdge>& edges) const
{
    for (std::size_t j = 1; j < rows(); ++j) {
        const auto is_edge = [&](std::size_t i) {
            return is_in(i, j - 1) != is_in(i, j);
        };
        // Start after a gap, so that no edge is split at azimuth 0.
        std::size_t first = 0;
        while (first < columns() && is_edge(first))
            ++first;
        bool goes_on = false;
        for (std::size_t k = 0; k < columns(); ++k) {
            const std::size_t i = (first + k) % columns();
            const double width = end_azimuth(i) - azimuths_[i];
            if (is_edge(i) && goes_on)
                edges.back().to_azimuth += width;
            else if (is_edge(i))
                edges.push_back(
                    {azimuths_[i], azimuths_[i] + width, latitudes_[j], latitudes_[j]});
            goes_on = is_edge(i);
        }
    }
}

std::vector<DirectionEdge> DirectionCells::border() const
{
    std::vector<DirectionEdge> edges;
    add_meridians(edges);
    add_parallels(edges);
    return edges;
}

}  // namespace endmill
