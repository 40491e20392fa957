// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// \file
/// A page for browsers in one file: texts, arrays of numbers, and the script that draws them.

namespace endmill {

/// The place of an array in the numbers of a page.
struct PageArray {
    std::string_view kind;  ///< float64, float32, uint32 or uint8, as in JavaScript
    std::size_t offset;     ///< bytes before it, a multiple of 8
    std::size_t length;     ///< numbers
};

/// The arrays of a page: one block of bytes, which the page decodes at once.
class PageNumbers {
public:
    PageArray add(std::span<const double> numbers);         ///< appends an array
    PageArray add(std::span<const float> numbers);          ///< appends an array
    PageArray add(std::span<const std::uint32_t> numbers);  ///< appends an array
    PageArray add(std::span<const std::uint8_t> numbers);   ///< appends an array

    std::size_t size() const { return bytes_.size(); }  ///< bytes so far
    std::string base64() const;                         ///< all bytes as text

private:
    PageArray append(std::string_view kind, const void* first, std::size_t bytes,
                     std::size_t length);

    std::string bytes_;
};

/// Bytes as base64, with padding, as RFC 4648 defines it.
std::string base64(std::string_view bytes);

/// The parts of a page that do not depend on its content.
struct PageShell {
    /// The whole page, with the words TITLE, STYLE, STYLE_HASH, SCRIPT, SCRIPT_HASH, CONTENT and
    /// NUMBERS between two signs \@ each where the other texts belong.
    std::string html;
    std::string style;        ///< CSS
    std::string style_hash;   ///< SHA-256 of the style in base64, for the security policy
    std::string script;       ///< JavaScript
    std::string script_hash;  ///< SHA-256 of the script in base64
};

/// The text of a page. Whatever title and content contain, they end up as text, never as markup.
/// \param title   plain text.
/// \param content JSON.
/// \param numbers the arrays that the content refers to.
/// \throws DomainError if the style or the script could end its own element.
std::string page_html(const PageShell& shell, std::string_view title,
                      std::string_view content, const PageNumbers& numbers);

}  // namespace endmill
