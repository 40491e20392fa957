// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// \file
/// The processes that share one piece of work, such as those that `mpirun` starts.

namespace endmill {

/// Bytes that one rank sent to another.
struct RankMessage {
    int from;             ///< rank of the sender
    std::string content;  ///< as it was sent
};

/// The processes that share one piece of work, and this one among them. One thread at a time
/// may use it.
class Ranks {
public:
    Ranks() = default;                        ///< for the classes that derive from it
    virtual ~Ranks() = default;               ///< ends what the class began
    Ranks(const Ranks&) = delete;             ///< it stands for the running processes
    Ranks& operator=(const Ranks&) = delete;  ///< not assignable either

    virtual int rank() const = 0;   ///< of this process, 0 to count() - 1
    virtual int count() const = 0;  ///< number of processes, at least 1

    /// Sends `content`, of any length, to another rank.
    /// Messages of one rank to another arrive in the order in which they were sent.
    /// \pre `to` is a rank other than this one.
    virtual void send(int to, std::string_view content) = 0;

    /// The next message of any rank. It does not occupy a core while it waits.
    /// \param most_seconds how long to wait; nothing: until a message comes.
    /// \return nothing if none came in that time.
    virtual std::optional<RankMessage> receive(
        std::optional<double> most_seconds = {}) = 0;

    /// The next message of the rank `from`. \pre `from` is a rank other than this one.
    virtual RankMessage receive_from(int from) = 0;
};

/// The only process of a program that is not run by MPI.
class OneRank final : public Ranks {
public:
    int rank() const override { return 0; }   ///< 0
    int count() const override { return 1; }  ///< 1
    /// \throws std::logic_error always: there is no other rank.
    void send(int to, std::string_view content) override;
    /// Waits if a time is given. \return nothing.
    /// \throws std::logic_error without a time: it would wait for ever.
    std::optional<RankMessage> receive(std::optional<double> most_seconds = {}) override;
    /// \throws std::logic_error always.
    RankMessage receive_from(int from) override;
};

}  // namespace endmill
