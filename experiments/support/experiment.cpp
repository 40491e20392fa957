// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/experiment.h"

#include <cstdio>
#include <exception>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/files/detail/strict_json.h"
#include "endmill/files/read_file.h"
#include "endmill/files/surface_file.h"

namespace endmill {
namespace {

std::filesystem::path folder_of(const std::string& name)
{
    return std::filesystem::path{"experiments"} / name;
}

std::unique_ptr<const JsonDocument> read_params(const std::string& name)
{
    const std::filesystem::path path = folder_of(name) / "params.json";
    return std::make_unique<const JsonDocument>(read_file(path), path.string());
}

// Applies `read` to the parameter `key`.
template <typename Read>
auto parameter(const JsonDocument& params, std::string_view key, const Read& read)
{
    const JsonValue root = params.root();
    const JsonValue parameters = root.member("parameters");
    return read(parameters.member(key));
}

// Applies `read` to each item of the list `key`.
template <typename Read>
auto parameter_list(const JsonDocument& params, std::string_view key, const Read& read)
{
    return parameter(params, key, [&](const JsonValue& list) {
        std::vector<decltype(read(list))> values;
        for (std::size_t i = 0; i < list.size(); ++i)
            values.push_back(read(list.item(i)));
        return values;
    });
}

double as_number(const JsonValue& value)
{
    return value.number();
}

std::string as_text(const JsonValue& value)
{
    return value.text();
}

void print_usage(const std::string& program, const std::string& name)
{
    std::printf(
        "%s OUTPUT_FOLDER\n\n"
        "Runs the experiment %s and writes result.csv into OUTPUT_FOLDER.\n"
        "To be called from the root of the repository; scripts/reproduce.sh does so.\n"
        "What it shows: experiments/%s/README.md\n",
        program.c_str(), name.c_str(), name.c_str());
}

}  // namespace

Experiment::Experiment(std::string name, const std::filesystem::path& output)
    : name_{std::move(name)},
      params_{read_params(name_)},
      results_{output, FullFolder::Accept}
{
}

Experiment::~Experiment() = default;

double Experiment::number(std::string_view key)
{
    used_.emplace(key);
    return parameter(*params_, key, as_number);
}

std::vector<double> Experiment::numbers(std::string_view key)
{
    used_.emplace(key);
    return parameter_list(*params_, key, as_number);
}

std::string Experiment::text(std::string_view key)
{
    used_.emplace(key);
    return parameter(*params_, key, as_text);
}

std::vector<std::string> Experiment::texts(std::string_view key)
{
    used_.emplace(key);
    return parameter_list(*params_, key, as_text);
}

void Experiment::write(const std::filesystem::path& file, std::string_view content)
{
    results_.write(file, content);
}

void Experiment::write_result(const CsvTable& table)
{
    require(table.columns().front() == "row", "result.csv: the first column must be row");
    write("result.csv", table.text());
}

void Experiment::publish()
{
    const JsonValue root = params_->root();
    if (const auto parameters = root.find_member("parameters")) {
        const std::vector<std::string_view> known{used_.begin(), used_.end()};
        parameters->allow_only(known);
    }
    results_.publish();
}

Surface dataset_surface(const std::string& name)
{
    return read_surface("datasets/surfaces/" + name + ".json").surfaces.front();
}

double published_number(const std::string& name, const std::string& row,
                        const std::string& column)
{
    const std::filesystem::path path = folder_of(name) / "published.csv";
    const CsvTable table = read_csv(path);
    for (std::size_t i = 0; i < table.rows(); ++i)
        if (table.cell(i, "row") == row && table.cell(i, "column") == column)
            if (const auto number = table.number(i, "published"))
                return *number;
    throw FormatError{
        "E_CSV",
        {path.string(), "", "no number for row " + row + ", column " + column, ""}};
}

int run_experiment(int argc, const char* const* argv, const std::string& name,
                   const std::function<void(Experiment&)>& body)
{
    const std::string argument = argc == 2 ? argv[1] : "";
    if (argument == "--help" || argument == "-h") {
        print_usage(argv[0], name);
        return 0;
    }
    if (argument.empty() || argument.front() == '-') {
        std::fprintf(stderr, "%s: expected one argument, the output folder; see --help\n",
                     name.c_str());
        return 2;
    }
    try {
        Experiment experiment{name, argument};
        body(experiment);
        experiment.publish();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: error: %s\n", name.c_str(), error.what());
        return 1;
    }
}

}  // namespace endmill
