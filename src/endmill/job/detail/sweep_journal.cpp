// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/sweep_journal.h"

#include <array>
#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "endmill/core/error.h"
#include "endmill/files/detail/output_path.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::string_view format_name = "endmill-sweep-journal/1";
// A loss of power costs the rows of this time; the death of the process costs none.
constexpr std::chrono::seconds flush_interval{1};

std::string identity_line(const SweepIdentity& identity)
{
    const nlohmann::ordered_json line{{"format", format_name},
                                      {"plan_sha256", identity.plan_sha256},
                                      {"cases", identity.cases},
                                      {"shard", identity.shard.number},
                                      {"shards", identity.shard.count}};
    return line.dump() + '\n';
}

std::optional<SweepIdentity> identity_of(std::string_view line)
{
    try {
        const json read = json::parse(line);
        if (read.at("format").get<std::string>() != format_name)
            return std::nullopt;
        return SweepIdentity{read.at("plan_sha256").get<std::string>(),
                             read.at("cases").get<std::uint64_t>(),
                             {read.at("shard").get<std::uint64_t>(),
                              read.at("shards").get<std::uint64_t>()}};
    } catch (const json::exception&) {
        return std::nullopt;
    }
}

FormatError complaint(const fs::path& file, std::uint64_t line)
{
    return FormatError{"E_JSON",
                       {shown_path(file), std::to_string(line),
                        "a line that endmill did not write", "another folder"}};
}

// Complete lines of a file, one after the other.
class LineReader {
public:
    explicit LineReader(int descriptor) : descriptor_{descriptor} {}

    // The next line without its end; nothing at the end of the file. It is valid until the
    // next call.
    std::optional<std::string_view> next()
    {
        text_.erase(0, used_);
        used_ = 0;
        std::size_t end = text_.find('\n');
        while (end == std::string::npos) {
            const std::size_t before = text_.size();
            if (!read_more())
                return std::nullopt;
            end = text_.find('\n', before);
        }
        used_ = end + 1;
        offset_ += used_;
        return std::string_view{text_}.substr(0, end);
    }

    std::uint64_t offset() const { return offset_; }  // after the last line

private:
    bool read_more()
    {
        std::array<char, 65536> piece{};
        const ssize_t count = ::pread(descriptor_, piece.data(), piece.size(),
                                      static_cast<off_t>(offset_ + text_.size()));
        if (count > 0)
            text_.append(piece.data(), static_cast<std::size_t>(count));
        return count > 0;
    }

    int descriptor_;
    std::string text_;
    std::size_t used_ = 0;
    std::uint64_t offset_ = 0;
};

}  // namespace

std::optional<SweepIdentity> SweepJournal::identity_in(const fs::path& file)
{
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0 && errno == ENOENT)
        return std::nullopt;
    if (descriptor < 0)
        fail_output("read", file, errno);
    LineReader lines{descriptor};
    const auto line = lines.next();
    const auto identity = line ? identity_of(*line) : std::nullopt;
    ::close(descriptor);
    if (line && !identity)
        throw complaint(file, 1);
    return identity;
}

SweepJournal::SweepJournal(fs::path file, const SweepIdentity& identity)
    : file_{std::move(file)},
      identity_{identity},
      begins_(identity.shard.size(identity.cases)),
      ends_(begins_.size())
{
    constexpr mode_t mode = 0666;
    descriptor_ =
        ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_APPEND, mode);
    if (descriptor_ < 0)
        fail_output("write", file_, errno);
    try {
        read_rows();
        if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0)
            fail_output("write", file_, errno);
        if (size_ == 0)
            write(identity_line(identity_));
    } catch (...) {
        ::close(descriptor_);
        throw;
    }
}

SweepJournal::~SweepJournal()
{
    ::close(descriptor_);
}

void SweepJournal::read_rows()
{
    LineReader lines{descriptor_};
    const auto first = lines.next();
    if (!first)
        return;
    if (identity_of(*first) != identity_)
        throw complaint(file_, 1);
    size_ = lines.offset();
    for (std::uint64_t number = 2;; ++number) {
        const auto line = lines.next();
        if (!line)
            return;
        const auto row = row_of_line(*line);
        const SweepShard& shard = identity_.shard;
        if (!row || row->number >= identity_.cases ||
            row->number % shard.count != shard.number - 1)
            throw complaint(file_, number);
        add(*row, size_, lines.offset());
        size_ = lines.offset();
    }
}

void SweepJournal::add(const CaseRow& row, std::uint64_t line_begin,
                       std::uint64_t line_end)
{
    const std::uint64_t i = row.number / identity_.shard.count;
    if (has(i))
        return;
    begins_[i] = line_begin;
    ends_[i] = line_end;
    ++count_;
    failed_ += row.is_failed() ? 1 : 0;
}

void SweepJournal::write(const std::string& line)
{
    if (const int error = write_whole(descriptor_, line); error != 0) {
        if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0)
            fail_output("restore", file_, errno);
        fail_output("write", file_, error);
    }
    size_ += line.size();
}

void SweepJournal::append(const CaseRow& row)
{
    const std::uint64_t begin = size_;
    write(row_line(row) + '\n');
    add(row, begin, size_);
    if (std::chrono::steady_clock::now() - flushed_ >= flush_interval)
        flush();
}

void SweepJournal::flush()
{
    if (::fdatasync(descriptor_) != 0)
        fail_output("write", file_, errno);
    flushed_ = std::chrono::steady_clock::now();
}

CaseRow SweepJournal::row(std::uint64_t i) const
{
    std::string line(ends_[i] - begins_[i], '\0');
    const ssize_t count =
        ::pread(descriptor_, line.data(), line.size(), static_cast<off_t>(begins_[i]));
    const auto row =
        count == static_cast<ssize_t>(line.size()) ? row_of_line(line) : std::nullopt;
    if (!row)
        throw OutputError{"cannot read " + shown_path(file_) + " again"};
    return *row;
}

}  // namespace endmill
