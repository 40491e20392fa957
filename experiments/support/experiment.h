// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/files/csv.h"
#include "endmill/files/output_folder.h"
#include "endmill/surface/surface.h"

namespace endmill {

class JsonDocument;

/// What a driver works on: the "parameters" of its params.json, the data that it reads,
/// and the folder that it writes to. Paths count from the root of the repository, which
/// must be the working directory.
class Experiment {
public:
    /// \param name "PAPER/ITEM", the experiment's folder under experiments/.
    /// \param output the folder of the results; what stands in it stays.
    /// \throws FormatError if params.json is missing or malformed.
    Experiment(std::string name, const std::filesystem::path& output);
    ~Experiment();
    Experiment(const Experiment&) = delete;
    Experiment& operator=(const Experiment&) = delete;

    const std::string& name() const { return name_; }  ///< "PAPER/ITEM"
    const std::filesystem::path& output() const { return results_.path(); }  ///< folder

    /// A parameter, by its key in params.json: a number, a list of numbers, a text, a
    /// list of texts. \throws FormatError if it is missing or something else.
    double number(std::string_view key);
    std::vector<double> numbers(std::string_view key);     ///< see number
    std::string text(std::string_view key);                ///< see number
    std::vector<std::string> texts(std::string_view key);  ///< see number

    /// Keeps a file that `publish` will show.
    void write(const std::filesystem::path& file, std::string_view content);

    /// Keeps result.csv. \throws DomainError unless its first column is `row`.
    void write_result(const CsvTable& table);

    /// Shows all files at once.
    /// \throws FormatError, nothing shown, if params.json has a parameter that nobody
    /// read.
    void publish();

private:
    std::string name_;
    std::unique_ptr<const JsonDocument> params_;
    std::set<std::string, std::less<>> used_;
    OutputFolder results_;
};

/// The surface in datasets/surfaces/NAME.json.
Surface dataset_surface(const std::string& name);

/// The number that the published.csv of experiment `name` states for a cell of its
/// result. \throws FormatError if it states none.
double published_number(const std::string& name, const std::string& row,
                        const std::string& column);

/// main() of a driver that is called with one argument, the output folder: runs `body`,
/// then publishes what it wrote. An error becomes a line on standard error.
/// \return the exit code: 0; 2 for a wrong command line; 1 for any error.
int run_experiment(int argc, const char* const* argv, const std::string& name,
                   const std::function<void(Experiment&)>& body);

}  // namespace endmill
