// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/obj.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "endmill/core/text.h"

// OBJ has no header, and statements come in any order. Only points and faces are used.
// Known statements that do not affect triangles are skipped. Unknown ones are skipped and
// counted, so that a file that lost faces to damage does not pass unnoticed; a file without
// any known statement is refused.

namespace endmill {
namespace {

using Words = std::span<const std::string_view>;

// Statements that do not affect the triangles.
constexpr std::array<std::string_view, 18> ignored_statements{
    "vn",     "vt",       "g",      "o",      "s",          "usemtl",
    "mtllib", "l",        "p",      "mg",     "bevel",      "c_interp",
    "lod",    "d_interp", "maplib", "usemap", "shadow_obj", "trace_obj"};

// Statements of free-form curves and surfaces, which are not supported. They are known
// here so that the message can say so.
constexpr std::array<std::string_view, 23> free_form_statements{
    "vp",   "cstype", "deg",  "bmat", "step",  "curv",  "curv2", "surf",
    "parm", "trim",   "hole", "scrv", "sp",    "end",   "con",   "bsp",
    "bzp",  "cdc",    "cdp",  "res",  "ctech", "stech", "csh"};

constexpr std::size_t most_unknown_words = 8;  // that a note lists
constexpr std::size_t longest_shown_word = 20;

// Whether `word` is one of `words`.
bool is_one_of(Words words, std::string_view word)
{
    return std::ranges::find(words, word) != words.end();
}

// Reads the whole number at the beginning of `text` and removes it from `text`.
bool take_number(std::string_view& text, std::int64_t& number)
{
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{})
        return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

// Whether `text` may follow v in a corner: it is empty, /vt, //vn or /vt/vn.
bool is_texture_and_normal(std::string_view text)
{
    std::int64_t ignored = 0;
    if (text.empty())
        return true;
    if (!text.starts_with('/'))
        return false;
    text.remove_prefix(1);
    const bool has_texture = take_number(text, ignored);
    if (text.empty())
        return has_texture;
    if (!text.starts_with('/'))
        return false;
    text.remove_prefix(1);
    return take_number(text, ignored) && text.empty();
}

// Reads the statements of one file in order.
class ObjReader {
public:
    explicit ObjReader(const MeshSource& source)
        : source_{source},
          scanner_{scanner(source)},
          mesh_{sized_builder(source)}
    {
    }

    // Reads all statements. The mesh is complete at the end of the file.
    RawMesh read()
    {
        while (scanner_.next_line())
            read_statement(scanner_.word());
        if (!has_known_ && first_unknown_line_ > 0)
            throw complaint(source_, "E_OBJ_SYNTAX", FilePlace::line(first_unknown_line_),
                            "no line begins with a word of OBJ",
                            "statements such as v and f");
        RawMesh mesh = mesh_.take();
        if (!unknown_.empty())
            mesh.notes.push_back(skipped_note());
        return mesh;
    }

private:
    // The lines of the file, without comments.
    static TextScanner scanner(const MeshSource& source)
    {
        return {source.content, {source.file, "E_OBJ_SYNTAX", '#'}};
    }

    // OBJ files do not state their size. A first pass counts points and faces, so that
    // memory is allocated once and checked against the limit.
    static RawMeshBuilder sized_builder(const MeshSource& source)
    {
        std::size_t points = 0;
        std::size_t faces = 0;
        TextScanner lines = scanner(source);
        while (lines.next_line()) {
            const std::string_view word = lines.word();
            points += word == "v" ? 1 : 0;
            faces += word == "f" ? 1 : 0;
        }
        return {source, points, faces};
    }

    // Reads the rest of a line whose first word is `word`.
    void read_statement(std::string_view word)
    {
        if (!is_one_of(free_form_statements, word) && !is_known(word)) {
            skip_unknown(word);
            return;
        }
        has_known_ = true;
        if (word == "v")
            read_point();
        else if (word == "f")
            read_face();
        else if (is_one_of(free_form_statements, word))
            throw scanner_.complaint("free-form statement \"" + std::string{word} + '"',
                                     "a mesh of points (v) and faces (f)");
    }

    static bool is_known(std::string_view word)
    {
        return word == "v" || word == "f" || is_one_of(ignored_statements, word);
    }

    // A face whose word was damaged must not vanish, so only words that stand for themselves
    // are skipped: letters, digits and underscores, beginning with a letter.
    void skip_unknown(std::string_view word)
    {
        const bool is_word = std::ranges::all_of(word, [](unsigned char letter) {
            return std::isalnum(letter) != 0 || letter == '_';
        });
        if (!is_word || std::isalpha(static_cast<unsigned char>(word.front())) == 0)
            throw scanner_.complaint_about(word, "an OBJ statement, such as v or f");
        if (unknown_.empty())
            first_unknown_line_ = scanner_.line();
        const auto known = std::ranges::find(unknown_, word,
                                             &std::pair<std::string, std::size_t>::first);
        if (known != unknown_.end())
            ++known->second;
        else if (unknown_.size() < most_unknown_words)
            unknown_.emplace_back(word, 1);
        else
            ++other_unknown_;
    }

    // "12 lines with unknown words were skipped: c (10), mg (2)"
    std::string skipped_note() const
    {
        std::size_t lines = other_unknown_;
        std::string words;
        for (const auto& [word, count] : unknown_) {
            lines += count;
            words += (words.empty() ? "" : ", ") + printable(word, longest_shown_word) +
                     " (" + std::to_string(count) + ")";
        }
        if (other_unknown_ > 0)
            words += ", others (" + std::to_string(other_unknown_) + ")";
        return counted(lines, "line") + " with unknown words " +
               (lines == 1 ? "was" : "were") + " skipped: " + words;
    }

    // Numbers after x, y, z (a weight or a colour) are checked to be numbers and ignored.
    void read_point()
    {
        mesh_.add_point(scan_point_mm(scanner_, source_));
        while (!scanner_.at_line_end())
            scanner_.number();
    }

    // The corners are indices or index triples; only the point's index is used.
    void read_face()
    {
        corners_.clear();
        while (!scanner_.at_line_end())
            corners_.push_back(corner(scanner_.word()));
        mesh_.add_face(corners_, FilePlace::line(scanner_.line()));
    }

    // The index, from 0, of the point that a corner refers to.
    std::int32_t corner(std::string_view word) const
    {
        std::string_view rest = word;
        std::int64_t number = 0;
        if (!take_number(rest, number) || !is_texture_and_normal(rest))
            throw scanner_.complaint_about(word, "a corner: v, v/vt, v//vn or v/vt/vn");
        const auto points = static_cast<std::int64_t>(mesh_.points());
        if (1 <= number && number <= points)
            return static_cast<std::int32_t>(number - 1);
        if (-points <= number && number <= -1)
            return static_cast<std::int32_t>(points + number);
        const std::string most = std::to_string(points);
        throw complaint(source_, "E_INDEX", FilePlace::line(scanner_.line()),
                        "index " + std::to_string(number),
                        points == 0 ? "points (v) above the faces"
                                    : "1 to " + most + ", or -1 to -" + most +
                                          ", for the points above");
    }

    const MeshSource& source_;
    TextScanner scanner_;
    RawMeshBuilder mesh_;
    std::vector<std::int32_t> corners_;
    bool has_known_ = false;  // whether a known statement was read
    // Unknown words with the number of their lines, in the order of the file.
    std::vector<std::pair<std::string, std::size_t>> unknown_;
    std::size_t other_unknown_ = 0;  // lines with further words
    std::size_t first_unknown_line_ = 0;
};

}  // namespace

RawMesh parse_obj(const MeshSource& source)
{
    return ObjReader{source}.read();
}

std::string obj_text(const TriangleMesh& mesh)
{
    std::string text = "# mesh in mm, written by endmill\n";
    for (const Vec3& point : mesh.points()) {
        text += 'v';
        for (int c = 0; c < 3; ++c) {
            text += ' ';
            append_text(text, point[c]);
        }
        text += '\n';
    }
    for (const Triangle& triangle : mesh.triangles()) {
        text += 'f';
        for (const std::int32_t corner : triangle)
            text += ' ' + std::to_string(std::int64_t{corner} + 1);
        text += '\n';
    }
    return text;
}

}  // namespace endmill
