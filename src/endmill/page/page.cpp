// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/page/page.h"

#include <array>
#include <utility>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr std::size_t alignment = 8;  // of arrays in JavaScript

// Plain text as text of HTML, also within quotes.
std::string escaped_text(std::string_view text)
{
    std::string escaped;
    for (const char letter : text) {
        switch (letter) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += letter;
        }
    }
    return escaped;
}

// JSON within a script element: the same value, without characters that could end the element.
std::string escaped_json(std::string_view json)
{
    std::string escaped;
    escaped.reserve(json.size());
    for (const char letter : json) {
        if (letter == '<')
            escaped += "\\u003c";
        else
            escaped += letter;
    }
    return escaped;
}

}  // namespace

PageArray PageNumbers::append(std::string_view kind, const void* first, std::size_t bytes,
                              std::size_t length)
{
    const PageArray array{kind, bytes_.size(), length};
    bytes_.append(static_cast<const char*>(first), bytes);
    bytes_.append((alignment - bytes_.size() % alignment) % alignment, '\0');
    return array;
}

PageArray PageNumbers::add(std::span<const double> numbers)
{
    return append("float64", numbers.data(), numbers.size_bytes(), numbers.size());
}

PageArray PageNumbers::add(std::span<const float> numbers)
{
    return append("float32", numbers.data(), numbers.size_bytes(), numbers.size());
}

PageArray PageNumbers::add(std::span<const std::uint32_t> numbers)
{
    return append("uint32", numbers.data(), numbers.size_bytes(), numbers.size());
}

PageArray PageNumbers::add(std::span<const std::uint8_t> numbers)
{
    return append("uint8", numbers.data(), numbers.size_bytes(), numbers.size());
}

std::string PageNumbers::base64() const
{
    return endmill::base64(bytes_);
}

std::string base64(std::string_view bytes)
{
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        const std::size_t given = std::min<std::size_t>(3, bytes.size() - k);
        std::uint32_t three = 0;
        for (std::size_t i = 0; i < 3; ++i)
            three =
                three << 8 | (i < given ? static_cast<unsigned char>(bytes[k + i]) : 0U);
        for (std::size_t i = 0; i < 4; ++i)
            text += i <= given ? letters[three >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

std::string page_html(const PageShell& shell, std::string_view title,
                      std::string_view content, const PageNumbers& numbers)
{
    require(shell.style.find("</") == std::string::npos,
            "page_html: the style must not contain </");
    require(shell.script.find("</script") == std::string::npos,
            "page_html: the script must not contain </script");
    const std::array<std::pair<std::string_view, std::string>, 7> texts{
        {{"@TITLE@", escaped_text(title)},
         {"@STYLE@", shell.style},
         {"@STYLE_HASH@", shell.style_hash},
         {"@SCRIPT@", shell.script},
         {"@SCRIPT_HASH@", shell.script_hash},
         {"@CONTENT@", escaped_json(content)},
         {"@NUMBERS@", numbers.base64()}}};
    // One pass over the shell, so that texts are not searched themselves.
    std::string page;
    std::string_view rest = shell.html;
    while (true) {
        const std::size_t at = rest.find('@');
        page += rest.substr(0, at);
        if (at == std::string_view::npos)
            return page;
        rest.remove_prefix(at);
        bool is_known = false;
        for (const auto& [word, text] : texts)
            if (rest.starts_with(word)) {
                page += text;
                rest.remove_prefix(word.size());
                is_known = true;
                break;
            }
        if (!is_known) {
            page += rest.front();
            rest.remove_prefix(1);
        }
    }
}

}  // namespace endmill
