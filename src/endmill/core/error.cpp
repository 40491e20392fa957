// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/error.h"

#include <utility>

namespace endmill {
namespace {

// The message of a complaint, as FormatError states it.
std::string sentence(const FormatError::Complaint& complaint)
{
    std::string text = complaint.file;
    if (!complaint.place.empty())
        text += (complaint.place.starts_with('@') ? "" : ":") + complaint.place;
    text += ": " + complaint.found;
    if (!complaint.expected.empty())
        text += "; expected " + complaint.expected;
    return text;
}

}  // namespace

Error::Error(std::string code, const std::string& what)
    : std::runtime_error{what},
      code_{std::move(code)}
{
}

FormatError::FormatError(std::string code, const Complaint& complaint)
    : Error{std::move(code), sentence(complaint)},
      file_{complaint.file},
      place_{complaint.place}
{
}

}  // namespace endmill
