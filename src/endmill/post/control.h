// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace endmill {

/// What a control is told about the accuracy at corners.
enum class PathControl {
    Tolerance,  ///< `G64 P` with half the tolerance of the path
    Exact,      ///< `G61`: exact path
    None,       ///< nothing
};

/// How a block describes an arc.
enum class ArcForm {
    Centre,  ///< words I, J, K: from the start of the arc to its centre
    Radius,  ///< word R
    None,    ///< the control has no arcs
};

/// How comments are written.
enum class CommentStyle {
    Parentheses,  ///< (text)
    Semicolon,    ///< ;text
    None,         ///< the control has no comments
};

/// The axes that move first on the way over the path, after the tool was changed.
enum class FirstAxes {
    Z,   ///< the tool first moves to the safe height: it may be at any height
    Xy,  ///< X and Y first: the control changes tools at the top of Z
};

/// Unit of the time P of `G4`.
enum class DwellUnit { Seconds, Milliseconds };

/// Coolant during the program.
enum class Coolant { Off, Flood, Mist };

/// Largest number of digits after the decimal point in a written program. Nine digits
/// keep all that a double stores of a coordinate up to 1e6 mm.
inline constexpr int most_decimals = 9;
/// Largest number of a program, after O.
inline constexpr int largest_program_number = 99'999'999;
/// Largest value of `Control::largest_line_number`.
inline constexpr int most_numbered_lines = 99'999'999;
/// Range of `Control::longest_line`: a move of three axes needs 40 characters.
inline constexpr std::size_t least_longest_line = 40;
inline constexpr std::size_t most_longest_line = 1'000'000;  ///< see above

/// Words and number formats of the programs of one control, as data. The default is
/// RS-274 as LinuxCNC reads it, without tool length compensation.
///
/// A word is a capital letter with a plain decimal number, such as M6 or P0.5.
struct Control {
    std::string name = "RS-274";     ///< for messages and reports
    std::string source = {};         ///< origin of the data
    std::string extension = ".ngc";  ///< of the file, with its point
    bool percent = true;             ///< whether % stands before and after the program
    /// Number after O, written with at least four digits: 1 to `largest_program_number`.
    std::optional<int> program_number = {};
    CommentStyle comments = CommentStyle::Parentheses;  ///< form of the comment
    bool capital_comments = false;  ///< whether comments are in capital letters
    /// Blocks at the start. The unit of length, G20 or G21, precedes the first one.
    std::vector<std::string> start = {"G90 G94 G17 G40 G49 G80 G54"};
    /// Blocks after the last retract; one of them ends the program with M2 or M30. They are
    /// written unchanged and may move the axes, such as G91 G28 Z0.
    std::vector<std::string> end = {"M5", "M30"};
    PathControl path_control = PathControl::Tolerance;  ///< accuracy at corners
    std::optional<std::string> tool_change = "M6";      ///< after T; none: one tool only
    std::optional<std::string> tool_length = {};        ///< before H: G43
    FirstAxes first_axes = FirstAxes::Z;                ///< after the tool change
    std::optional<DwellUnit> dwell = DwellUnit::Seconds;  ///< unit of G4 P; none: no G4
    std::optional<std::string> flood = "M8";              ///< flood coolant on
    std::optional<std::string> mist = "M7";               ///< mist coolant on
    std::string coolant_off = "M9";                       ///< any coolant off
    ArcForm arcs = ArcForm::Centre;                       ///< form of arcs
    int decimals_mm = 4;                     ///< of coordinates in mm, 0 to 9
    int decimals_inch = 5;                   ///< of coordinates in inches, 0 to 9
    std::optional<int> speed_decimals = {};  ///< of S; none: as coordinates
    bool always_point = false;  ///< whether X, Y, Z, I, J, K, R, F end in a point: X10.
    bool crlf = false;          ///< whether lines end with CR and LF
    /// N starts again at 1 after it: 1 to `most_numbered_lines`.
    int largest_line_number = 99999;
    /// Characters without the line end: `least_longest_line` to `most_longest_line`.
    std::optional<std::size_t> longest_line = {};
};

/// Whether `text` is one or more words separated by single blanks.
bool is_words(std::string_view text);

/// Whether `text` is one word that begins with `letter`.
bool is_word(std::string_view text, char letter);

/// Whether `text` is one M word that neither stops nor ends the program, calls another one
/// nor turns the spindle: not M0 to M5, M30, M60, M97 to M99, M198, M199.
bool is_auxiliary_word(std::string_view text);

/// Whether `text` is the word that takes the tool length from a table: G43.
bool is_tool_length_word(std::string_view text);

/// Whether `words` have M2 or M30, the end of a program.
/// \pre is_words(words)
bool ends_program(std::string_view words);

/// The first word of `words` that a start block must not have. A start block may only set
/// modes: G5.1, G8, G15, G17, G40, G49, G50, G50.1, G54 to G59.3, G54.1, G61, G61.1, G64,
/// G67, G69, G80, G90, G91.1, G94, G97 to G99, G187, M48, and P and Q beside G5.1, G54.1,
/// G64 or G187.
/// \return std::nullopt if there is none.
/// \pre is_words(words)
std::optional<std::string> unfit_start_word(std::string_view words);

/// Checks a control.
/// \throws DomainError for text that is not made of words, for start blocks with unfit
///         words, if no block at the end ends the program, for words of tool change, coolant and tool length that do something
///         else, and for numbers out of their ranges.
void require_sound(const Control& control);

}  // namespace endmill
