// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/answer.h"

#include "cli/console.h"
#include "cli/shown_numbers.h"
#include "endmill/files/output_folder.h"

namespace endmill {
namespace {

std::string value_text(const Json& value)
{
    if (value.is_string())
        return value.get<std::string>();
    return value.is_number_float() ? shown(value.get<double>()) : value.dump();
}

}  // namespace

std::string answer_lines(const Json& answer)
{
    std::string lines;
    for (const auto& [key, item] : answer.items())
        lines += key + " = " + value_text(item) + "\n";
    return lines;
}

void give_answer(const CommonOptions& options, const std::vector<std::string>& inputs,
                 const Json& answer)
{
    if (!options.output.empty()) {
        OutputFolder folder{options.output, options.full_folder};
        for (const std::string& input : inputs)
            if (!input.empty())
                folder.protect(input);
        folder.write("summary.json", answer.dump(2) + "\n");
        folder.publish();
    }
    print_result(options, answer, answer_lines(answer));
}

}  // namespace endmill
