// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace endmill {

/// An element of an XML text.
struct XmlElement {
    std::string name;                               ///< of the tag
    std::map<std::string, std::string> attributes;  ///< values with entities resolved
    std::string text;  ///< text directly in the element, with entities resolved
};

/// A small XML parser for the tests, independent of the library.
class SmallXml {
public:
    /// All elements in the order of their opening tags.
    /// \throws std::runtime_error if the text is not well-formed.
    static std::vector<XmlElement> parse(std::string_view text)
    {
        SmallXml parser{text};
        parser.element();
        parser.expect(parser.rest_.find_first_not_of(" \n") == std::string_view::npos,
                      "content after the root");
        return parser.elements_;
    }

private:
    explicit SmallXml(std::string_view text) : rest_{text} {}

    static void expect(bool holds, const char* what)
    {
        if (!holds)
            throw std::runtime_error{what};
    }

    bool accept(std::string_view word)
    {
        const bool found = rest_.starts_with(word);
        if (found)
            rest_.remove_prefix(word.size());
        return found;
    }

    std::string take_until(std::string_view stops)
    {
        const auto end = rest_.find_first_of(stops);
        expect(end != std::string_view::npos, "the text ends early");
        std::string taken{rest_.substr(0, end)};
        rest_.remove_prefix(end);
        return taken;
    }

    static std::string resolved(std::string_view raw)
    {
        const std::map<std::string_view, char> entities{{"&amp;", '&'},
                                                        {"&lt;", '<'},
                                                        {"&gt;", '>'},
                                                        {"&quot;", '"'},
                                                        {"&#39;", '\''}};
        std::string text;
        while (!raw.empty()) {
            expect(raw.front() != '<' && raw.front() != '>', "a bare bracket");
            if (raw.front() != '&') {
                text += raw.front();
                raw.remove_prefix(1);
                continue;
            }
            const std::string_view name = raw.substr(0, raw.find(';') + 1);
            expect(entities.contains(name), "a bare ampersand");
            text += entities.at(name);
            raw.remove_prefix(name.size());
        }
        return text;
    }

    void attributes(XmlElement& element)
    {
        while (accept(" ")) {
            const std::string key = take_until("= />");
            expect(accept("=\""), "an attribute without a quoted value");
            expect(element.attributes.emplace(key, resolved(take_until("\""))).second,
                   "an attribute twice");
            expect(accept("\""), "a quote that is not closed");
        }
    }

    void element()
    {
        expect(accept("<"), "no element");
        const std::size_t self = elements_.size();
        elements_.emplace_back();
        elements_[self].name = take_until(" />");
        attributes(elements_[self]);
        if (accept("/>"))
            return;
        expect(accept(">"), "a tag that is not closed");
        while (true) {
            elements_[self].text += resolved(take_until("<"));
            if (accept("</" + elements_[self].name + ">"))
                return;
            element();
        }
    }

    std::string_view rest_;
    std::vector<XmlElement> elements_;
};

}  // namespace endmill
