// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace endmill {

/// The folder of data that come with the program, such as "machines". The first there is of:
/// share/endmill/KIND, where the program is installed; datasets/KIND in a folder above the
/// program, where it was built; datasets/KIND in the current folder.
/// \param option that asks for it, for the message.
/// \throws DomainError with these places if it is in none.
std::filesystem::path data_folder(const std::string& option, const std::string& kind);

}  // namespace endmill
