// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "endmill/files/detail/strict_json.h"
#include "endmill/files/read_file.h"
#include "endmill/job/detail/case_command.h"

/// \file
/// The parameters of the cases of a sweep: a grid, a list or random samples.

namespace endmill {

/// The most cases of a sweep.
inline constexpr std::uint64_t most_cases = 10'000'000;

/// All combinations of the steps of several axes. The last axis varies fastest.
class CaseGrid {
public:
    /// \param axes an array of objects; the keys of one vary together.
    /// \throws FormatError with the place of a key that the command does not know or that
    ///         occurs twice, of a value that it refuses, and of arrays of different lengths;
    ///         or if there are more than `most_cases`, with their number.
    CaseGrid(const JsonValue& axes, const CaseCommand& command);

    const std::vector<std::string>& keys() const { return keys_; }  ///< axis by axis
    std::uint64_t count() const { return count_; }                  ///< number of cases
    std::vector<std::string> values(std::uint64_t number) const;    ///< one for each key

private:
    struct Axis {
        std::size_t steps = 0;
        std::vector<std::vector<std::string>> values;  // of each key
    };
    void add_axis(const JsonValue& keys, const CaseCommand& command);

    std::vector<std::string> keys_;
    std::vector<Axis> axes_;
    std::uint64_t count_ = 1;
};

/// The rows of a CSV table, whose header names the keys. In a row with an empty cell its
/// key is not given.
class CaseList {
public:
    /// \param file of the table, for messages.
    /// \throws FormatError E_CSV with the line, as `CsvLines` and for what `CaseGrid`
    ///         refuses.
    CaseList(std::string content, const std::filesystem::path& file,
             const CaseCommand& command);

    const std::vector<std::string>& keys() const { return keys_; }  ///< of the header
    std::uint64_t count() const { return rows_.size(); }            ///< number of cases
    std::vector<std::string> values(std::uint64_t number) const;    ///< one for each key

private:
    std::string content_;
    std::vector<std::string> keys_;
    std::vector<std::size_t> rows_;  // where each row begins
};

/// Random values within ranges or of lists. Those of a case depend on the seed, the key and
/// the number of the case only.
class CaseSamples {
public:
    /// \param random an object with the keys count, seed and parameters.
    /// \throws FormatError with the place, for what `CaseGrid` refuses and for a range that
    ///         is empty, infinite or not positive where it should be.
    CaseSamples(const JsonValue& random, const CaseCommand& command);

    const std::vector<std::string>& keys() const
    {
        return keys_;
    }                                               ///< in alphabetical order
    std::uint64_t count() const { return count_; }  ///< number of cases
    std::vector<std::string> values(std::uint64_t number) const;  ///< one for each key

private:
    struct Range {
        double low;
        double high;
        bool is_geometric;
        bool is_whole;
    };
    using Choices = std::vector<std::string>;

    static Range range_of(const JsonValue& parameter);

    std::vector<std::string> keys_;
    std::vector<std::variant<Range, Choices>> parameters_;  // of each key
    std::uint64_t count_ = 0;
    std::uint64_t seed_ = 0;
};

/// The parameters of the cases of a sweep, in one of the three forms.
using CaseValues = std::variant<CaseGrid, CaseList, CaseSamples>;

}  // namespace endmill
