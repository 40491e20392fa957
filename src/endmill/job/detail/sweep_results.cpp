// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/sweep_results.h"

#include <nlohmann/json.hpp>

#include "endmill/files/detail/json_format.h"
#include "endmill/files/detail/output_path.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

constexpr std::string_view format_name = "endmill-sweep-results/1";
constexpr std::int64_t most = 9'000'000'000'000'000;

std::uint64_t whole(const JsonValue& root, std::string_view key, std::int64_t low)
{
    const JsonValue value = root.member(key);
    return static_cast<std::uint64_t>(value.whole_number(low, most));
}

std::string text(const JsonValue& root, std::string_view key)
{
    const JsonValue value = root.member(key);
    return value.text();
}

void append_cell(std::string& line, const std::string& cell)
{
    if (cell.find_first_of(",\"\r\n") == std::string::npos) {
        line += cell;
        return;
    }
    line += '"';
    for (const char c : cell)
        line += c == '"' ? std::string{"\"\""} : std::string{c};
    line += '"';
}

}  // namespace

std::string sweep_text(const SweepFacts& facts)
{
    const nlohmann::ordered_json content{{"format", format_name},
                                         {"name", facts.name},
                                         {"source", facts.source},
                                         {"command", facts.command},
                                         {"plan_sha256", facts.identity.plan_sha256},
                                         {"version", facts.version},
                                         {"cases", facts.identity.cases},
                                         {"shard", facts.identity.shard.number},
                                         {"shards", facts.identity.shard.count},
                                         {"failed", facts.failed},
                                         {"wall_s", facts.wall_s}};
    return content.dump(2) + '\n';
}

std::optional<SweepFacts> read_sweep_facts(const std::filesystem::path& folder)
{
    const std::filesystem::path file = folder / sweep_file;
    if (presence(file) == Presence::Absent)
        return std::nullopt;
    const std::string content = read_file(file);
    const FormatDocument document{content, file, {}, format_name};
    const JsonValue root = document.root();
    const JsonValue wall = root.member("wall_s");
    SweepFacts facts{{text(root, "plan_sha256"),
                      whole(root, "cases", 1),
                      {whole(root, "shard", 1), whole(root, "shards", 1)}},
                     text(root, "version"),
                     text(root, "name"),
                     text(root, "source"),
                     text(root, "command"),
                     whole(root, "failed", 0),
                     wall.number()};
    const SweepShard& shard = facts.identity.shard;
    if (shard.number > shard.count)
        throw root.complaint("the shard " + shard.text(), "a shard of its count");
    return facts;
}

std::string csv_line(std::span<const std::string> cells)
{
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0)
            line += ',';
        append_cell(line, cells[i]);
    }
    return line + '\n';
}

void write_results(const std::filesystem::path& folder, FullFolder full_folder,
                   const SweepFacts& facts,
                   const std::function<void(const OutputFolder::Sink&)>& rows)
{
    OutputFolder output{folder, full_folder};
    output.write_pieces(results_file, rows);
    output.write(sweep_file, sweep_text(facts));
    output.publish();
}

}  // namespace endmill
