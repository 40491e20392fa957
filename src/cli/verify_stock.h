// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/verify_options.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/stock_history.h"

namespace endmill {

/// What the material is before the path.
struct VerifyStock {
    Block block;                    ///< the stock, or the box around another
    std::optional<KeptStock> kept;  ///< another stock than a block
    std::string file;               ///< where that comes from; empty for a block
};

/// Whether --stock may name a mesh: it is neither a block nor the .vti of an earlier run.
bool may_be_mesh(const std::string& stock);

/// The stock that --stock names.
/// \param part null: the default block is that of the path alone.
/// \throws DomainError if it is no stock; GeometryError, naming its file, for a mesh that
///         is not closed; FormatError, LimitError as the readers.
VerifyStock read_verify_stock(const VerifyOptions& options, const Part* part,
                              const ToolPath& path, const Cutter& cutter);

}  // namespace endmill
