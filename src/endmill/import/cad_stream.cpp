// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/import/cad_stream.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/files/detail/strict_json.h"

namespace endmill {
namespace {

static_assert(std::endian::native == std::endian::little,
              "numbers are copied between the answer and memory without conversion");

constexpr std::string_view magic = "endmill-cad/1\n";
constexpr std::size_t longest_label = 200;  // characters of a name or a unit
constexpr std::array<std::string_view, 11> kinds{
    "plane", "cylinder",   "cone",      "sphere", "torus", "bezier",
    "nurbs", "revolution", "extrusion", "offset", "other"};
constexpr std::int64_t most_items = std::numeric_limits<std::int32_t>::max();

// A damaged answer.
FormatError damaged(const std::filesystem::path& path, const std::string& what)
{
    return {"E_CAD",
            {shown_path(path), "", "endmill-cad gave a damaged answer: " + what, ""}};
}

// The bytes of an answer that have not been read yet.
class Rest {
public:
    Rest(std::string_view bytes, const std::filesystem::path& path)
        : bytes_{bytes},
          path_{path}
    {
    }

    std::size_t size() const { return bytes_.size(); }

    std::string_view take(std::size_t count)
    {
        if (count > bytes_.size())
            throw damaged(path_, "it ends early");
        const std::string_view taken = bytes_.substr(0, count);
        bytes_.remove_prefix(count);
        return taken;
    }

    // The next `count` items, after a check that there are so many.
    template <typename Item>
    std::vector<Item> items(std::size_t count)
    {
        if (count > bytes_.size() / sizeof(Item))
            throw damaged(path_, "it ends early");
        std::vector<Item> all(count);
        const std::string_view bytes = take(count * sizeof(Item));
        if (count > 0)
            std::memcpy(static_cast<void*>(all.data()), bytes.data(), bytes.size());
        return all;
    }

private:
    std::string_view bytes_;
    const std::filesystem::path& path_;
};

class StreamReader {
public:
    StreamReader(std::string_view bytes, const std::filesystem::path& path,
                 const ReadLimits& limits)
        : rest_{bytes, path},
          path_{path},
          limits_{limits}
    {
    }

    CadPart read();

private:
    void read_head(const JsonValue& head);
    void read_face(const JsonValue& value);
    void read_measures(const JsonValue& value);
    std::optional<CadFaceBalls> balls_in(const JsonValue& value) const;
    void read_mesh();
    void read_spline(std::size_t number);
    Vec3 within_extent(const std::array<double, 3>& point) const;
    std::size_t count(const JsonValue& object, std::string_view key) const;

    // A spline that is announced in the head.
    struct Announced {
        std::size_t face;
        int degree_u;
        int degree_v;
        std::size_t points_u;
        std::size_t points_v;
        bool is_rational;
    };

    Rest rest_;
    const std::filesystem::path& path_;
    const ReadLimits& limits_;
    std::size_t points_ = 0;
    std::size_t triangles_ = 0;
    std::vector<Announced> splines_;
    CadPart part_{};
};

std::size_t StreamReader::count(const JsonValue& object, std::string_view key) const
{
    return static_cast<std::size_t>(object.member(key).whole_number(0, most_items));
}

// A text of the file for messages and tables.
std::string label(const JsonValue& object, std::string_view key)
{
    const auto value = object.find_member(key);
    return value ? printable(value->text(), longest_label) : std::string{};
}

bool is_colour(std::string_view text)
{
    const auto is_digit = [](char c) {
        return ('0' <= c && c <= '9') || ('a' <= c && c <= 'f');
    };
    constexpr std::size_t length = 7;
    return text.size() == length && text[0] == '#' &&
           std::all_of(text.begin() + 1, text.end(), is_digit);
}

void StreamReader::read_face(const JsonValue& value)
{
    constexpr std::array<std::string_view, 6> keys{"kind", "trimmed", "reversed",
                                                   "name", "colour",  "surface"};
    value.allow_only(keys);
    CadFace face{std::string{value.member("kind").word(kinds)},
                 value.member("trimmed").truth(),
                 value.member("reversed").truth(),
                 label(value, "name"),
                 label(value, "colour"),
                 {}};
    if (!face.colour.empty() && !is_colour(face.colour))
        throw damaged(path_, "a colour is " + printable(face.colour, 20));
    if (const auto surface = value.find_member("surface")) {
        constexpr std::array<std::string_view, 5> spline_keys{
            "degree_u", "degree_v", "points_u", "points_v", "rational"};
        surface->allow_only(spline_keys);
        constexpr std::int64_t most = 1000;  // degrees that a CAD library may have
        splines_.push_back(
            {part_.faces.size(),
             static_cast<int>(surface->member("degree_u").whole_number(1, most)),
             static_cast<int>(surface->member("degree_v").whole_number(1, most)),
             count(*surface, "points_u"), count(*surface, "points_v"),
             surface->member("rational").truth()});
    }
    part_.faces.push_back(std::move(face));
}

// The radii of two balls, 0 without limit; an empty array for a face without them.
std::optional<CadFaceBalls> StreamReader::balls_in(const JsonValue& value) const
{
    if (value.size() == 0)
        return std::nullopt;
    if (value.size() != 2)
        throw damaged(path_, "trimmed_balls_mm has no two radii");
    const auto radius = [&](std::size_t k) -> std::optional<double> {
        const double given = value.item(k).number();
        if (!(given >= 0))
            throw damaged(path_, "the radius of a ball is below 0");
        return given > 0 ? std::optional{given} : std::nullopt;
    };
    return CadFaceBalls{radius(0), radius(1)};
}

void StreamReader::read_measures(const JsonValue& value)
{
    constexpr std::array<std::string_view, 5> keys{"face_areas_mm2", "trimmed_balls_mm",
                                                   "area_mm2", "volume_mm3", "centre_mm"};
    value.allow_only(keys);
    CadMeasures measures{};
    const JsonValue areas = value.member("face_areas_mm2");
    if (areas.size() != part_.faces.size())
        throw damaged(path_, "it has another number of areas than faces");
    for (std::size_t k = 0; k < areas.size(); ++k)
        measures.face_areas_mm2.push_back(areas.item(k).number());
    const JsonValue balls = value.member("trimmed_balls_mm");
    if (balls.size() != part_.faces.size())
        throw damaged(path_, "it has balls for another number of faces");
    for (std::size_t k = 0; k < balls.size(); ++k)
        measures.trimmed_balls.push_back(balls_in(balls.item(k)));
    measures.area_mm2 = value.member("area_mm2").number();
    if (const auto volume = value.find_member("volume_mm3"))
        measures.volume_mm3 = volume->number();
    const JsonValue centre = value.member("centre_mm");
    if (centre.size() != 3)
        throw damaged(path_, "centre_mm has no three numbers");
    for (std::size_t c = 0; c < 3; ++c)
        measures.centre_mm[static_cast<int>(c)] = centre.item(c).number();
    part_.measures = std::move(measures);
}

void StreamReader::read_head(const JsonValue& head)
{
    constexpr std::array<std::string_view, 10> keys{
        "unit",   "sewn",      "lost_faces", "solids", "shells",
        "points", "triangles", "unmeshed",   "faces",  "measures"};
    head.allow_only(keys);
    part_.unit = label(head, "unit");
    part_.is_sewn = head.member("sewn").truth();
    part_.lost_faces = count(head, "lost_faces");
    part_.solids = count(head, "solids");
    part_.shells = count(head, "shells");
    points_ = count(head, "points");
    triangles_ = count(head, "triangles");
    const JsonValue faces = head.member("faces");
    for (std::size_t k = 0; k < faces.size(); ++k)
        read_face(faces.item(k));
    if (part_.faces.empty())
        throw damaged(path_, "it has no faces");
    if (const auto measures = head.find_member("measures"))
        read_measures(*measures);
    const JsonValue unmeshed = head.member("unmeshed");
    for (std::size_t k = 0; k < unmeshed.size(); ++k)
        part_.unmeshed_faces.push_back(
            static_cast<std::size_t>(unmeshed.item(k).whole_number(
                0, static_cast<std::int64_t>(part_.faces.size()) - 1)));
}

Vec3 StreamReader::within_extent(const std::array<double, 3>& point) const
{
    for (const double coordinate : point) {
        if (!std::isfinite(coordinate))
            throw damaged(path_, "a coordinate is not finite");
        if (std::abs(coordinate) > limits_.max_extent_mm)
            throw FormatError{
                "E_RANGE",
                {shown_path(path_), "", "coordinate " + to_text(coordinate) + " mm",
                 "at most " + to_text(limits_.max_extent_mm) + " mm (--max-extent)"}};
    }
    return {point[0], point[1], point[2]};
}

void StreamReader::read_mesh()
{
    const auto raw = rest_.items<std::array<double, 3>>(points_);
    std::vector<Triangle> triangles = rest_.items<Triangle>(triangles_);
    part_.triangle_faces = rest_.items<std::int32_t>(triangles_);
    std::vector<Vec3> points;
    points.reserve(raw.size());
    for (const auto& point : raw)
        points.push_back(within_extent(point));
    const auto is_below = [](std::int32_t number, std::size_t most) {
        return number >= 0 && static_cast<std::size_t>(number) < most;
    };
    for (const Triangle& triangle : triangles)
        for (const std::int32_t corner : triangle)
            if (!is_below(corner, points_))
                throw damaged(path_, "there is no point " + std::to_string(corner));
    for (const std::int32_t face : part_.triangle_faces)
        if (!is_below(face, part_.faces.size()))
            throw damaged(path_, "there is no face " + std::to_string(face));
    part_.mesh = {std::move(points), std::move(triangles)};
}

// Why a spline is no valid surface; empty if it is.
std::string fault_of(const Nurbs& spline)
{
    for (const SplineParameter* parameter : {&spline.u, &spline.v})
        if (std::string fault = flaw(*parameter); !fault.empty())
            return fault;
    if (!std::ranges::all_of(spline.weights,
                             [](double w) { return std::isfinite(w) && w > 0; }))
        return "a weight is not above 0";
    const Vec3& first = spline.control_points.front();
    if (std::ranges::all_of(spline.control_points,
                            [&](const Vec3& point) { return point == first; }))
        return "all control points are equal";
    return {};
}

void StreamReader::read_spline(std::size_t number)
{
    const Announced& spline = splines_[number];
    Nurbs nurbs{{spline.degree_u, {}}, {spline.degree_v, {}}, {}, {}};
    const auto knots_of = [&](int degree, std::size_t points) {
        return rest_.items<double>(points + static_cast<std::size_t>(degree) + 1);
    };
    nurbs.u.knots = knots_of(spline.degree_u, spline.points_u);
    nurbs.v.knots = knots_of(spline.degree_v, spline.points_v);
    // Both are at most 2^31 - 1.
    const std::size_t points = spline.points_u * spline.points_v;
    if (points == 0)
        throw damaged(path_, "a surface has no points");
    for (const auto& point : rest_.items<std::array<double, 3>>(points))
        nurbs.control_points.push_back(within_extent(point));
    if (spline.is_rational)
        nurbs.weights = rest_.items<double>(points);
    if (const std::string fault = fault_of(nurbs); !fault.empty()) {
        part_.notes.push_back("the surface of face " + std::to_string(spline.face + 1) +
                              " is left out: " + fault);
        return;
    }
    part_.faces[spline.face].surface = std::move(nurbs);
}

CadPart StreamReader::read()
{
    if (rest_.size() < magic.size() || rest_.take(magic.size()) != magic)
        throw damaged(path_, "it does not begin with endmill-cad/1");
    const std::uint64_t length = rest_.items<std::uint64_t>(1).front();
    if (length > rest_.size())
        throw damaged(path_, "its head ends early");
    try {
        const JsonDocument head{rest_.take(length), "its head", limits_};
        read_head(head.root());
    } catch (const FormatError& error) {
        if (error.code() == "E_CAD")
            throw;
        throw damaged(path_, error.what());
    }
    // The arrays become vectors of the same size, and the mesh of a part a second one.
    constexpr double copies = 3;
    require_memory(shown_path(path_), copies * static_cast<double>(rest_.size()),
                   limits_);
    read_mesh();
    for (std::size_t k = 0; k < splines_.size(); ++k)
        read_spline(k);
    if (rest_.size() > 0)
        throw damaged(path_, "it goes on after its end");
    if (triangles_ == 0)
        throw FormatError{
            "E_CAD",
            {shown_path(path_), "", "none of its faces can be meshed", "at least one"}};
    return std::move(part_);
}

}  // namespace

CadPart parse_cad_stream(std::string_view bytes, const std::filesystem::path& path,
                         const ReadLimits& limits)
{
    CadPart part = StreamReader{bytes, path, limits}.read();
    if (part.unit.empty())
        part.notes.emplace_back("the file names no unit of length; it is read as mm");
    if (part.lost_faces > 0)
        part.notes.push_back(counted(part.lost_faces, "face") +
                             " of the file cannot be read and " +
                             (part.lost_faces == 1 ? "is" : "are") + " missing");
    if (!part.unmeshed_faces.empty())
        part.notes.push_back(counted(part.unmeshed_faces.size(), "face") +
                             " could not be meshed, the first is face " +
                             std::to_string(part.unmeshed_faces.front() + 1));
    return part;
}

}  // namespace endmill
