// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstring>

#include "endmill/import/cad_stream.h"
#include "fuzz_program.h"

// An answer of endmill-cad that is read is a sound part, or the reader throws a documented
// error. The length of the head is also corrected, because a fuzzer would rarely find it: up
// to the last closing brace.
namespace {

void read(std::string_view content)
{
    using namespace endmill;
    constexpr double most = 1e6;
    try {
        const CadPart part = parse_cad_stream(
            content, "f.step", {.max_extent_mm = most, .max_memory_gib = 0.25});
        program_must(!part.faces.empty());
        program_must(part.triangle_faces.size() == part.mesh.triangles().size());
        for (const std::int32_t face : part.triangle_faces)
            program_must(static_cast<std::size_t>(face) < part.faces.size());
        for (const Vec3& point : part.mesh.points())
            program_must(point.lpNorm<Eigen::Infinity>() <= most);
        for (const CadFace& face : part.faces) {
            program_must(is_fit_for_a_terminal(face.name) &&
                         is_fit_for_a_terminal(face.colour));
            if (face.surface)
                nurbs_surface(*face.surface);
        }
        part_of_cad(part, "f.step", {.limits = {.max_memory_gib = 0.25}});
    } catch (const FormatError& error) {
        program_must(error.file() == "f.step" && is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    constexpr std::size_t begin = 14;
    std::string content{reinterpret_cast<const char*>(bytes), size};
    read(content);
    const std::size_t end = content.rfind('}');
    if (end == std::string::npos || end < begin + sizeof(std::uint64_t))
        return 0;
    const std::uint64_t length = end + 1 - begin - sizeof(std::uint64_t);
    std::memcpy(content.data() + begin, &length, sizeof length);
    read(content);
    return 0;
}
