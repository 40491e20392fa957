// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/case_workers.h"

#include <exception>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// The first character of a worker's message tells its kind; the rest is its content.
constexpr char kind_ready = 'R';  // a worker without a row
constexpr char kind_row = 'W';
constexpr char kind_error = 'E';

// The cases between their source and the threads that run them.
class Exchange {
public:
    explicit Exchange(const CaseTraffic& traffic) : traffic_{traffic} {}

    std::optional<CaseTask> next()
    {
        const std::lock_guard lock{mutex_};
        if (error_)
            return std::nullopt;
        try {
            return traffic_.next();
        } catch (...) {
            error_ = std::current_exception();
            return std::nullopt;
        }
    }

    void record(const CaseRow& row)
    {
        const std::lock_guard lock{mutex_};
        try {
            traffic_.record(row);
        } catch (...) {
            keep(std::current_exception());
        }
    }

    void fail(std::exception_ptr error)
    {
        const std::lock_guard lock{mutex_};
        keep(std::move(error));
    }

    void rethrow() const
    {
        if (error_)
            std::rethrow_exception(error_);
    }

private:
    void keep(std::exception_ptr error)
    {
        if (!error_)
            error_ = std::move(error);
    }

    const CaseTraffic& traffic_;
    std::mutex mutex_;
    std::exception_ptr error_;
};

void run_until_none_is_left(Exchange& exchange)
{
    try {
        while (const auto task = exchange.next())
            exchange.record(run_case(*task));
    } catch (...) {
        exchange.fail(std::current_exception());
    }
}

// Without a thread of the system there are fewer at work.
void start_threads(std::vector<std::jthread>& threads, int count, Exchange& exchange)
{
    try {
        for (int i = 0; i < count; ++i)
            threads.emplace_back([&exchange] { run_until_none_is_left(exchange); });
    } catch (const std::system_error&) {
        return;
    }
}

void take(const std::string& message, Exchange& exchange)
{
    const std::string content = message.substr(1);
    if (message.front() == kind_error)
        throw OutputError{content};
    if (message.front() == kind_row)
        exchange.record(row_of_line(content).value());
}

void serve_workers(Exchange& exchange, SweepWorkers& workers)
{
    while (workers.is_open()) {
        const RankMessage message = workers.next();
        try {
            take(message.content, exchange);
        } catch (...) {
            exchange.fail(std::current_exception());
        }
        if (const auto task = exchange.next())
            workers.give(message.from, task_line(*task));
        else
            workers.end(message.from);
    }
}

std::string answer_to(std::string_view task)
{
    try {
        return kind_row + row_line(run_case(task_of_line(task)));
    } catch (const Error& error) {
        return kind_error + std::string{error.what()};
    }
}

}  // namespace

void serve_cases(Ranks& ranks)
{
    std::string message{kind_ready};
    while (true) {
        ranks.send(0, message);
        const RankMessage task = ranks.receive_from(0);
        if (task.content.empty())
            return;
        message = answer_to(task.content);
    }
}

void run_cases(const CaseTraffic& traffic, int jobs, SweepWorkers& workers)
{
    Exchange exchange{traffic};
    std::vector<std::jthread> threads;
    // This thread works too, unless it answers other ranks.
    start_threads(threads, workers.is_open() ? jobs : jobs - 1, exchange);
    if (!workers.is_open())
        run_until_none_is_left(exchange);
    try {
        serve_workers(exchange, workers);
    } catch (...) {
        exchange.fail(std::current_exception());
    }
    threads.clear();
    exchange.rethrow();
}

}  // namespace endmill
