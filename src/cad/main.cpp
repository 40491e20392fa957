// SPDX-License-Identifier: GPL-3.0-or-later
// endmill-cad: reads a STEP or IGES file from its standard input and writes meshes and spline
// surfaces to its standard output, for `endmill import`, which starts it with limits.
//
//   endmill-cad step|iges CHORD_MM ANGLE_RAD MOST_FACES measured|plain < FILE
//
// The answer is the line "endmill-cad/1", the length of a JSON text as eight bytes, the text,
// and the numbers that the text counts: see src/endmill/import/README.md. The last line of the
// standard error that begins with "endmill-cad: " is the error. Exit status: 0 done, 3 not a
// sound file, 6 a limit, 7 anything else.

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TopExp_Explorer.hxx>
#include <nlohmann/json.hpp>

#include <sys/resource.h>
#include <unistd.h>

#include "cad/cad_model.h"
#include "cad/face_surface.h"
#include "cad/model_mesh.h"

namespace endmill::cad {
namespace {

using Json = nlohmann::json;

constexpr std::string_view magic = "endmill-cad/1\n";
constexpr int status_bad_file = 3;
constexpr int status_limit = 6;
constexpr int status_fault = 7;
constexpr const char* input = "/proc/self/fd/0";

struct Settings {
    FileKind kind;
    MeshTolerances tolerances;
    std::size_t most_faces;
    bool is_measured;  // whether areas, volume and centre of mass are integrated
};

template <typename Number>
Number number_in(const char* text)
{
    Number number{};
    const char* const end = text + std::strlen(text);
    const auto [after, error] = std::from_chars(text, end, number);
    if (error != std::errc{} || after != end)
        throw std::invalid_argument{
            "expected step|iges CHORD_MM ANGLE_RAD MOST_FACES measured|plain"};
    return number;
}

Settings settings_of(int count, char** words)
{
    constexpr int expected = 6;
    if (count != expected)
        throw std::invalid_argument{
            "expected step|iges CHORD_MM ANGLE_RAD MOST_FACES measured|plain"};
    return {std::string_view{words[1]} == "iges" ? FileKind::Iges : FileKind::Step,
            {number_in<double>(words[2]), number_in<double>(words[3])},
            number_in<std::size_t>(words[4]),
            std::string_view{words[5]} == "measured"};
}

// The standard output, kept for the answer alone: what libraries print goes to the standard
// error.
class Answer {
public:
    Answer() : file_{fdopen(dup(STDOUT_FILENO), "wb")}
    {
        dup2(STDERR_FILENO, STDOUT_FILENO);
        if (file_ == nullptr)
            throw std::runtime_error{"no standard output"};
    }
    ~Answer() { std::fclose(file_); }
    Answer(const Answer&) = delete;
    Answer& operator=(const Answer&) = delete;

    void write(const void* bytes, std::size_t count)
    {
        if (count > 0 && std::fwrite(bytes, 1, count, file_) != count)
            throw std::runtime_error{"the answer cannot be written"};
    }
    template <typename Item>
    void write_all(const std::vector<Item>& items)
    {
        write(items.data(), items.size() * sizeof(Item));
    }
    void finish()
    {
        if (std::fflush(file_) != 0)
            throw std::runtime_error{"the answer cannot be written"};
    }

private:
    std::FILE* file_;
};

template <typename Knots, typename Counts>
void append_knots(std::vector<double>& numbers, const Knots& knots, const Counts& counts)
{
    for (int i = knots.Lower(); i <= knots.Upper(); ++i)
        numbers.insert(numbers.end(), static_cast<std::size_t>(counts(i)), knots(i));
}

// Adds a spline to the head and its numbers to `numbers`: the knots in u and v, then the
// points, u fastest, then the weights if they differ.
Json spline_head(const Geom_BSplineSurface& spline, std::vector<double>& numbers)
{
    append_knots(numbers, spline.UKnots(), spline.UMultiplicities());
    append_knots(numbers, spline.VKnots(), spline.VMultiplicities());
    const bool is_rational = spline.IsURational() || spline.IsVRational();
    for (int v = 1; v <= spline.NbVPoles(); ++v)
        for (int u = 1; u <= spline.NbUPoles(); ++u) {
            const gp_Pnt pole = spline.Pole(u, v);
            numbers.insert(numbers.end(), {pole.X(), pole.Y(), pole.Z()});
        }
    if (is_rational)
        for (int v = 1; v <= spline.NbVPoles(); ++v)
            for (int u = 1; u <= spline.NbUPoles(); ++u)
                numbers.push_back(spline.Weight(u, v));
    return {{"degree_u", spline.UDegree()},
            {"degree_v", spline.VDegree()},
            {"points_u", spline.NbUPoles()},
            {"points_v", spline.NbVPoles()},
            {"rational", is_rational}};
}

int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind,
             TopAbs_ShapeEnum apart_from = TopAbs_SHAPE)
{
    int count = 0;
    for (TopExp_Explorer item{shape, kind, apart_from}; item.More(); item.Next())
        ++count;
    return count;
}

Json face_head(const ModelFace& face, std::vector<double>& numbers)
{
    const bool trimmed = is_trimmed(face.face);
    Json head{{"kind", std::string{surface_kind(face.face)}},
              {"trimmed", trimmed},
              {"reversed", face.face.Orientation() == TopAbs_REVERSED}};
    if (!face.name.empty())
        head["name"] = face.name;
    if (!face.colour.empty())
        head["colour"] = face.colour;
    if (trimmed)
        return head;
    const Handle(Geom_BSplineSurface) spline = whole_surface(face.face);
    if (!spline.IsNull())
        head["surface"] = spline_head(*spline, numbers);
    return head;
}

// The radii of the largest balls outside and inside a trimmed face, 0 without limit; an empty
// array for other faces.
Json balls_head(const TopoDS_Face& face)
{
    const std::optional<FaceBalls> balls =
        is_trimmed(face) ? balls_at_mesh(face) : std::nullopt;
    if (!balls)
        return Json::array();
    return {balls->outside.value_or(0), balls->inside.value_or(0)};
}

// The area of each face and the largest balls for a trimmed one; volume and centre of mass of the solids, or without solids the
// centre of the faces.
Json measures(const Model& model, int solids)
{
    GProp_GProps whole;
    double area = 0;
    Json areas = Json::array();
    Json balls = Json::array();
    for (const ModelFace& face : model.faces) {
        GProp_GProps of_face;
        BRepGProp::SurfaceProperties(face.face, of_face);
        areas.push_back(of_face.Mass());
        area += of_face.Mass();
        balls.push_back(balls_head(face.face));
        if (solids == 0)
            whole.Add(of_face);
    }
    if (solids > 0)
        BRepGProp::VolumeProperties(model.shape, whole);
    const gp_Pnt centre = whole.CentreOfMass();
    Json head{{"face_areas_mm2", std::move(areas)},
              {"trimmed_balls_mm", std::move(balls)},
              {"area_mm2", area},
              {"centre_mm", {centre.X(), centre.Y(), centre.Z()}}};
    if (solids > 0)
        head["volume_mm3"] = whole.Mass();
    return head;
}

// The mesher leaves out a face if it gets no memory for it. Checks that it had enough: an
// array that cannot grow is at least half as large as what is left.
void require_memory_left()
{
    rlimit most{};
    rusage used{};
    if (getrlimit(RLIMIT_AS, &most) != 0 || most.rlim_cur == RLIM_INFINITY ||
        getrusage(RUSAGE_SELF, &used) != 0)
        return;
    constexpr rlim_t bytes_per_unit = 1024;
    if (static_cast<rlim_t>(used.ru_maxrss) * bytes_per_unit > most.rlim_cur / 3)
        throw std::bad_alloc{};
}

void answer(const Settings& settings, Answer& out)
{
    const Model model = read_model(input, settings.kind, settings.most_faces);
    const ModelMesh mesh = mesh_of(model, settings.tolerances);
    if (!mesh.unmeshed.empty())
        require_memory_left();
    const int solids = count_of(model.shape, TopAbs_SOLID);
    std::vector<double> numbers;
    Json faces = Json::array();
    for (const ModelFace& face : model.faces)
        faces.push_back(face_head(face, numbers));
    Json head{{"unit", model.unit},
              {"sewn", model.is_sewn},
              {"lost_faces", model.lost_faces},
              {"solids", solids},
              {"shells", count_of(model.shape, TopAbs_SHELL, TopAbs_SOLID)},
              {"points", mesh.points.size()},
              {"triangles", mesh.triangles.size()},
              {"unmeshed", mesh.unmeshed},
              {"faces", std::move(faces)}};
    if (settings.is_measured)
        head["measures"] = measures(model, solids);
    const std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);
    const std::uint64_t length = text.size();
    out.write(magic.data(), magic.size());
    out.write(&length, sizeof length);
    out.write(text.data(), text.size());
    out.write_all(mesh.points);
    out.write_all(mesh.triangles);
    out.write_all(mesh.triangle_faces);
    out.write_all(numbers);
    out.finish();
}

// The exit status for the current exception, after a line on the standard error.
int report()
{
    const auto fail = [](int status, const char* text) {
        std::fprintf(stderr, "\nendmill-cad: %s\n", text);
        return status;
    };
    try {
        throw;
    } catch (const BadFile& error) {
        return fail(status_bad_file, error.what());
    } catch (const Limit& error) {
        return fail(status_limit, error.what());
    } catch (const std::bad_alloc&) {
        return fail(status_limit, "no memory");
    } catch (const Standard_OutOfMemory&) {
        return fail(status_limit, "no memory");
    } catch (const Standard_Failure& error) {
        return fail(status_bad_file, error.GetMessageString());
    } catch (const std::exception& error) {
        return fail(status_fault, error.what());
    } catch (...) {
        return fail(status_fault, "unknown exception");
    }
}

// Ends the program where an exception would not reach `main`.
[[noreturn]] void end_without_memory()
{
    std::fputs("\nendmill-cad: no memory\n", stderr);
    std::fflush(stderr);
    _exit(status_limit);
}

[[noreturn]] void end_after_terminate()
{
    if (std::current_exception())
        _exit(report());
    std::abort();
}

}  // namespace
}  // namespace endmill::cad

int main(int count, char** words)
{
    using namespace endmill::cad;
    try {
        std::set_new_handler(end_without_memory);
        std::set_terminate(end_after_terminate);
        const rlimit no_file{0, 0};
        setrlimit(RLIMIT_FSIZE, &no_file);
        const Settings settings = settings_of(count, words);
        Answer out;
        Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
        answer(settings, out);
    } catch (...) {
        const int status = report();
        std::fflush(nullptr);
        _exit(status);
    }
    // Nothing is released: a damaged model could still fail at its end.
    std::fflush(nullptr);
    _exit(EXIT_SUCCESS);
}
