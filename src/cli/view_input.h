// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/rotary_options.h"
#include "cli/surface_facts.h"

namespace endmill {

/// Options of `view`.
struct ViewOptions {
    CommonOptions common;
    std::vector<std::string> sources;  ///< folders of results, parts and paths
    PartOptions part;           ///< with --part; an empty path: that of the summaries
    RotaryOptions rotary = {};  ///< the machine of a program; default: that of a summary
    std::string tool = {};      ///< tool file; empty: the cutter of the path or a summary
};

/// A summary.json, and the file it comes from.
struct ViewSummary {
    std::filesystem::path file;
    Json content;
};

/// Sections after trimming by a method, whose name may not be known.
struct TrimmedSections {
    std::string method;
    std::string file;
};

/// The files that a page shows. A name is empty if there is no such file.
struct ViewInput {
    std::string title;
    std::vector<ViewSummary> summaries = {};
    std::string toolpath = {};
    std::string deviation = {};
    std::string sections = {};
    std::vector<TrimmedSections> trimmed = {};  ///< one for each method
    std::string visibility = {};
    std::string engagement = {};
    PartOptions part = {};
    std::string deviation_note =
        {};  ///< states if the path is not the one that was judged
    std::vector<std::filesystem::path> pictures = {};  ///< SVG files
};

/// Finds what the sources of a page hold. Of two files of one kind the later one counts. For the
/// folder of a job the folders of its steps are read, and for a folder of several results that of
/// the recommended direction or of the exact method. The part is that of the path that is shown,
/// or else that of the remaining stock; a warning states if other summaries name another part,
/// or if the path is not the one whose remaining stock is shown.
/// \throws FormatError for a source that does not exist or holds nothing to show, and for a
///         summary.json that is damaged or nested more than 64 deep.
ViewInput find_view_input(const ViewOptions& options);

/// The summary in the folder of a file of the page; null if there is none.
const ViewSummary* summary_beside(const ViewInput& input, const std::string& file);

/// The last summary of a command that read exactly the path of the page, such as that of
/// `verify`; null if there is none. It states how the path is to be read.
/// \throws FormatError, LimitError as `read_file`.
const ViewSummary* summary_of_reader(const ViewInput& input, const ReadLimits& limits);

/// The text of a key; empty if a summary has no such text.
std::string text_in(const Json& summary, const char* key);

}  // namespace endmill
