// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/path_options.h"
#include "cli/surface_facts.h"
#include "endmill/files/path_file.h"
#include "endmill/verification/verification.h"

namespace endmill {

/// The word of --part that asks for a verification without a part.
inline constexpr const char* no_part = "none";

/// Help text of --stock.
inline constexpr const char* stock_help =
    "block (default: around the part), X0,Y0,Z0,X1,Y1,Z1 in mm, a closed mesh, or the "
    "stock.vti of an earlier run";

/// The options of `endmill verify`. An empty option is taken from the path's summary.
struct VerifyOptions {
    CommonOptions common;
    PathOptions path;
    PartOptions part;                 ///< default: the part of the summary, if any
    std::string guard;                ///< protected part; default: that of the summary
    std::string skip_facets;          ///< list of facets; default: that of the summary
    std::string tool;                 ///< file; empty: the cutter alone
    std::string stock = "block";      ///< block, six numbers, or a file
    double resolution = 0.1;          ///< mm
    std::optional<double> tolerance;  ///< mm, gouge
    std::optional<double> scallop;    ///< mm, remaining material
    int max_refine = 8;
    std::optional<RemovalEngine> engine;  ///< default: five axes if the axis turns
    std::optional<InaccessibleStock> inaccessible;  ///< default: of the path's summary
    bool engagement = false;
    bool write_stock = false;
    bool write_mesh = false;
};

/// Adds every option of `verify` to `command`.
void add_verify_options(CLI::App& command, VerifyOptions& options);

/// Refuses limits without a part to judge by. \throws DomainError
void refuse_options_without_part(const CommonOptions& options);

/// Refuses the options of mesh files if no mesh is read. \throws DomainError
void refuse_idle_mesh_options(const CommonOptions& options);

}  // namespace endmill
