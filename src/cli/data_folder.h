// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace endmill {

/// The folder of the running program, or empty if the system does not report it.
std::filesystem::path program_folder();

/// The folder of data that is delivered with the program, such as "machines". The search
/// order is share/endmill/KIND of the installation, datasets/KIND in any folder above the
/// program (a build folder), and datasets/KIND in the current folder.
/// \param option that needs the folder; the error message names it.
/// \throws DomainError with these places if none of them exists.
std::filesystem::path data_folder(const std::string& option, const std::string& kind);

}  // namespace endmill
