// SPDX-License-Identifier: GPL-3.0-or-later
// The ranks of `endmill-mpi`, by Boost.MPI.
//
// Messages are cut into pieces, since a count of MPI is an int. A rank that waits, also for
// one of its own messages to be taken, receives what arrives for it in the meantime; therefore
// two ranks that send to each other do not wait for ever. It sleeps between its looks: MPI
// itself would occupy a core. The end of the work and a failure have tags of their own. A rank
// that sees one of them stops in the middle of what it does.

#include "cli/program_ranks.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include "cli/console.h"
#include "cli/mpi_launch.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

namespace mpi = boost::mpi;
using Clock = std::chrono::steady_clock;

constexpr int content_tag = 1;
constexpr int failure_tag = 2;  // a rank failed; to rank 0
constexpr int end_tag = 3;      // rank 0 ends the work; to all others

// Of a piece of a message. A transfer of this size takes milliseconds, so that pieces cost
// nothing.
constexpr std::size_t piece_bytes = std::size_t{1} << 24;

// Ends the work of a rank whose result nobody awaits any more.
struct WorkEnded {
    ExitCode exit;
};

// Pauses between looks, each twice as long as the one before, up to a limit.
class Pauses {
public:
    void pause()
    {
        constexpr std::chrono::microseconds longest{1000};
        std::this_thread::sleep_for(next_);
        next_ = std::min(2 * next_, longest);
    }

private:
    std::chrono::microseconds next_{50};
};

// A failure as text: the exit code, the code word and the message.
struct Failure {
    ExitCode exit = ExitCode::Fault;
    std::string code = "E_FAULT";
    std::string message;
};

Failure current_failure()
{
    const auto failure = [](const Error& error, ExitCode exit) {
        return Failure{exit, error.code(), error.what()};
    };
    try {
        throw;
    } catch (const FormatError& error) {
        return failure(error, ExitCode::Input);
    } catch (const DomainError& error) {
        return failure(error, ExitCode::Usage);
    } catch (const GeometryError& error) {
        return failure(error, ExitCode::Geometry);
    } catch (const OutputError& error) {
        return failure(error, ExitCode::Output);
    } catch (const LimitError& error) {
        return failure(error, ExitCode::Limit);
    } catch (const std::bad_alloc&) {
        return {ExitCode::Limit, "E_LIMIT", "not enough memory"};
    } catch (const std::exception& error) {
        return {ExitCode::Fault, "E_FAULT", error.what()};
    }
}

[[noreturn]] void throw_failure(const Failure& failure, int rank)
{
    const std::string name = "rank " + std::to_string(rank);
    const std::string text = name + ": " + failure.message;
    switch (failure.exit) {
        case ExitCode::Usage:
            throw DomainError{text};
        case ExitCode::Input:
            throw FormatError{failure.code, {name, "", failure.message, ""}};
        case ExitCode::Geometry:
            throw GeometryError{text};
        case ExitCode::Output:
            throw OutputError{text};
        case ExitCode::Limit:
            throw LimitError{text};
        case ExitCode::Yes:
        case ExitCode::No:
        case ExitCode::Fault:
            break;
    }
    throw std::runtime_error{text};
}

// What is there of a message that arrives in pieces.
struct Arriving {
    std::size_t size;  // of the whole message
    std::string content;
};

class MpiRanks final : public Ranks {
public:
    MpiRanks() : environment_{mpi::threading::serialized, false} {}

    int rank() const override { return world_.rank(); }
    int count() const override { return world_.size(); }

    void send(int to, std::string_view content) override
    {
        const std::uint64_t size = content.size();
        send_piece(to, {reinterpret_cast<const char*>(&size), sizeof(size)}, content_tag);
        for (; !content.empty();
             content.remove_prefix(std::min(piece_bytes, content.size())))
            send_piece(to, content.substr(0, piece_bytes), content_tag);
    }

    std::optional<RankMessage> receive(std::optional<double> most_seconds) override
    {
        const Clock::time_point start = Clock::now();
        Pauses pauses;
        while (inbox_.empty()) {
            if (take_piece()) {
                pauses = {};
                continue;
            }
            if (most_seconds &&
                std::chrono::duration<double>(Clock::now() - start).count() >=
                    *most_seconds)
                return std::nullopt;
            pauses.pause();
        }
        return take_message(inbox_.begin());
    }

    RankMessage receive_from(int from) override
    {
        Pauses pauses;
        for (;;) {
            const auto found = std::ranges::find(inbox_, from, &RankMessage::from);
            if (found != inbox_.end())
                return take_message(found);
            if (take_piece())
                pauses = {};
            else
                pauses.pause();
        }
    }

    // Looks for the messages that end this rank, and for no other.
    void check()
    {
        for (const int tag : {end_tag, failure_tag})
            if (const auto status = world_.iprobe(mpi::any_source, tag))
                take(*status);
    }

    // Tells all other ranks the exit code of the program.
    void end_others(ExitCode exit)
    {
        const int code = static_cast<int>(exit);
        for (int other = 1; other < count(); ++other)
            world_.isend(other, end_tag, reinterpret_cast<const char*>(&code),
                         sizeof(code));  // so short that MPI takes it at once
    }

    // Waits until rank 0 ends the work. \return its exit code.
    ExitCode wait_for_end()
    {
        try {
            for (;;)
                receive({});
        } catch (const WorkEnded& end) {
            return end.exit;
        }
    }

    void send_failure(const Failure& failure)
    {
        const std::string text = std::to_string(static_cast<int>(failure.exit)) + "\n" +
                                 failure.code + "\n" + failure.message;
        send_piece(0, std::string_view{text}.substr(0, piece_bytes), failure_tag);
    }

private:
    void send_piece(int to, std::string_view piece, int tag)
    {
        mpi::request request =
            world_.isend(to, tag, piece.data(), static_cast<int>(piece.size()));
        Pauses pauses;
        try {
            while (!request.test())
                if (!take_piece())
                    pauses.pause();
        } catch (...) {
            request.cancel();
            throw;
        }
    }

    RankMessage take_message(const std::deque<RankMessage>::iterator& place)
    {
        RankMessage message = std::move(*place);
        inbox_.erase(place);
        return message;
    }

    // Receives one piece of a message, if one is there.
    bool take_piece()
    {
        const auto status = world_.iprobe();
        if (status)
            take(*status);
        return status.has_value();
    }

    void take(const mpi::status& status)
    {
        const int from = status.source();
        const auto size = static_cast<std::size_t>(status.count<char>().value_or(0));
        if (status.tag() == content_tag) {
            take_content(from, size);
            return;
        }
        std::string text(size, '\0');
        world_.recv(from, status.tag(), text.data(), static_cast<int>(size));
        if (status.tag() == failure_tag)
            throw_failure(failure_in(text), from);
        int code = 0;
        std::memcpy(&code, text.data(), std::min(sizeof(code), size));
        throw WorkEnded{static_cast<ExitCode>(code)};
    }

    static Failure failure_in(const std::string& text)
    {
        const std::size_t first = text.find('\n');
        const std::size_t second = text.find('\n', first + 1);
        return {static_cast<ExitCode>(std::stoi(text)),
                text.substr(first + 1, second - first - 1), text.substr(second + 1)};
    }

    void take_content(int from, std::size_t size)
    {
        const auto known = arriving_.find(from);
        if (known == arriving_.end()) {
            std::uint64_t whole = 0;
            world_.recv(from, content_tag, reinterpret_cast<char*>(&whole),
                        sizeof(whole));
            Arriving& begun = arriving_[from];
            begun.size = whole;
            begun.content.reserve(whole);
        } else {
            std::string& content = known->second.content;
            const std::size_t before = content.size();
            content.resize(before + size);
            world_.recv(from, content_tag, content.data() + before,
                        static_cast<int>(size));
        }
        const auto now = arriving_.find(from);
        if (now->second.content.size() < now->second.size)
            return;
        inbox_.push_back({from, std::move(now->second.content)});
        arriving_.erase(now);
    }

    mpi::environment environment_;
    mpi::communicator world_;
    std::deque<RankMessage> inbox_;
    std::map<int, Arriving> arriving_;  // by sender
};

std::unique_ptr<MpiRanks> ranks;

// Ranks other than 0 print nothing.
void silence()
{
    const int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
    close(nothing);
}

}  // namespace

void begin_ranks(std::span<char*> /*arguments*/)
{
    const MpiLaunch launch = mpi_launch();
    ranks = std::make_unique<MpiRanks>();
    forget_mpi_launch();
    if (ranks->count() == 1 && launch.rank > 0)
        silence();
    if (ranks->count() == 1 && launch.count > 1)
        throw DomainError{
            "found processes that do not belong together; expected the mpirun of the MPI "
            "with which endmill-mpi is built"};
    if (ranks->rank() > 0)
        silence();
}

Ranks& program_ranks()
{
    return *ranks;
}

void check_ranks()
{
    if (ranks->count() > 1)
        ranks->check();
}

ExitCode end_ranks(ExitCode exit)
{
    if (ranks->rank() > 0)
        exit = ranks->wait_for_end();
    else
        ranks->end_others(exit);
    ranks.reset();
    return exit;
}

namespace {

// Ends this rank, which is not rank 0, by the current exception.
ExitCode end_other_rank()
{
    try {
        throw;
    } catch (const WorkEnded& end) {
        return end.exit;
    } catch (...) {
        try {
            ranks->send_failure(current_failure());
        } catch (const WorkEnded& end) {
            return end.exit;
        }
    }
    return ranks->wait_for_end();
}

}  // namespace

ExitCode end_ranks_by_exception(bool json_errors) noexcept
{
    const bool is_first = !ranks || ranks->rank() == 0;
    ExitCode exit = is_first ? report_current_exception(json_errors) : ExitCode::Fault;
    try {
        if (!is_first)
            exit = end_other_rank();
        else if (ranks)
            ranks->end_others(exit);
        ranks.reset();
    } catch (...) {
        // There is no way left to end together: mpirun ends the others.
        _exit(static_cast<int>(exit));
    }
    return exit;
}

}  // namespace endmill
