// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace endmill {

/// Root of everything that endmill throws on purpose. `what()` is one line for a person.
class Error : public std::runtime_error {
public:
    /// \param code stable word for programs, such as "E_JSON". \param what one line.
    Error(std::string code, const std::string& what);

    const std::string& code() const { return code_; }  ///< stable, never translated

private:
    std::string code_;
};

/// An argument lies outside the set on which the called function is defined.
class DomainError : public Error {
public:
    explicit DomainError(const std::string& what) : Error{"E_PARAM", what} {}
};

/// An input file is missing, unreadable or malformed. The message reads
/// "FILE:PLACE: FOUND; expected EXPECTED", or "FILE@BYTE: …" in a binary file.
class FormatError : public Error {
public:
    /// What is wrong with a file, and where.
    struct Complaint {
        std::string file;   ///< its path, as the caller gave it
        std::string place;  ///< "LINE", "LINE:COLUMN", "@BYTE", a JSON pointer, or empty
        std::string found;  ///< what stands there
        std::string expected;  ///< what should; empty if that goes without saying
    };

    FormatError(std::string code, const Complaint& complaint);

    const std::string& file() const { return file_; }    ///< path of the file
    const std::string& place() const { return place_; }  ///< see Complaint::place

private:
    std::string file_;
    std::string place_;
};

/// The arguments are sound, and the geometry does not allow what is asked.
class GeometryError : public Error {
public:
    explicit GeometryError(const std::string& what) : Error{"E_GEOMETRY", what} {}
};

/// An output could not be written.
class OutputError : public Error {
public:
    explicit OutputError(const std::string& what) : Error{"E_OUTPUT", what} {}
};

/// A limit on memory, points or time was reached.
class LimitError : public Error {
public:
    explicit LimitError(const std::string& what) : Error{"E_LIMIT", what} {}
};

/// Throws DomainError with `what` unless `holds`.
inline void require(bool holds, const char* what)
{
    if (!holds)
        throw DomainError{what};
}

}  // namespace endmill
