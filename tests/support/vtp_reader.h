// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "small_xml.h"

namespace endmill {

/// Reads a file by the definition of VTK's XML formats: elements have offsets into the
/// bytes after '_', where each array follows its size in bytes.
class VtpReader {
public:
    explicit VtpReader(const std::string& file)
    {
        const std::string opening = "<AppendedData encoding=\"raw\">\n_";
        const std::string closing = "\n </AppendedData>";
        const auto begin = file.find(opening) + opening.size();
        const auto end = file.rfind(closing);
        bytes_ = file.substr(begin, end - begin);
        const auto root = file.find("<VTKFile");
        elements_ = SmallXml::parse(file.substr(root, begin - root) + file.substr(end));
    }

    std::string attribute(const std::string& element, const std::string& key) const
    {
        for (const XmlElement& candidate : elements_)
            if (candidate.name == element)
                return candidate.attributes.at(key);
        throw std::runtime_error{"no element " + element};
    }

    /// \param skipped number of arrays of that name before the wanted one.
    template <class Number>
    std::vector<Number> array(const std::string& name, const std::string& type,
                              int skipped = 0) const
    {
        for (const XmlElement& element : elements_) {
            if (element.name != "DataArray" || element.attributes.at("Name") != name ||
                skipped-- > 0)
                continue;
            EXPECT_EQ(element.attributes.at("type"), type);
            const std::size_t offset = std::stoul(element.attributes.at("offset"));
            std::uint64_t size = 0;
            std::memcpy(&size, bytes_.data() + offset, sizeof size);
            EXPECT_LE(offset + sizeof size + size, bytes_.size());
            std::vector<Number> numbers(size / sizeof(Number));
            if (size > 0)
                std::memcpy(numbers.data(), bytes_.data() + offset + sizeof size, size);
            return numbers;
        }
        throw std::runtime_error{"no array " + name};
    }

private:
    std::string bytes_;
    std::vector<XmlElement> elements_;
};

}  // namespace endmill
