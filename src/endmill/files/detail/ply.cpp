// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/ply_header.h"

// Steps of reading a PLY file:
//
// 1. The header declares elements and their properties (ply_header.h).
// 2. LayoutCheck finds the used properties: x, y, z of "vertex", the list of corners of
//    "face", and its number in a CAD model if there is one.
// 3. BodyReader reads all items in order and skips unused properties. AsciiItems and
//    BinaryItems give it the numbers, so the reading is the same for all encodings.
//
// A count that the header or a list claims is never trusted: memory is allocated only
// after a check that so many numbers fit into the rest of the file.

namespace endmill {
namespace {

static_assert(std::endian::native == std::endian::little,
              "numbers are copied between file and memory without conversion");

constexpr std::size_t longest_echo = 40;
constexpr std::size_t least_corners = 3;  // a face with fewer corners is refused
// Memory for a corner while its face is split: its index twice and its point
// (raw_mesh.h).
constexpr double bytes_per_corner = 2 * sizeof(std::int32_t) + sizeof(Vec3);

// The numbers after an ASCII header; each item has a line of its own.
class AsciiItems {
public:
    // Skips the lines of the header.
    AsciiItems(const MeshSource& source, const PlyHeader& header)
        : scanner_{source.content, {source.file, "E_PLY_SYNTAX"}}
    {
        while (scanner_.bytes_up_to_line_end() < header.bytes)
            scanner_.next_line();
        scanner_.skip_line();
    }

    bool begin_item() { return scanner_.next_line(); }
    void end_item() { scanner_.expect_line_end(); }
    bool at_end() { return !scanner_.next_line(); }
    FilePlace place() const { return FilePlace::line(scanner_.line()); }
    double number(PlyType /*type*/) { return scanner_.number(); }
    std::int64_t whole_number(PlyType /*type*/) { return scanner_.whole_number(); }
    std::size_t bytes_left() const { return scanner_.bytes_left_in_line(); }

    // Skips `count` numbers without converting them.
    void skip(PlyType /*type*/, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            if (scanner_.word().empty())
                throw scanner_.complaint_about({}, "a number");
    }

    // A number takes at least one digit and the white space after it.
    static std::size_t least_bytes(PlyType /*type*/) { return 2; }

private:
    TextScanner scanner_;
};

// The numbers after a binary header, without gaps.
class BinaryItems {
public:
    // Starts after the header.
    BinaryItems(const MeshSource& source, const PlyHeader& header)
        : source_{source},
          is_reversed_{header.encoding == PlyEncoding::BigEndian},
          at_{header.bytes}
    {
    }

    bool begin_item() const { return bytes_left() > 0; }
    void end_item() const {}
    bool at_end() const { return bytes_left() == 0; }
    FilePlace place() const { return FilePlace::byte(at_); }
    std::size_t bytes_left() const { return source_.content.size() - at_; }
    static std::size_t least_bytes(PlyType type) { return size_of(type); }

    // The next number as a double, whatever its type is.
    double number(PlyType type)
    {
        if (type == PlyType::Float32)
            return take<float>();
        if (type == PlyType::Float64)
            return take<double>();
        return static_cast<double>(whole_number(type));
    }

    // The next number of a whole type. All these types fit into 64 bits.
    std::int64_t whole_number(PlyType type)
    {
        switch (type) {
            case PlyType::Int8:
                return take<std::int8_t>();
            case PlyType::Uint8:
                return take<std::uint8_t>();
            case PlyType::Int16:
                return take<std::int16_t>();
            case PlyType::Uint16:
                return take<std::uint16_t>();
            case PlyType::Int32:
                return take<std::int32_t>();
            default:
                return take<std::uint32_t>();
        }
    }

    // Skips `count` numbers, after a check that the file has them.
    void skip(PlyType type, std::size_t count)
    {
        require_bytes(size_of(type) * count);
        at_ += size_of(type) * count;
    }

private:
    template <class Number>
    Number take()
    {
        require_bytes(sizeof(Number));
        std::array<char, sizeof(Number)> bytes;
        std::memcpy(bytes.data(), source_.content.data() + at_, bytes.size());
        if (is_reversed_)
            std::ranges::reverse(bytes);
        at_ += bytes.size();
        return std::bit_cast<Number>(bytes);
    }

    // Checks that the file has `count` more bytes.
    void require_bytes(std::size_t count) const
    {
        if (count > bytes_left())
            throw complaint(source_, "E_COUNT", place(), "end of file within an item",
                            std::to_string(count) + " bytes of a number");
    }

    const MeshSource& source_;
    bool is_reversed_;
    std::size_t at_;
};

// The use of a property.
enum class Role { X, Y, Z, Corners, FaceNumber, Skipped };

// The role of a property by the names of its element and its own.
Role role_of(const PlyElement& element, const PlyProperty& property)
{
    if (element.name == "vertex" && property.name == "x")
        return Role::X;
    if (element.name == "vertex" && property.name == "y")
        return Role::Y;
    if (element.name == "vertex" && property.name == "z")
        return Role::Z;
    if (element.name == "face" &&
        (property.name == "vertex_indices" || property.name == "vertex_index"))
        return Role::Corners;
    if (element.name == "face" && property.name == "face_number")
        return Role::FaceNumber;
    return Role::Skipped;
}

// Checks that the header declares what a mesh needs, and finds it.
class LayoutCheck {
public:
    LayoutCheck(const MeshSource& source, const PlyHeader& header)
        : source_{source},
          header_{header}
    {
    }

    // Checks the elements, their order, and the types of the used properties.
    void run() const
    {
        const PlyElement& points = element("vertex");
        const PlyElement& faces = element("face");
        if (&faces < &points)
            throw complaint_about(faces, "the faces come before the points",
                                  "element vertex, then element face");
        for (const Role role : {Role::X, Role::Y, Role::Z})
            if (property(points, role).count_type)
                throw complaint_about(points, "a coordinate is a list", "a number");
        const PlyProperty& corners = property(faces, Role::Corners);
        if (!corners.count_type || !is_whole(corners.type))
            throw complaint_about(faces, "the corners are not a list of whole numbers",
                                  "such as property list uchar int vertex_indices");
        if (std::ranges::any_of(faces.properties, [&](const PlyProperty& property) {
                return role_of(faces, property) == Role::FaceNumber &&
                       (property.count_type || !is_whole(property.type));
            }))
            throw complaint_about(faces, "face_number is not a whole number",
                                  "such as property int face_number");
    }

    // The element of this name, which must exist.
    const PlyElement& element(std::string_view name) const
    {
        const auto found = std::ranges::find(header_.elements, name, &PlyElement::name);
        if (found == header_.elements.end())
            throw complaint(source_, "E_PLY_SYNTAX", FilePlace::line(header_.lines),
                            "no element " + std::string{name}, "vertex and face");
        return *found;
    }

    // The property with this role, which must occur exactly once.
    const PlyProperty& property(const PlyElement& element, Role role) const
    {
        const PlyProperty* found = nullptr;
        for (const PlyProperty& property : element.properties) {
            if (role_of(element, property) != role)
                continue;
            if (found != nullptr)
                throw complaint_about(element, "two lists of corners", "one");
            found = &property;
        }
        if (found == nullptr)
            throw complaint_about(
                element, "a property is missing",
                role == Role::Corners ? "vertex_indices" : "x, y and z");
        return *found;
    }

private:
    FormatError complaint_about(const PlyElement& element, const std::string& found,
                                const std::string& expected) const
    {
        return complaint(source_, "E_PLY_SYNTAX", FilePlace::line(element.line), found,
                         expected);
    }

    const MeshSource& source_;
    const PlyHeader& header_;
};

// Reads the items after the header. `Items` is AsciiItems or BinaryItems.
template <class Items>
class BodyReader {
public:
    BodyReader(const MeshSource& source, const PlyHeader& header)
        : source_{source},
          header_{header},
          items_{source, header},
          mesh_{sized_builder(source, header)}
    {
    }

    // Reads the items of all elements in the order of the header.
    RawMesh read()
    {
        for (const PlyElement& element : header_.elements)
            read_element(element);
        if (!items_.at_end())
            throw complaint(source_, "E_COUNT", items_.place(),
                            "file goes on after all items that the header claims", "");
        RawMesh mesh = mesh_.take();
        mesh.face_numbers = std::move(face_numbers_);
        return mesh;
    }

private:
    // Reserves memory for no more faces than the file can hold, whatever the header
    // claims.
    static RawMeshBuilder sized_builder(const MeshSource& source, const PlyHeader& header)
    {
        const LayoutCheck layout{source, header};
        const PlyElement& faces = layout.element("face");
        const PlyType type = layout.property(faces, Role::Corners).type;
        const std::size_t most =
            source.content.size() / (least_corners * Items::least_bytes(type));
        return {source, layout.element("vertex").count,
                std::min<std::size_t>(faces.count, most)};
    }

    // Reads all items of one element. The roles of its properties are found once.
    void read_element(const PlyElement& element)
    {
        std::vector<Role> roles;
        for (const PlyProperty& property : element.properties)
            roles.push_back(role_of(element, property));
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (!items_.begin_item())
                throw complaint(source_, "E_COUNT", items_.place(),
                                "header claims " + std::to_string(element.count) +
                                    " items \"" + printable(element.name, longest_echo) +
                                    "\", file ends after " + std::to_string(i),
                                "");
            read_item(element, roles);
            items_.end_item();
        }
    }

    // Reads one item property by property, then adds the point or face that it is.
    void read_item(const PlyElement& element, std::span<const Role> roles)
    {
        const FilePlace place = items_.place();
        Vec3 coordinates;
        for (std::size_t i = 0; i < roles.size(); ++i) {
            const PlyProperty& property = element.properties[i];
            if (roles[i] == Role::Corners)
                read_corners(property);
            else if (roles[i] == Role::FaceNumber)
                face_number_ = read_face_number(property);
            else if (roles[i] == Role::Skipped)
                items_.skip(property.type,
                            property.count_type ? list_length(property) : 1);
            else
                coordinates[static_cast<int>(roles[i])] = items_.number(property.type);
        }
        if (element.name == "vertex")
            mesh_.add_point(point_mm(source_, coordinates, place));
        if (element.name == "face")
            add_face(place);
    }

    // Adds a face with its number, if faces have one.
    void add_face(FilePlace place)
    {
        mesh_.add_face(corners_, place);
        if (face_number_ > 0)
            face_numbers_.resize(mesh_.triangles(), face_number_);
    }

    std::int32_t read_face_number(const PlyProperty& property)
    {
        const FilePlace place = items_.place();
        const std::int64_t number = items_.whole_number(property.type);
        if (number < 1 || number > std::numeric_limits<std::int32_t>::max())
            throw complaint(source_, "E_INDEX", place,
                            "face number " + std::to_string(number), "1 or more");
        return static_cast<std::int32_t>(number);
    }

    // Reads the indices of a face. The memory for a single face is checked too: one face
    // can have as many corners as the file has bytes.
    void read_corners(const PlyProperty& property)
    {
        const std::size_t count = list_length(property);
        require_memory(source_.file,
                       static_cast<double>(source_.content.size()) +
                           sizeof(Vec3) * static_cast<double>(mesh_.points()) +
                           bytes_per_corner * static_cast<double>(count),
                       source_.limits);
        corners_.clear();
        corners_.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            const FilePlace place = items_.place();
            corners_.push_back(point_number(source_, items_.whole_number(property.type),
                                            mesh_.points(), place));
        }
    }

    // The length of a list, after a check that its numbers fit into the rest of the file
    // or line.
    std::size_t list_length(const PlyProperty& property)
    {
        const FilePlace place = items_.place();
        const std::int64_t count = items_.whole_number(*property.count_type);
        if (count < 0)
            throw complaint(source_, "E_COUNT", place,
                            "a list of " + std::to_string(count) + " numbers",
                            "0 or more");
        const std::size_t most = items_.bytes_left() / Items::least_bytes(property.type);
        if (static_cast<std::uint64_t>(count) > most)
            throw complaint(source_, "E_COUNT", place,
                            "a list of " + std::to_string(count) + " numbers where " +
                                std::to_string(items_.bytes_left()) +
                                " bytes can hold at most " + std::to_string(most),
                            "");
        return static_cast<std::size_t>(count);
    }

    const MeshSource& source_;
    const PlyHeader& header_;
    Items items_;
    RawMeshBuilder mesh_;
    std::vector<std::int32_t> corners_;
    std::int32_t face_number_ = 0;  // of the face that was read last; 0: faces have none
    std::vector<std::int32_t> face_numbers_;
};

template <class Number>
void append_bytes(std::string& text, Number number)
{
    const auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    text.append(bytes.data(), bytes.size());
}

void append_doubles(std::string& text, const Vec3& vector)
{
    for (int c = 0; c < 3; ++c)
        append_bytes(text, vector[c]);
}

}  // namespace

// The loop over items is compiled separately for ASCII and binary files, because the type
// of a number is looked up for every number.
RawMesh parse_ply(const MeshSource& source)
{
    const PlyHeader header = parse_ply_header(source);
    LayoutCheck{source, header}.run();
    if (header.encoding == PlyEncoding::Ascii)
        return BodyReader<AsciiItems>{source, header}.read();
    return BodyReader<BinaryItems>{source, header}.read();
}

std::string ply_text(const TriangleMesh& mesh, std::span<const Vec3> normals,
                     std::span<const std::int32_t> face_numbers)
{
    const auto points = mesh.points();
    require(normals.empty() || normals.size() == points.size(),
            "ply_text: need one normal per point, or none");
    require(std::ranges::all_of(normals, [](const Vec3& n) { return n.allFinite(); }),
            "ply_text: normals must be finite");
    require(face_numbers.empty() || face_numbers.size() == mesh.triangles().size(),
            "ply_text: need one face number per triangle, or none");
    std::string text =
        "ply\nformat binary_little_endian 1.0\ncomment mesh in mm, written by endmill\n";
    text += "element vertex " + std::to_string(points.size()) +
            "\nproperty double x\nproperty double y\nproperty double z\n";
    if (!normals.empty())
        text += "property double nx\nproperty double ny\nproperty double nz\n";
    text += "element face " + std::to_string(mesh.triangles().size()) +
            "\nproperty list uchar int vertex_indices\n";
    if (!face_numbers.empty())
        text += "property int face_number\n";
    text += "end_header\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
        append_doubles(text, points[i]);
        if (!normals.empty())
            append_doubles(text, normals[i]);
    }
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
        text += '\x03';
        for (const std::int32_t corner : mesh.triangles()[i])
            append_bytes(text, corner);
        if (!face_numbers.empty())
            append_bytes(text, face_numbers[i]);
    }
    return text;
}

}  // namespace endmill
