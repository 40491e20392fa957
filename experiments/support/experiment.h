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

/// The inputs and outputs of a driver: the "parameters" of its params.json and the folder
/// of its results. Paths are relative to the root of the repository, which must be the
/// working directory.
class Experiment {
public:
    /// \param name "PAPER/ITEM", the folder under experiments/.
    /// \param output folder of the results; existing files stay.
    /// \throws FormatError if params.json is missing or malformed.
    Experiment(std::string name, const std::filesystem::path& output);
    ~Experiment();
    Experiment(const Experiment&) = delete;
    Experiment& operator=(const Experiment&) = delete;

    const std::string& name() const { return name_; }  ///< "PAPER/ITEM"
    const std::filesystem::path& output() const { return results_.path(); }  ///< folder

    /// The parameter `key` of params.json: a number, a list of numbers, a text or a list
    /// of texts.
    /// \throws FormatError if it is missing or has another type.
    double number(std::string_view key);
    std::vector<double> numbers(std::string_view key);     ///< see number
    std::string text(std::string_view key);                ///< see number
    std::vector<std::string> texts(std::string_view key);  ///< see number

    /// Adds a file to those that `publish` writes.
    void write(const std::filesystem::path& file, std::string_view content);

    /// Adds result.csv. \throws DomainError unless its first column is `row`.
    void write_result(const CsvTable& table);

    /// Writes all files at once.
    /// \throws FormatError, without writing, if params.json has a parameter that was
    /// never read.
    void publish();

private:
    std::string name_;
    std::unique_ptr<const JsonDocument> params_;
    std::set<std::string, std::less<>> used_;
    OutputFolder results_;
};

/// The surface in datasets/surfaces/NAME.json.
Surface dataset_surface(const std::string& name);

/// The published number of a cell: experiments/NAME/published.csv, `row`, `column`.
/// \throws FormatError if there is none.
double published_number(const std::string& name, const std::string& row,
                        const std::string& column);

/// The main function of a driver with one argument, the output folder: runs `body`, then
/// publishes its files. An error is printed on standard error.
/// \return the exit code: 0; 2 for a wrong command line; 1 for any other error.
int run_experiment(int argc, const char* const* argv, const std::string& name,
                   const std::function<void(Experiment&)>& body);

}  // namespace endmill
