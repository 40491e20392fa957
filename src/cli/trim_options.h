// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/surface_facts.h"
#include "endmill/cutter/cutter.h"
#include "endmill/offset/offset_mesh.h"
#include "endmill/planning/linking.h"
#include "endmill/trimming/trimming.h"

namespace endmill {

/// The defaults for fold detection, borders and method.
enum class TrimMode {
    Corrected,  ///< guarded detection, contacts on borders and creases, method envelope
    Paper,      ///< literal detection, no contacts on borders, method 3
};

/// The options of `endmill trim`. An empty option takes the default that the help states.
struct TrimOptions {
    CommonOptions common;
    PartOptions part;              ///< its path is empty with `polyline`
    std::string polyline;          ///< file of curves; empty if a part is given
    std::optional<Cutter> offset;  ///< curves are profiles, to be offset for this cutter
    std::optional<Cutter> cutter;
    std::optional<int> planes;      ///< default 100
    std::optional<double> pitch;    ///< mm, replaces the number of planes
    std::optional<double> scallop;  ///< mm, replaces the number of planes
    double direction_deg = 0;       ///< feed direction, from +x
    int grid = 200;
    TrimMode mode = TrimMode::Corrected;
    std::optional<std::string> method;       ///< a name in the table, or "all"
    std::optional<FoldDetection> detection;  ///< methods 1, 2, 3
    std::optional<double> scan_step;         ///< mm, method 1
    std::optional<double> scan_threshold;    ///< mm, method 1
    std::optional<BranchSearch> search;      ///< method 3
    std::optional<BoundaryContact> boundary;
    double tolerance = 0.01;               ///< mm, largest gouge depth
    std::optional<double> thin_tolerance;  ///< mm; default a tenth of the tolerance
    double allowance = 0;                  ///< mm of stock to leave
    bool refine = false;
    PassOrder order = PassOrder::ZigZag;
    std::optional<double> safe_height;  ///< mm
    bool explain = false;
    std::optional<int> figure;  ///< number of a plane
    bool figure_worst = false;  ///< draw the plane where the methods differ most
    std::optional<int> repeat;  ///< repetitions of a comparison of all methods
    /// Names of methods to compare with the exact one; nothing else is written.
    std::vector<std::string> compare_only;
};

/// Adds every option of `trim` to `command`.
void add_trim_options(CLI::App& command, TrimOptions& options);

/// Checks the options together.
/// \throws DomainError naming options that exclude each other, are missing or have no
/// effect.
void check_trim_options(const TrimOptions& options);

/// Throws DomainError with `what` unless `holds`.
void require_option(bool holds, const std::string& what);

/// The word for `mode`, as --mode takes it.
std::string_view mode_word(TrimMode mode);

/// Name of the selected or default method, or "all", also with --compare-only.
std::string method_name(const TrimOptions& options);

/// The cutter of --cutter or --offset.
const std::optional<Cutter>& cutter_of(const TrimOptions& options);

/// The selected or default treatment of borders, corners and creases.
BoundaryContact boundary_contact(const TrimOptions& options);

/// The selected or default tolerance within which points of the path are dropped, in mm.
double thin_tolerance(const TrimOptions& options);

/// The options of a trimming method.
/// \param extent of the curves in z, in mm. It sets the step of method 1 if no cutter
/// is given.
TrimmingOptions trimming_options(const TrimOptions& options, double extent);

/// Adds every setting with the value in force to a summary.
void add_settings(Json& summary, const TrimOptions& options,
                  const TrimmingOptions& trimming);

}  // namespace endmill
