// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "endmill/job/ranks.h"

namespace endmill {

/// Ranks that are threads of one process: messages go through queues.
class FakeRanks final : public Ranks {
public:
    /// What the ranks of one piece of work share.
    struct Mail {
        std::mutex mutex;
        std::condition_variable came;
        std::vector<std::deque<RankMessage>> boxes;  // of each rank
    };

    static std::vector<std::unique_ptr<FakeRanks>> make(int count)
    {
        const auto mail = std::make_shared<Mail>();
        mail->boxes.resize(count);
        std::vector<std::unique_ptr<FakeRanks>> all;
        for (int rank = 0; rank < count; ++rank)
            all.push_back(std::make_unique<FakeRanks>(rank, mail));
        return all;
    }

    FakeRanks(int rank, std::shared_ptr<Mail> mail) : rank_{rank}, mail_{std::move(mail)}
    {
    }

    int rank() const override { return rank_; }
    int count() const override { return static_cast<int>(mail_->boxes.size()); }

    void send(int to, std::string_view content) override
    {
        const std::lock_guard lock{mail_->mutex};
        mail_->boxes.at(to).push_back({rank_, std::string{content}});
        mail_->came.notify_all();
    }

    std::optional<RankMessage> receive(std::optional<double> most_seconds) override
    {
        std::unique_lock lock{mail_->mutex};
        const std::chrono::duration<double> most{most_seconds.value_or(60)};
        auto& box = mail_->boxes.at(rank_);
        if (!mail_->came.wait_for(lock, most, [&] { return !box.empty(); }))
            return std::nullopt;
        RankMessage message = std::move(box.front());
        box.pop_front();
        return message;
    }

    // In these tests a worker hears from rank 0 only.
    RankMessage receive_from(int) override { return receive(std::nullopt).value(); }

private:
    int rank_;
    std::shared_ptr<Mail> mail_;
};

}  // namespace endmill
