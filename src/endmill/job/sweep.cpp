// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/sweep.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/detail/output_path.h"
#include "endmill/files/read_file.h"
#include "endmill/job/detail/case_workers.h"
#include "endmill/job/detail/sweep_journal.h"
#include "endmill/job/detail/sweep_results.h"
#include "endmill/job/folder_lock.h"

// Life of the results in a folder:
//
// 1. While cases run, `.endmill-cases-XXXXXX` has a folder with the results of each, and the
//    journal has a row of each case that has ended.
// 2. When all have ended, results.csv and sweep.json are written from the journal.
// 3. The journal is removed. Results with a journal beside them may be old; those without one
//    are complete.

namespace endmill {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* journal_name = ".endmill-journal.jsonl";
constexpr const char* working_prefix = ".endmill-cases-";
constexpr const char* kept_name = "cases";
constexpr double ms_per_s = 1000;

double seconds_since(Clock::time_point start)
{
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return std::round(seconds * ms_per_s) / ms_per_s;
}

SweepIdentity identity_of(const SweepPlan& plan, const SweepShard& shard)
{
    return {plan.sha256(), plan.count(), shard};
}

// Refuses results that are not those of this plan and shard.
void require_same(const SweepIdentity& found, const SweepIdentity& expected,
                  const fs::path& folder)
{
    if (found.plan_sha256 != expected.plan_sha256)
        throw DomainError{shown_path(folder) +
                          " has results of another plan or version, with the hash " +
                          printable(found.plan_sha256, 64) + "; expected " +
                          expected.plan_sha256 + ", or a new folder"};
    if (found.shard != expected.shard)
        throw DomainError{shown_path(folder) + " has results of the shard " +
                          found.shard.text() + "; found --shard " +
                          expected.shard.text() + ", expected the same or a new folder"};
}

// What an earlier run has left in the folder.
enum class Earlier { Nothing, Journal, Results };

Earlier earlier_results(const SweepIdentity& identity, const SweepOptions& options)
{
    const auto journal = SweepJournal::identity_in(options.folder / journal_name);
    const auto facts = read_sweep_facts(options.folder);
    if (!journal && !facts)
        return Earlier::Nothing;
    require_same(journal ? *journal : facts->identity, identity, options.folder);
    if (!options.resume)
        throw DomainError{shown_path(options.folder) +
                          (journal ? " has the begun results of this plan"
                                   : " has the results of this plan") +
                          "; expected --resume, or a new folder"};
    return journal ? Earlier::Journal : Earlier::Results;
}

void require_no_file(const fs::path& folder)
{
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
        throw DomainError{"output folder " + shown_path(folder) +
                          " is a file; expected a new or empty folder"};
}

// Refuses a folder with files of somebody else.
void require_usable(const SweepOptions& options)
{
    constexpr const char* own = ".endmill-";
    std::error_code error;
    if (options.full_folder == FullFolder::Accept || !fs::exists(options.folder, error))
        return;
    for (const auto& entry : fs::directory_iterator{options.folder, error})
        if (!entry.path().filename().string().starts_with(own))
            throw DomainError{"output folder " + shown_path(options.folder) +
                              " is not empty; expected a new or empty folder, or "
                              "--force"};
}

void make_folder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        fail_output("create the output folder", folder, error.value());
}

// Removes the results of cases that ran when an earlier run was killed.
void remove_unfinished(const fs::path& results)
{
    std::vector<fs::path> found;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator{results, ignored})
        if (entry.path().filename().string().starts_with(working_prefix))
            found.push_back(entry.path());
    for (const fs::path& folder : found)
        fs::remove_all(folder, ignored);
}

// A folder of a new name for the results of running cases. It is no PrivateFolder: an
// interruption would remove results while they are read for a row. Like the folder of kept
// cases it lies in that of the results, because results name files relative to themselves:
// the names hold after a case has moved.
class WorkingFolder {
public:
    explicit WorkingFolder(const fs::path& results)
        : path_{results / (std::string{working_prefix} + "XXXXXX")}
    {
        std::string name = path_.string();
        if (::mkdtemp(name.data()) == nullptr)
            fail_output("create a folder in", results, errno);
        path_ = name;
    }
    ~WorkingFolder()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;

    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

// The number of a case as the name of a folder.
std::string folder_name(std::uint64_t number)
{
    constexpr std::size_t digits = 7;
    std::string name = std::to_string(number);
    return std::string(digits - std::min(digits, name.size()), '0') + name;
}

// The tasks of a sweep, in the order of the plan.
class TaskSource {
public:
    TaskSource(const SweepPlan& plan, const SweepOptions& options,
               const SweepJournal& journal, fs::path working)
        : plan_{plan},
          options_{options},
          journal_{journal},
          working_{std::move(working)},
          size_{options.shard.size(plan.count())}
    {
    }

    std::optional<CaseTask> next()
    {
        while (i_ < size_ && journal_.has(i_))
            ++i_;
        return i_ < size_ ? std::optional{task(options_.shard.at(i_++))} : std::nullopt;
    }

private:
    CaseTask task(std::uint64_t number) const
    {
        CaseTask task{.number = number,
                      .program = options_.program,
                      .arguments = plan_.arguments(number),
                      .folder = working_ / folder_name(number),
                      .kept_folder = options_.folder / kept_name / folder_name(number),
                      .kept = options_.kept,
                      .columns = plan_.columns(),
                      .most_seconds = options_.most_seconds,
                      .most_gib = options_.most_gib};
        for (const std::string& word :
             {std::string{"--json-errors"}, std::string{"--quiet"},
              "--threads=" + std::to_string(options_.threads_of_case)})
            task.arguments.push_back(word);
        if (options_.most_gib && !plan_.gives("max_memory"))
            task.arguments.push_back("--max-memory=" + to_text(*options_.most_gib));
        return task;
    }

    const SweepPlan& plan_;
    const SweepOptions& options_;
    const SweepJournal& journal_;
    fs::path working_;
    std::uint64_t size_;
    std::uint64_t i_ = 0;  // of the next case in the shard
};

void run_open_cases(const SweepPlan& plan, const SweepOptions& options,
                    SweepJournal& journal, SweepWorkers& workers)
{
    const std::uint64_t size = options.shard.size(plan.count());
    const std::uint64_t before = journal.count();
    remove_unfinished(options.folder);
    if (before == size)
        return;
    const WorkingFolder working{options.folder};
    TaskSource source{plan, options, journal, working.path()};
    const auto report = [&] {
        if (options.progress)
            options.progress({journal.count(), size, journal.failed(), before});
    };
    report();
    const CaseTraffic traffic{[&] { return source.next(); },
                              [&](const CaseRow& row) {
                                  journal.append(row);
                                  report();
                              }};
    run_cases(traffic, options.jobs, workers);
}

std::vector<std::string> header_of(const SweepPlan& plan)
{
    std::vector<std::string> header{"case"};
    header.insert(header.end(), plan.parameters().begin(), plan.parameters().end());
    for (const SummaryColumn& column : plan.columns())
        header.push_back(column.name);
    header.insert(header.end(), {"exit_code", "message", "wall_s"});
    return header;
}

std::vector<std::string> cells_of(const SweepPlan& plan, const CaseRow& row)
{
    std::vector<std::string> cells{std::to_string(row.number)};
    const std::vector<std::string> values = plan.values(row.number);
    cells.insert(cells.end(), values.begin(), values.end());
    cells.insert(cells.end(), row.columns.begin(), row.columns.end());
    cells.insert(cells.end(), {std::to_string(row.exit_code), row.message,
                               to_text(std::round(row.wall_s * ms_per_s) / ms_per_s)});
    return cells;
}

// Writes the results from the journal, and looks at them for the totals.
void write_rows(const SweepPlan& plan, const SweepOptions& options,
                const SweepJournal& journal, SweepTotals& totals)
{
    std::vector<bool> has_value(plan.columns().size());
    const auto look_at = [&](const CaseRow& row) {
        for (std::size_t k = 0; k < has_value.size(); ++k)
            has_value[k] = has_value[k] || !row.columns[k].empty();
        if (row.is_failed() && totals.first_failure.empty())
            totals.first_failure =
                "case " + std::to_string(row.number) + ": " + row.message;
    };
    const auto rows = [&](const OutputFolder::Sink& sink) {
        sink(csv_line(header_of(plan)));
        for (std::uint64_t i = 0; i < totals.cases; ++i) {
            CaseRow row = journal.row(i);
            row.columns.resize(has_value.size());
            look_at(row);
            sink(csv_line(cells_of(plan, row)));
        }
    };
    const SweepFacts facts{identity_of(plan, options.shard),
                           plan.version(),
                           plan.name(),
                           plan.source(),
                           plan.command(),
                           totals.failed,
                           totals.wall_s};
    write_results(options.folder, FullFolder::Accept, facts, rows);
    for (std::size_t k = 0; k < has_value.size(); ++k)
        if (!has_value[k] && totals.failed < totals.cases)
            totals.empty_columns.push_back(plan.columns()[k].name);
}

void remove_journal(const fs::path& file)
{
    std::error_code error;
    fs::remove(file, error);
    if (error)
        fail_output("remove", file, error.value());
}

SweepTotals totals_of(const SweepFacts& facts)
{
    const std::uint64_t size = facts.identity.shard.size(facts.identity.cases);
    return {
        .cases = size, .before = size, .failed = facts.failed, .wall_s = facts.wall_s};
}

}  // namespace

SweepTotals run_sweep(const SweepPlan& plan, const SweepOptions& options,
                      SweepWorkers& workers)
{
    const auto start = Clock::now();
    const SweepIdentity identity = identity_of(plan, options.shard);
    require_no_file(options.folder);
    Earlier earlier = earlier_results(identity, options);
    if (earlier == Earlier::Nothing)
        require_usable(options);
    make_folder(options.folder);
    const FolderLock lock{options.folder, "a sweep"};
    earlier = earlier_results(identity, options);  // now that it cannot change
    if (earlier == Earlier::Results)
        return totals_of(*read_sweep_facts(options.folder));

    const fs::path file = options.folder / journal_name;
    SweepTotals totals{.cases = options.shard.size(plan.count())};
    {
        SweepJournal journal{file, identity};
        totals.before = journal.count();
        run_open_cases(plan, options, journal, workers);
        journal.flush();
        totals.failed = journal.failed();
        totals.wall_s = seconds_since(start);
        write_rows(plan, options, journal, totals);
    }
    remove_journal(file);
    return totals;
}

void serve_sweep(Ranks& ranks)
{
    serve_cases(ranks);
}

namespace {

// The number of cells in a line of results.csv, whose quoted cells end in their line.
// \return nothing if a quote is open at the end.
std::optional<std::size_t> cell_count(std::string_view line)
{
    std::size_t count = 1;
    bool is_quoted = false;
    for (const char c : line) {
        is_quoted ^= c == '"';
        count += c == ',' && !is_quoted ? 1 : 0;
    }
    return is_quoted ? std::nullopt : std::optional{count};
}

// The results of one shard.
struct ShardResults {
    fs::path folder;
    SweepFacts facts;
    std::string content;            // of results.csv
    std::size_t used = 0;           // bytes of it
    std::uint64_t line_number = 0;  // of the line that was read last, from 1

    // The next line with its end; empty if there is no whole line.
    std::string_view next_line()
    {
        ++line_number;
        const std::size_t end = content.find('\n', used);
        if (end == std::string::npos)
            return {};
        const std::string_view line =
            std::string_view{content}.substr(used, end + 1 - used);
        used = end + 1;
        return line;
    }

    // An error at the line that was read last.
    FormatError complaint(const std::string& found) const
    {
        return FormatError{
            "E_CSV",
            {shown_path(folder / results_file), std::to_string(line_number), found,
             "a table that endmill sweep wrote"}};
    }
};

ShardResults results_in(const fs::path& folder)
{
    auto facts = read_sweep_facts(folder);
    const bool is_open = presence(folder / journal_name) != Presence::Absent;
    if (is_open)
        throw DomainError{
            shown_path(folder) +
            " has a sweep that has not ended; expected its end, by --resume"};
    if (!facts)
        throw DomainError{shown_path(folder) + " has no " + sweep_file +
                          "; expected the folder of a sweep"};
    return {folder, *std::move(facts), read_file(folder / results_file)};
}

// Puts the shards in order of their numbers.
void put_in_order(std::vector<ShardResults>& shards)
{
    const SweepFacts& first = shards.front().facts;
    for (const ShardResults& shard : shards) {
        SweepIdentity expected = first.identity;
        expected.shard.number = shard.facts.identity.shard.number;
        require_same(shard.facts.identity, expected, shard.folder);
    }
    std::ranges::sort(shards, {}, [](const ShardResults& shard) {
        return shard.facts.identity.shard.number;
    });
    const std::uint64_t count = first.identity.shard.count;
    for (std::uint64_t i = 0; i < std::max<std::uint64_t>(count, shards.size()); ++i) {
        const std::uint64_t found =
            i < shards.size() ? shards[i].facts.identity.shard.number : count + 1;
        if (found < i + 1)
            throw DomainError{"--merge: the shard " + std::to_string(found) + '/' +
                              std::to_string(count) +
                              " occurs twice; expected each shard once"};
        if (found > i + 1)
            throw DomainError{"--merge: the shard " + std::to_string(i + 1) + '/' +
                              std::to_string(count) + " is missing; expected all shards"};
    }
}

// The header that all shards have.
std::string common_header(std::vector<ShardResults>& shards)
{
    std::string header{shards.front().next_line()};
    if (!header.starts_with("case,") || !cell_count(header))
        throw shards.front().complaint("no header");
    for (ShardResults& shard : std::span{shards}.subspan(1))
        if (shard.next_line() != header)
            throw shard.complaint("other columns than in the first shard");
    return header;
}

// The row of a case, which is the next one of its shard.
std::string_view row_of(std::uint64_t number, ShardResults& shard, std::size_t cells)
{
    const std::string_view line = shard.next_line();
    if (!line.starts_with(std::to_string(number) + ','))
        throw shard.complaint("no row of case " + std::to_string(number));
    if (cell_count(line) != cells)
        throw shard.complaint("a row of case " + std::to_string(number) +
                              " with another number of cells than the header");
    return line;
}

// Passes the rows of all shards in the order of the cases.
void pass_rows(std::vector<ShardResults>& shards, const OutputFolder::Sink& sink)
{
    const std::string header = common_header(shards);
    const std::size_t cells = *cell_count(header);
    sink(header);
    const std::uint64_t cases = shards.front().facts.identity.cases;
    for (std::uint64_t number = 0; number < cases; ++number)
        sink(row_of(number, shards[number % shards.size()], cells));
    for (ShardResults& shard : shards) {
        const bool is_at_end = shard.used == shard.content.size();
        ++shard.line_number;
        if (!is_at_end)
            throw shard.complaint("a line after the last case");
    }
}

}  // namespace

SweepTotals merge_sweeps(std::span<const fs::path> shards, const fs::path& folder,
                         FullFolder full_folder)
{
    require(!shards.empty(), "--merge: found no folder; expected those of all shards");
    std::vector<ShardResults> results;
    for (const fs::path& shard : shards)
        results.push_back(results_in(shard));
    put_in_order(results);
    SweepFacts facts = results.front().facts;
    facts.identity.shard = {};
    facts.failed = 0;
    facts.wall_s = 0;
    for (const ShardResults& shard : results) {
        facts.failed += shard.facts.failed;
        facts.wall_s += shard.facts.wall_s;
    }
    write_results(folder, full_folder, facts,
                  [&](const OutputFolder::Sink& sink) { pass_rows(results, sink); });
    return totals_of(facts);
}

}  // namespace endmill
