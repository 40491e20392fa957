// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/core/error.h"
#include "endmill/core/vec.h"
#include "endmill/post/detail/program_builder.h"
#include "endmill/post/detail/text_lines.h"

namespace endmill {

/// Rapids to and from reference positions (G28, G30, G53), which only the machine knows.
/// Such a move is taken as a rapid straight up to a safe height. The tool comes back at
/// this height over the next position that the program states.
class ReferenceMoves {
public:
    /// The move of a program to a reference position.
    struct Departure {
        std::optional<double> height_mm;  ///< of the programmed point, if it is known
        bool moves_across = false;        ///< whether X or Y move
        bool moves_up = false;            ///< whether Z moves
    };

    /// Both arguments must outlive this object.
    ReferenceMoves(ProgramBuilder& builder, const TextLines& lines)
        : builder_{builder},
          lines_{lines}
    {
    }

    /// Whether the tool is away: from a departure until `go_rapidly`.
    bool is_away() const { return is_away_; }

    /// Line of the last departure; 0 before the first one.
    std::size_t line() const { return line_; }

    /// Number of departures.
    std::size_t count() const { return count_; }

    /// Begins a move to a reference position, which the program makes from the end of the
    /// path.
    /// \throws FormatError if X or Y move, Z does not, and the tool is not above the
    ///         cuts: the machine might cut where nobody knows.
    void depart(const Departure& departure);

    /// Raises the tool to the safe height, where it stays.
    void stay_away();

    /// A rapid to `target`; if the tool is away, from the safe height over it. A rapid to
    /// where the tool is makes no point.
    void go_rapidly(const Vec3& target);

    /// Goes to a place at the safe height, unless the tool is there. \pre the path has a
    /// point
    void rise_over(const Vec3& place);

    /// Checks that a cut may follow.
    /// \throws FormatError at the line of a departure that moved all axes at once from
    ///         among the cuts: the machine would have moved through the material.
    void check_cut() const;

    /// Adds a remark on such a departure, if the program ends with it.
    /// \param line what a line number in the remark counts: "line" for lines of the file.
    void finish(std::string_view line) const;

private:
    ProgramBuilder& builder_;
    const TextLines& lines_;
    bool is_away_ = false;
    std::size_t line_ = 0;
    std::size_t count_ = 0;
    std::optional<FormatError> slanted_;  // the first such departure
    std::string slanted_text_;
};

}  // namespace endmill
