// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cli/plan_summary.h"
#include "endmill/files/output_folder.h"
#include "endmill/surface/part.h"

namespace endmill {

/// A part, its properties, and the options of the command.
struct PlanTask {
    const Part& part;
    std::span<const Surface> surfaces;  ///< of the part; none if it is a mesh
    const PlanContext& context;
    const PlanOptions& options;
    const Part* guard = nullptr;  ///< that no move enters; null: none
    /// Rotation of the part for the plan; its third row is the tool axis in the part.
    Eigen::Matrix3d part_to_machine = Eigen::Matrix3d::Identity();
    std::vector<std::size_t> skipped = {};  ///< facets of the file that stay uncut
    /// The same by their numbers in a mesh that is planned for five axes.
    std::vector<std::size_t> skipped_in_mesh = {};
};

/// A gouge deeper than the inner tolerance.
struct KnownGouge {
    Parameter along;  ///< direction of the passes
    double depth_mm;
};

/// Summary and report of a plan.
struct PlanResult {
    Json summary;
    std::string text;
    std::size_t uncovered_places;     ///< places that a verified plan does not cover
    std::optional<KnownGouge> gouge;  ///< the deepest, if a path is known to gouge
    /// Whether the verdict on a path by a strategy is not "clean".
    bool is_undecided = false;
};

/// Adds the facets that a plan leaves uncut to its summary: skip_facets, cut_faces, skipped, and
/// the part_sha256 of the file whose facets and faces these are. Nothing if all are cut.
/// \param folder of the summary.
void name_cut_facets(Json& summary, const PlanTask& task,
                     const std::filesystem::path& folder);

/// Removes the files of an earlier plan from `folder`, so that none is mistaken for a file of
/// this run.
void replace_earlier_plans(OutputFolder& folder);

/// Plans along the requested parameters, and writes paths, pictures and summaries into
/// `folder`. The files of an earlier run are replaced. Both directions are planned at
/// the same time if they fit into memory.
/// \throws LimitError before planning if the path would exceed the memory limit; also
///         throws as plan_iso_parametric.
PlanResult write_plan(const PlanTask& task, OutputFolder& folder);

}  // namespace endmill
