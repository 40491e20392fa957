// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/gcode_reader.h"

#include "endmill/post/detail/gcode_interpreter.h"

namespace endmill {

Program parse_gcode(std::string_view text, const std::string& file,
                    const GcodeReadOptions& options)
{
    return interpreted_gcode(text, file, options);
}

}  // namespace endmill
