// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace endmill {

/// Which facets of a part a tool reaches along which directions: a bit for each, a column of
/// bits for each direction. The paper's binary spherical map, but for its sign: here a set bit
/// is *accessible*, as in no file. Source: [KangSuh, eq. (3)].
class VisibilityMap {
public:
    VisibilityMap() = default;

    /// Nothing is accessible. \throws LimitError if that needs more memory than there is.
    VisibilityMap(std::size_t facets, std::size_t cells);

    std::size_t facets() const { return facets_; }  ///< bits of a column
    std::size_t cells() const { return cells_; }    ///< columns

    /// 64-bit words of a column; the bits beyond the last facet are 0.
    std::size_t words() const { return words_; }

    /// Bit j % 64 of word j / 64 tells of facet j. \pre cell < cells().
    std::span<const std::uint64_t> column(std::size_t cell) const
    {
        return {bits_.data() + cell * words_, words_};
    }

    /// The same, to be filled. \pre cell < cells(); the bits beyond the last facet stay 0.
    std::span<std::uint64_t> column(std::size_t cell)
    {
        return {bits_.data() + cell * words_, words_};
    }

    /// Whether the tool reaches `facet` along the direction of `cell`. \pre both exist.
    bool is_accessible(std::size_t facet, std::size_t cell) const
    {
        return (column(cell)[facet / 64] >> (facet % 64) & 1) != 0;
    }

private:
    std::size_t facets_ = 0;
    std::size_t cells_ = 0;
    std::size_t words_ = 0;
    std::vector<std::uint64_t> bits_;
};

}  // namespace endmill
