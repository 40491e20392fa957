// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/import/cad_import.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <csignal>
#include <numbers>
#include <string_view>
#include <system_error>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/path_file.h"
#include "endmill/import/cad_stream.h"
#include "endmill/job/child_process.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

constexpr double gib = 0x1p30;

// Exit status of endmill-cad.
constexpr int status_bad_file = 3;
constexpr int status_limit = 6;

constexpr std::size_t longest_reason = 200;  // characters

std::string_view format_name(CadFormat format)
{
    return format == CadFormat::Step ? "STEP" : "IGES";
}

FormatError refused(const fs::path& file, const std::string& found,
                    const std::string& expected = "")
{
    return {"E_CAD", {shown_path(file), "", found, expected}};
}

LimitError limit_of(const fs::path& file, const std::string& what)
{
    return LimitError{shown_path(file) + ": " + what};
}

// mm; OpenCASCADE refuses smaller ones, and larger ones mean nothing.
constexpr double least_chord_tolerance = 1e-6;
constexpr double greatest_chord_tolerance = 1e6;

void require_domain(const CadImportOptions& options)
{
    require(least_chord_tolerance <= options.chord_tolerance_mm &&
                options.chord_tolerance_mm <= greatest_chord_tolerance,
            "import_cad: need a chord tolerance from 1e-6 to 1e6 mm");
    require(options.angle_deg > 0 && options.angle_deg < 180,
            "import_cad: need an angle between 0 and 180 degrees");
    require(options.limit_seconds > 0 && options.limit_gib > 0,
            "import_cad: need limits above 0");
}

// What the program wrote to its two outputs.
struct CadAnswer {
    std::string bytes;
    std::string reason;  // its own last message; empty without one
};

// Throws unless the program has ended with a complete answer.
void require_answer(const ChildResult& result, const CadAnswer& answer,
                    const fs::path& file, const CadImportOptions& options)
{
    const std::string seconds =
        to_text(options.limit_seconds) + " s (--limit-seconds of import)";
    const std::string memory =
        to_text(options.limit_gib) + " GiB (--limit-gib of import)";
    switch (result.end) {
        case ChildEnd::NotStarted:
            // Its libraries need more address space than there is, or one is missing.
            throw limit_of(file, "endmill-cad could not be loaded; its limit is " +
                                     memory + ", and that of this process may be lower");
        case ChildEnd::OutOfTime:
            throw limit_of(file, "endmill-cad was not done within " + seconds);
        case ChildEnd::FileTooLong:
        case ChildEnd::Signalled:
            if (result.code == SIGKILL)
                throw limit_of(file,
                               "endmill-cad was killed, as happens when memory runs out");
            throw refused(file, "endmill-cad crashed on this file (signal " +
                                    std::to_string(result.code) + ")" +
                                    (answer.reason.empty() ? "" : " after: ") +
                                    answer.reason + "; its limits are " + seconds +
                                    " and " + memory);
        case ChildEnd::Exited:
            break;
    }
    if (result.code == 0)
        return;
    const std::string reason = answer.reason.empty() ? "no reason given" : answer.reason;
    if (result.code == status_limit)
        throw limit_of(file, reason == "no memory"
                                 ? "endmill-cad needs more memory than " + memory
                                 : reason);
    if (result.code == status_bad_file)
        throw refused(file, reason);
    throw refused(file, "endmill-cad failed on this file: " + reason);
}

// Runs the program. Its answer may take half of the memory, since it is copied.
std::string answer_for(const fs::path& program, const fs::path& file, CadFormat format,
                       const CadImportOptions& options, const ReadLimits& limits)
{
    constexpr std::string_view prefix = "endmill-cad: ";
    constexpr int open_files = 32;
    const double most_bytes = limits.max_memory_gib * gib / 2;
    CadAnswer answer;
    ChildTask task{.program = program,
                   .arguments = {format == CadFormat::Step ? "step" : "iges",
                                 to_text(options.chord_tolerance_mm),
                                 to_text(options.angle_deg * std::numbers::pi / 180),
                                 std::to_string(options.max_faces),
                                 options.measures ? "measured" : "plain"},
                   .input = file,
                   .limits = {.wall_seconds = options.limit_seconds,
                              .processor_seconds = options.limit_seconds,
                              .address_space_bytes = options.limit_gib * gib,
                              .open_files = open_files}};
    task.output = [&](std::string_view piece) {
        if (static_cast<double>(answer.bytes.size() + piece.size()) > most_bytes)
            throw limit_of(file, "the answer of endmill-cad has more than " +
                                     to_text(most_bytes / gib) +
                                     " GiB, half of --max-memory");
        answer.bytes.append(piece);
    };
    task.error_line = [&](std::string_view line) {
        if (line.starts_with(prefix))
            answer.reason = printable(line.substr(prefix.size()), longest_reason);
    };
    require_answer(run_child(task), answer, file, options);
    return std::move(answer.bytes);
}

// A STEP file begins with these characters, perhaps after white space.
void require_step(std::string_view content, const fs::path& file)
{
    constexpr std::string_view begin = "ISO-10303-21";
    const std::size_t first = content.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first == std::string_view::npos || !content.substr(first).starts_with(begin))
        throw FormatError{"E_FORMAT",
                          {shown_path(file), "", "content is not STEP",
                           "ISO-10303-21 at its beginning"}};
}

// The content of a CAD file, after a check that it can be one.
std::string content_of(const fs::path& file, CadFormat format, const ReadLimits& limits)
{
    std::string content = read_file(file, limits);
    if (format == CadFormat::Step)
        require_step(content, file);
    return content;
}

CadFormat known_format(const fs::path& file)
{
    const auto format = cad_format(file);
    if (!format)
        throw FormatError{"E_FORMAT",
                          {shown_path(file), "", "no extension of a CAD file",
                           ".step, .stp, .iges or .igs"}};
    return *format;
}

void require_program(const fs::path& program, const fs::path& file, CadFormat format)
{
    std::error_code ignored;
    if (!program.empty() && !fs::is_regular_file(program, ignored))
        throw OutputError{"cannot find the program " + shown_path(program)};
    if (program.empty())
        throw DomainError{
            shown_path(file) + ": found " + std::string{format_name(format)} +
            ", which needs the program endmill-cad beside endmill; expected a build with "
            "OpenCASCADE (Debian: libocct-data-exchange-dev, "
            "libocct-modeling-algorithms-dev; scripts/setup.sh cad)"};
}

// An answer is kept behind its SHA-256 and a line end.
constexpr std::size_t checksum_size = 64;

// The answer in a cache; nothing if there is none, or if it is damaged.
std::optional<CadPart> kept_part(const fs::path& kept, const fs::path& file,
                                 const ReadLimits& limits)
{
    std::error_code ignored;
    if (!fs::is_regular_file(kept, ignored))
        return std::nullopt;
    try {
        const std::string content = read_file(kept, limits);
        const std::string_view all{content};
        if (all.size() <= checksum_size ||
            all.substr(0, checksum_size) != content_sha256(all.substr(checksum_size + 1)))
            return std::nullopt;
        return parse_cad_stream(all.substr(checksum_size + 1), file, limits);
    } catch (const FormatError& error) {
        if (error.code() == "E_RANGE")
            throw;
        return std::nullopt;
    }
}

// Keeps an answer if that is possible: another run may be writing it too, and a cache only
// saves time.
void keep(const fs::path& kept, const std::string& answer)
{
    try {
        write_file(kept, content_sha256(answer) + '\n' + answer);
    } catch (const OutputError&) {
    } catch (const DomainError&) {
    }
}

// What identifies the program beside its version: another build may mesh differently.
std::string build_of(const fs::path& program)
{
    std::error_code failed;
    const auto size = fs::file_size(program, failed);
    const auto time = fs::last_write_time(program, failed).time_since_epoch().count();
    return failed ? std::string{} : std::to_string(size) + ' ' + std::to_string(time);
}

// The part of an answer, with the measures that were asked for and no others.
CadPart answered(std::string_view answer, const fs::path& file,
                 const CadImportOptions& options, const ReadLimits& limits)
{
    CadPart part = parse_cad_stream(answer, file, limits);
    if (!options.measures) {
        part.measures.reset();
        return part;
    }
    const auto is_area = [](double area) { return 0 <= area && std::isfinite(area); };
    if (!part.measures || part.measures->face_areas_mm2.size() != part.faces.size() ||
        !is_area(part.measures->area_mm2) ||
        !std::ranges::all_of(part.measures->face_areas_mm2, is_area))
        throw FormatError{"E_CAD",
                          {shown_path(file), "",
                           "the answer of endmill-cad lacks the areas of the faces",
                           "an area from 0 of each face"}};
    return part;
}

}  // namespace

std::optional<CadFormat> cad_format(const fs::path& path)
{
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
    });
    if (extension == ".step" || extension == ".stp")
        return CadFormat::Step;
    if (extension == ".iges" || extension == ".igs")
        return CadFormat::Iges;
    return std::nullopt;
}

CadPart import_cad(const fs::path& program, const fs::path& file,
                   const CadImportOptions& options, const ReadLimits& limits)
{
    require_domain(options);
    const CadFormat format = known_format(file);
    if (format == CadFormat::Step)
        require_step(read_file(file, limits), file);
    else
        read_file(file, limits);  // its checks
    require_program(program, file, format);
    return answered(answer_for(program, file, format, options, limits), file, options,
                    limits);
}

CadPart import_cad_with_cache(const fs::path& program, const fs::path& file,
                              const fs::path& cache, const std::string& version,
                              const ReadLimits& limits)
{
    const CadImportOptions options;
    if (cache.empty())
        return import_cad(program, file, options, limits);
    const CadFormat format = known_format(file);
    const std::string before = content_sha256(content_of(file, format, limits));
    const std::string key = content_sha256(
        before + ' ' + std::string{format_name(format)} + ' ' +
        to_text(options.chord_tolerance_mm) + ' ' + to_text(options.angle_deg) + ' ' +
        version + ' ' + build_of(program));
    const fs::path kept = cache / (key + ".cad");
    if (auto part = kept_part(kept, file, limits))
        return *std::move(part);
    require_program(program, file, format);
    const std::string answer = answer_for(program, file, format, options, limits);
    CadPart part = answered(answer, file, options, limits);
    if (content_sha256(content_of(file, format, limits)) != before)
        throw FormatError{"E_CAD",
                          {shown_path(file), "", "the file changed while it was imported",
                           "a file that stays as it is"}};
    keep(kept, answer);
    return part;
}

}  // namespace endmill
