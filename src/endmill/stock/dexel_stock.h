// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/stock/height_stock.h"

/// \file
/// The stock as tri-dexels: three fields of parallel rays along x, y and z. Each ray holds
/// the intervals of material on it, twice: an upper set, which contains all material, and
/// a lower set, which contains material only. The true stock lies between them on every
/// ray.

namespace endmill {

/// An interval of material on a ray, in units of its stock from the block's low side.
struct DexelInterval {
    std::int32_t from;  ///< lower end
    std::int32_t to;    ///< upper end, above `from`

    /// Whether both intervals are equal.
    friend bool operator==(const DexelInterval&, const DexelInterval&) = default;
};

/// The material on one ray: disjoint intervals, ascending.
struct Dexel {
    std::vector<DexelInterval> upper;  ///< contains all material
    std::vector<DexelInterval> lower;  ///< contains material only
};

/// A field of parallel rays through a block, one in the middle of each cell of a grid
/// across them.
class DexelField {
public:
    /// \param axis  0, 1 or 2: the rays run along x, y or z. The grid's columns run along
    ///              the next axis in the order x, y, z, x, the rows along the one after.
    /// \param pitch greatest side of a cell, mm.
    /// \param units length of the rays, in units of the stock.
    DexelField(const Block& block, int axis, double pitch, std::int32_t units);

    int axis() const { return axis_; }                             ///< 0, 1 or 2
    int columns() const { return columns_; }                       ///< of the grid
    int rows() const { return rows_; }                             ///< of the grid
    double cell_area() const { return column_step_ * row_step_; }  ///< mm^2
    double column_step() const { return column_step_; }            ///< mm
    double row_step() const { return row_step_; }                  ///< mm

    /// Returns the place where a ray enters the block, mm.
    Vec3 start(int column, int row) const;

    /// Returns the intervals of a ray that contain all material.
    std::span<const DexelInterval> upper(int column, int row) const
    {
        return intervals(upper_, column, row);
    }
    /// Returns the intervals of a ray that contain material only.
    std::span<const DexelInterval> lower(int column, int row) const
    {
        return intervals(lower_, column, row);
    }

    /// Replaces the material of all rays.
    /// \param dexels one per ray, row by row, the columns running fastest.
    /// \throws DomainError for another number.
    void assign(std::span<const Dexel> dexels);

private:
    // Intervals of all rays, one after the other, and where those of each ray begin.
    struct Intervals {
        std::vector<DexelInterval> all;
        std::vector<std::uint32_t> first;
    };

    std::span<const DexelInterval> intervals(const Intervals& of, int column,
                                             int row) const
    {
        const std::size_t ray = static_cast<std::size_t>(row) * columns_ + column;
        return std::span{of.all}.subspan(of.first[ray],
                                         of.first[ray + 1] - of.first[ray]);
    }

    Block block_;
    int axis_;
    int columns_;
    int rows_;
    double column_step_;
    double row_step_;
    Intervals upper_;
    Intervals lower_;
};

/// A stock of three fields of dexels. Ends are whole multiples of a unit: 2^-20 mm for
/// blocks up to 1024 mm, a larger power of two for larger ones.
class DexelStock {
public:
    /// A block full of material.
    /// \param pitch distance of the rays, mm.
    /// \throws DomainError unless the block is finite and low < high, and 0 < pitch.
    /// \throws LimitError if a field has more than 2^31 - 1 rays.
    DexelStock(const Block& block, double pitch);

    const Block& block() const { return block_; }  ///< the material at the start
    double pitch() const { return pitch_; }        ///< mm, as given
    double unit() const { return unit_; }          ///< mm

    /// Length of the rays along x, y or z, in units.
    std::int32_t units(int axis) const
    {
        return static_cast<std::int32_t>(
            std::lround((block_.high[axis] - block_.low[axis]) / unit_));
    }

    /// The rays along x, y or z.
    const DexelField& field(int axis) const { return fields_[std::size_t(axis)]; }
    /// The same for changes.
    DexelField& field(int axis) { return fields_[std::size_t(axis)]; }

private:
    Block block_;
    double pitch_;
    double unit_;
    std::array<DexelField, 3> fields_;
};

/// Returns the dexels of a stock of heights.
///
/// Between the centres of four neighbouring cells the surface is assumed to lie between
/// their lowest and their highest height, so the upper set reaches up to the highest and
/// the lower set up to the lowest. Outside the outermost centres the nearest ones count.
/// \param pitch distance of the rays, mm.
/// \throws GeometryError if the stock has no material. Throws as the constructor.
DexelStock dexels_of_heights(const HeightStock& heights, double pitch);

/// Bounds of a volume by one field of rays. Between the rays the material is not known.
struct DexelVolume {
    double upper;  ///< mm^3, of the intervals that contain all material
    double lower;  ///< mm^3, of the intervals that contain material only
};

/// Returns the volume of the material by the rays of one field.
DexelVolume dexel_volume(const DexelStock& stock, int axis);

/// Returns an upper bound of the memory in bytes that a stock takes during the removal.
/// \param extra bytes per ray for other data made from the stock.
/// \pre the block is finite with low < high, and 0 < pitch.
double required_dexel_bytes(const Block& block, double pitch, double extra = 0);

/// Checks that a stock of dexels fits into `memory_gib` GiB. It allocates nothing.
/// \param extra as in `required_dexel_bytes`.
/// \throws DomainError as the constructor.
/// \throws LimitError if it does not fit; the message states the need, the limit and a
///         pitch that fits.
void require_dexel_memory(const Block& block, double pitch, double memory_gib,
                          double extra = 0);

}  // namespace endmill
