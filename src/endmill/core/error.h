// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace endmill {

/// \file
/// The exceptions of the library. The program maps each type to an exit code.

/// Base class of all exceptions that endmill throws on purpose. `what()` is one line of
/// text for a person.
class Error : public std::runtime_error {
public:
    /// \param code a stable word for programs, such as "E_JSON".
    /// \param what one line for a person.
    Error(std::string code, const std::string& what);

    const std::string& code() const { return code_; }  ///< stable word, never translated

private:
    std::string code_;
};

/// An argument is outside the domain of the called function.
class DomainError : public Error {
public:
    /// \param what the function, then the condition that must hold.
    explicit DomainError(const std::string& what) : Error{"E_PARAM", what} {}
};

/// An input file is missing, unreadable or malformed. The message has the form
/// "FILE:PLACE: FOUND; expected EXPECTED", or "FILE@BYTE: ..." for a binary file.
class FormatError : public Error {
public:
    /// The error in a file, and its place.
    struct Complaint {
        std::string file;   ///< path, as the caller gave it
        std::string place;  ///< "LINE", "LINE:COLUMN", "@BYTE", a JSON pointer or empty
        std::string found;  ///< what the file contains at this place
        std::string expected;  ///< what it should contain; empty if that is obvious
    };

    /// \param code a stable word for programs. \param complaint makes the message.
    FormatError(std::string code, const Complaint& complaint);

    const std::string& file() const { return file_; }    ///< path of the file
    const std::string& place() const { return place_; }  ///< as in Complaint::place

private:
    std::string file_;
    std::string place_;
};

/// The arguments are valid, but the geometry does not allow the operation.
class GeometryError : public Error {
public:
    /// \param what the reason, with the place if there is one.
    explicit GeometryError(const std::string& what) : Error{"E_GEOMETRY", what} {}
};

/// An output file could not be written.
class OutputError : public Error {
public:
    /// \param what the file and the reason.
    explicit OutputError(const std::string& what) : Error{"E_OUTPUT", what} {}
};

/// A limit on memory, points or time was reached.
class LimitError : public Error {
public:
    /// \param what the limit and what would need more.
    explicit LimitError(const std::string& what) : Error{"E_LIMIT", what} {}
};

/// Throws DomainError with the message `what` if `holds` is false.
inline void require(bool holds, const char* what)
{
    if (!holds)
        throw DomainError{what};
}

}  // namespace endmill
