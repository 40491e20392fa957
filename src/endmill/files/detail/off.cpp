// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/off.h"

#include <cstdint>
#include <vector>

#include "endmill/core/text.h"

// The header states the counts, and each point and face has a line of its own. Comments
// and empty lines may stand anywhere. The keyword announces additional numbers of points;
// whether a colour follows a face can only be seen from its line.

namespace endmill {
namespace {

// Shortest lines of a point and a face; they bound the counts that a file can hold.
constexpr std::uint64_t least_point_bytes = 6;  // "0 0 0\n"
constexpr std::uint64_t least_face_bytes = 8;   // "3 0 1 2\n"
constexpr int most_colour_numbers = 4;

// Removes `prefix` from `word`. \return whether `word` began with it.
bool take_prefix(std::string_view& word, std::string_view prefix)
{
    const bool is_there = word.starts_with(prefix);
    if (is_there)
        word.remove_prefix(prefix.size());
    return is_there;
}

// Reads one file: the keyword, the counts, then a line for each point and face.
class OffReader {
public:
    explicit OffReader(const MeshSource& source)
        : source_{source},
          scanner_{source.content, {source.file, "E_OFF_SYNTAX", '#'}}
    {
    }

    // Reads the whole file. Content after the last face is an error.
    RawMesh read()
    {
        read_keyword();
        const Counts counts = read_counts();
        RawMeshBuilder mesh{source_, counts.points, counts.faces};
        for (std::size_t i = 0; i < counts.points; ++i) {
            go_to_next_line("points", i, counts.points);
            read_point(mesh);
        }
        for (std::size_t i = 0; i < counts.faces; ++i) {
            go_to_next_line("faces", i, counts.faces);
            read_face(mesh);
        }
        if (scanner_.next_line())
            throw complaint(source_, "E_COUNT", place(),
                            "header claims " + std::to_string(counts.faces) +
                                " faces, file goes on after them",
                            "");
        return mesh.take();
    }

private:
    // The counts of the header. The number of edges is not used.
    struct Counts {
        std::size_t points;
        std::size_t faces;
    };

    // Reads the keyword, which announces further numbers after each point by its
    // prefixes.
    void read_keyword()
    {
        const std::string_view word = scanner_.word_across_lines();
        std::string_view rest = word;
        const bool has_texture = take_prefix(rest, "ST");
        const bool has_colour = take_prefix(rest, "C");
        const bool has_normal = take_prefix(rest, "N");
        if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF")
            throw scanner_.complaint_about(word, "OFF, with points of three coordinates");
        if (rest != "OFF")
            throw scanner_.complaint_about(word, "\"OFF\"");
        has_more_of_point_ = has_texture || has_colour || has_normal;
    }

    // Reads the three counts and checks that the file is long enough for points and
    // faces.
    Counts read_counts()
    {
        if (scanner_.at_line_end() && !scanner_.next_line())
            throw scanner_.complaint_about({}, "the numbers of points, faces and edges");
        if (TextScanner ahead = scanner_; ahead.word() == "BINARY")
            throw scanner_.complaint("binary OFF", "OFF in ASCII");
        const std::int64_t points = read_count("points");
        const std::int64_t faces = read_count("faces");
        read_count("edges");
        scanner_.expect_line_end();
        const std::size_t bytes =
            source_.content.size() - scanner_.bytes_up_to_line_end() + 1;
        require_room("points", points, bytes / least_point_bytes);
        require_room("faces", faces,
                     (bytes - least_point_bytes * points) / least_face_bytes);
        return {static_cast<std::size_t>(points), static_cast<std::size_t>(faces)};
    }

    // Reads one count, which must not be negative.
    std::int64_t read_count(const std::string& things)
    {
        const std::int64_t count = scanner_.whole_number();
        if (count < 0)
            throw complaint(source_, "E_COUNT", place(),
                            "header claims " + std::to_string(count) + ' ' + things,
                            "0 or more");
        return count;
    }

    // Refuses a count that the file is too short for, before memory is allocated for it.
    void require_room(const std::string& things, std::int64_t count, std::uint64_t most)
    {
        if (static_cast<std::uint64_t>(count) > most)
            throw complaint(source_, "E_COUNT", place(),
                            "header claims " + std::to_string(count) + ' ' + things +
                                ", file of " + std::to_string(source_.content.size()) +
                                " bytes can hold at most " + std::to_string(most),
                            "");
    }

    // Goes to the line of the next item. If there is none, the header claimed too many.
    void go_to_next_line(const char* things, std::size_t number, std::size_t count)
    {
        if (!scanner_.next_line())
            throw complaint(source_, "E_COUNT", place(),
                            "header claims " + std::to_string(count) + ' ' + things +
                                ", file ends after " + std::to_string(number),
                            "");
    }

    // Reads one point. Numbers after it are allowed if the keyword announced them.
    void read_point(RawMeshBuilder& mesh)
    {
        mesh.add_point(scan_point_mm(scanner_, source_));
        while (has_more_of_point_ && !scanner_.at_line_end())
            scanner_.number();
        scanner_.expect_line_end();
    }

    // Reads one face: the number of corners, their indices, and up to four colour
    // numbers.
    void read_face(RawMeshBuilder& mesh)
    {
        const std::int64_t count = scanner_.whole_number();
        if (count < 0)
            throw complaint(source_, "E_COUNT", place(),
                            "a face of " + std::to_string(count) + " corners",
                            "at least 3");
        corners_.clear();
        for (std::int64_t i = 0; i < count; ++i)
            corners_.push_back(
                point_number(source_, scanner_.whole_number(), mesh.points(), place()));
        mesh.add_face(corners_, place());
        for (int i = 0; i < most_colour_numbers && !scanner_.at_line_end(); ++i)
            scanner_.number();
        scanner_.expect_line_end();
    }

    // The current line.
    FilePlace place() const { return FilePlace::line(scanner_.line()); }

    const MeshSource& source_;
    TextScanner scanner_;
    bool has_more_of_point_ = false;
    std::vector<std::int32_t> corners_;
};

}  // namespace

RawMesh parse_off(const MeshSource& source)
{
    return OffReader{source}.read();
}

std::string off_text(const TriangleMesh& mesh)
{
    std::string text = "OFF\n# mesh in mm, written by endmill\n";
    text += std::to_string(mesh.points().size()) + ' ' +
            std::to_string(mesh.triangles().size()) + " 0\n";
    for (const Vec3& point : mesh.points()) {
        append_text(text, point.x());
        text += ' ';
        append_text(text, point.y());
        text += ' ';
        append_text(text, point.z());
        text += '\n';
    }
    for (const Triangle& triangle : mesh.triangles()) {
        text += '3';
        for (const std::int32_t corner : triangle)
            text += ' ' + std::to_string(corner);
        text += '\n';
    }
    return text;
}

}  // namespace endmill
