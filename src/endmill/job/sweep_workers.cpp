// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/sweep_workers.h"

#include <utility>

namespace endmill {

SweepWorkers::SweepWorkers(Ranks& ranks) : ranks_{ranks}, open_{ranks.count() - 1} {}

SweepWorkers::~SweepWorkers()
{
    try {
        while (is_open())
            end(next().from);
    } catch (...) {
        open_ = 0;  // a rank has died, which ends all
    }
}

RankMessage SweepWorkers::next()
{
    return ranks_.receive().value();
}

void SweepWorkers::give(int worker, std::string_view content)
{
    ranks_.send(worker, content);
}

void SweepWorkers::end(int worker)
{
    --open_;
    ranks_.send(worker, {});
}

}  // namespace endmill
