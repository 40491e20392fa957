// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/ranks.h"

#include <chrono>
#include <stdexcept>
#include <thread>

namespace endmill {
namespace {

[[noreturn]] void fail_alone()
{
    throw std::logic_error{"there is no other rank"};
}

}  // namespace

void OneRank::send(int, std::string_view)
{
    fail_alone();
}

std::optional<RankMessage> OneRank::receive(std::optional<double> most_seconds)
{
    if (!most_seconds)
        fail_alone();
    std::this_thread::sleep_for(std::chrono::duration<double>(*most_seconds));
    return std::nullopt;
}

RankMessage OneRank::receive_from(int)
{
    fail_alone();
}

}  // namespace endmill
