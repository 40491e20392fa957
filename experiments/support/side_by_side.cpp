// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/side_by_side.h"

#include <algorithm>
#include <string_view>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr std::string_view tag = "<svg ";

// The number in the first attribute `name` of a picture.
double size_of(const std::string& picture, const std::string& name)
{
    const std::string begin = " " + name + "=\"";
    const std::size_t at = picture.find(begin);
    require(picture.starts_with(tag) && at != std::string::npos,
            "side_by_side: need two pictures");
    return std::stod(picture.substr(at + begin.size()));
}

}  // namespace

std::string side_by_side(const std::string& left, const std::string& right)
{
    const double width = size_of(left, "width");
    const std::string whole_width = to_text(width + size_of(right, "width"));
    const std::string height =
        to_text(std::max(size_of(left, "height"), size_of(right, "height")));
    const std::string moved =
        std::string{tag} + "x=\"" + to_text(width) + "\" " + right.substr(tag.size());
    return std::string{tag} + "xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
           whole_width + "\" height=\"" + height + "\" viewBox=\"0 0 " + whole_width +
           " " + height +
           "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + left +
           moved + "</svg>\n";
}

}  // namespace endmill
