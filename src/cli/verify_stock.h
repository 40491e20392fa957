// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/verify_options.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/stock_history.h"

namespace endmill {

/// The stock before the path.
struct VerifyStock {
    Block block;                    ///< the block, or the bounding box of another stock
    std::optional<KeptStock> kept;  ///< empty for a block, and for dexels
    std::optional<KeptDexels> dexels;  ///< of an earlier run of five axes, or empty
    std::string file;                  ///< file of the stock; empty for a block
};

/// Whether --stock may name a mesh: it is neither a block nor the .vti or .dexels of an
/// earlier run.
bool may_be_mesh(const std::string& stock);

/// Whether --stock names dexels, which only the five-axis engine reads.
bool are_dexels(const std::string& stock);

/// Reads the stock that --stock names.
/// \param part if null, the default block is the bounding box of the path.
/// \throws DomainError if the option is not a stock; GeometryError, naming the file,
///         for a mesh that is not closed; FormatError, LimitError as the readers.
VerifyStock read_verify_stock(const VerifyOptions& options, const Part* part,
                              const ToolPath& path, const Cutter& cutter);

}  // namespace endmill
