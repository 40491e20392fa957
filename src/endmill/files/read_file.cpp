// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/read_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "endmill/core/detail/large_pages.h"
#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

using std::string_view_literals::operator""sv;

// The number with two significant digits, for messages.
std::string two_digits(double value)
{
    std::array<char, 32> buffer{};
    const int length = std::snprintf(buffer.data(), buffer.size(), "%.2g", value);
    return {buffer.data(), static_cast<std::size_t>(length)};
}

// First bytes of compressed files.
constexpr std::array compressed_beginnings{
    "\x1f\x8b"sv,          // gzip
    "PK\x03\x04"sv,        // zip
    "\xfd\x37zXZ\x00"sv,   // xz
    "BZh"sv,               // bzip2
    "\x28\xb5\x2f\xfd"sv,  // zstd
};

// Refuses compressed content, and says what to do with the file. A 3MF file is a zip archive
// and is known by its extension only.
[[noreturn]] void refuse_compressed(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    if (extension == ".3mf")
        throw FormatError{
            "E_COMPRESSED",
            {shown_path(path), "", "3MF is not read: it is a compressed file",
             "the mesh exported as .stl, .obj, .ply or .off"}};
    const bool is_gzip = extension == ".gz";
    throw FormatError{"E_COMPRESSED",
                      {shown_path(path), "", "compressed input is not accepted",
                       is_gzip ? "the decompressed file, as gunzip -k makes it"
                               : "the decompressed file"}};
}

// Throws the error that a file cannot be opened or read.
[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& found,
                         const std::string& expected)
{
    throw FormatError{"E_OPEN", {shown_path(path), "", found, expected}};
}

// The same for an error number of the operating system.
[[noreturn]] void refuse_for(const std::filesystem::path& path, int error)
{
    if (error == EACCES)
        refuse(path, "cannot open: permission denied", "a file that you may read");
    refuse(path, "cannot open: " + std::generic_category().message(error),
           error == ENOENT ? "an existing file" : "a readable file");
}

// A regular file that is open for reading. O_NONBLOCK keeps `open` from waiting for the
// other end of a pipe, so that a pipe can be refused.
class InputFile {
public:
    explicit InputFile(const std::filesystem::path& path)
        : path_{path},
          descriptor_{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)}
    {
        if (descriptor_ < 0)
            refuse_for(path_, errno);
    }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    ~InputFile() { ::close(descriptor_); }

    // Size of the file in bytes. Folders, devices and pipes are refused here.
    std::size_t size() const
    {
        struct stat status = {};
        if (::fstat(descriptor_, &status) != 0)
            refuse_for(path_, errno);
        if (S_ISDIR(status.st_mode))
            refuse(path_, "is a directory", "a file");
        if (!S_ISREG(status.st_mode))
            refuse(path_, "is a device or a pipe", "a regular file");
        return static_cast<std::size_t>(status.st_size);
    }

    // Appends the next `wanted` bytes to `text`; fewer at the end of the file.
    void append_to(std::string& text, std::size_t wanted) const
    {
        const std::size_t before = text.size();
        text.reserve(before + wanted);
        prefer_large_pages(text.data(), text.capacity());
        text.resize(before + wanted);
        std::size_t got = 0;
        while (got < wanted) {
            const ssize_t count =
                ::read(descriptor_, text.data() + before + got, wanted - got);
            if (count < 0 && errno != EINTR)
                refuse_for(path_, errno);
            if (count == 0)
                break;
            got += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
        }
        text.resize(before + got);
    }

private:
    const std::filesystem::path& path_;
    int descriptor_;
};

}  // namespace

void require_memory(const std::string& file, double bytes, const ReadLimits& limits)
{
    const double gib = bytes / bytes_per_gib;
    if (gib > limits.max_memory_gib)
        throw LimitError{file + ": reading it needs about " + two_digits(gib) +
                         " GiB; the limit is " + two_digits(limits.max_memory_gib) +
                         " GiB (--max-memory)"};
}

std::string read_file(const std::filesystem::path& path, const ReadLimits& limits)
{
    constexpr std::size_t beginning_bytes = 16;
    const std::string file = shown_path(path);
    const InputFile input{path};
    const std::size_t size = input.size();

    std::string text;
    input.append_to(text, beginning_bytes);
    for (const std::string_view beginning : compressed_beginnings)
        if (text.starts_with(beginning))
            refuse_compressed(path);
    // A file that exceeds the limit is refused before it is read. Readers check the
    // memory of the data that they build from the text separately.
    require_memory(file, static_cast<double>(size), limits);
    if (size > text.size())
        input.append_to(text, size - text.size());
    if (text.find_first_not_of(" \t\r\n\v\f") == std::string::npos)
        throw FormatError{"E_EMPTY", {file, "", "file is empty", "a file with content"}};
    return text;
}

std::string shown_path(const std::filesystem::path& path)
{
    return printable(path.string());
}

}  // namespace endmill
