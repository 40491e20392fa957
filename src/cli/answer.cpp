// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/answer.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "cli/console.h"
#include "cli/shown_numbers.h"
#include "endmill/files/output_folder.h"

namespace endmill {
namespace {

struct Unit {
    std::string_view suffix;  // of a key
    std::string_view name;
};

// A suffix that ends with another one stands before it.
constexpr std::array units{Unit{"_mm_per_min", " mm/min"},
                           Unit{"_m_per_min", " m/min"},
                           Unit{"_n_m", " N m"},
                           Unit{"_min", " min"},
                           Unit{"_mm", " mm"},
                           Unit{"_deg", " degrees"},
                           Unit{"_rad", " rad"},
                           Unit{"_sr", " sr"},
                           Unit{"_n", " N"}};

// A key of a summary in the words of a report.
struct Label {
    std::string text;
    std::string_view unit;
    bool is_range = false;
};

Label label_of(std::string key)
{
    Label label;
    const auto unit = std::ranges::find_if(
        units, [&](const Unit& u) { return key.ends_with(u.suffix); });
    if (unit != units.end()) {
        label.unit = unit->name;
        key.erase(key.size() - unit->suffix.size());
    }
    label.is_range = key.ends_with("_range");
    std::ranges::replace(key, '_', ' ');
    label.text = std::move(key);
    return label;
}

std::string scalar_text(const Json& value)
{
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_boolean())
        return value.get<bool>() ? "yes" : "no";
    return value.is_number_float() ? shown_result(value.get<double>()) : value.dump();
}

std::string value_text(const Json& value, const Label& label)
{
    std::string text;
    if (value.is_object()) {
        for (const auto& [key, item] : value.items()) {
            const Label inner = label_of(key);
            if (!item.is_null())
                text += (text.empty() ? "" : ", ") + inner.text + " " +
                        value_text(item, inner);
        }
        return text;
    }
    if (!value.is_array())
        return scalar_text(value) + std::string{label.unit};
    for (const Json& item : value)
        text += (text.empty() ? "" : label.is_range ? " to " : ", ") + scalar_text(item);
    return text.empty() ? "none" : text + std::string{label.unit};
}

bool is_list_of_objects(const Json& value)
{
    return value.is_array() && !value.empty() && value.front().is_object();
}

}  // namespace

std::string answer_lines(const Json& answer)
{
    std::string lines;
    for (const auto& [key, item] : answer.items()) {
        const Label label = label_of(key);
        if (is_list_of_objects(item))
            for (const Json& one : item)
                lines += label.text + " = " + value_text(one, label) + "\n";
        else if (!item.is_null())
            lines += label.text + " = " + value_text(item, label) + "\n";
    }
    return lines;
}

void give_answer(const CommonOptions& options, const std::vector<std::string>& inputs,
                 const Json& answer, const std::string& text)
{
    if (!options.output.empty()) {
        OutputFolder folder{options.output, options.full_folder};
        for (const std::string& input : inputs)
            if (!input.empty())
                folder.protect(input);
        folder.write("summary.json", answer.dump(2) + "\n");
        folder.publish();
    }
    print_result(options, answer, text);
}

void give_answer(const CommonOptions& options, const std::vector<std::string>& inputs,
                 const Json& answer)
{
    give_answer(options, inputs, answer, answer_lines(answer));
}

}  // namespace endmill
