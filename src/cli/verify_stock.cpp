// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify_stock.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/console.h"
#include "cli/progress.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/dexel_file.h"
#include "endmill/files/mesh_file.h"
#include "endmill/files/vtk.h"
#include "endmill/stock/mesh_stock.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

std::optional<Block> block_of_numbers(const std::string& text)
{
    std::vector<double> numbers;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto number = number_from_text(text.substr(begin, end - begin));
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
        begin = end + 1;
    }
    if (numbers.size() != 6)
        return std::nullopt;
    const Block block{{numbers[0], numbers[1], numbers[2]},
                      {numbers[3], numbers[4], numbers[5]}};
    if (!(block.low.array() < block.high.array()).all())
        throw DomainError{"--stock " + text +
                          ": expected X0,Y0,Z0,X1,Y1,Z1 in mm with X0 < X1, Y0 < Y1 and "
                          "Z0 < Z1"};
    return block;
}

// Checks the memory limit before the mesh is converted to heights.
HeightStock stock_of_mesh(const VerifyOptions& options)
{
    const ReadLimits& limits = options.common.limits;
    const MeshFile mesh =
        read_mesh(options.stock, {limits, options.part.units, options.part.up});
    require_stock_memory(mesh_box(mesh.mesh), options.resolution, limits.max_memory_gib);
    return mesh_stock(mesh.mesh, options.resolution);
}

KeptStock stock_of_file(const VerifyOptions& options)
{
    const std::filesystem::path path{options.stock};
    std::error_code ignored;
    if (path.empty() ||
        (options.stock.find(',') != std::string::npos && !exists(path, ignored)))
        throw DomainError{"--stock " + printable(options.stock) +
                          ": expected block, X0,Y0,Z0,X1,Y1,Z1 in mm, or a file"};
    if (path.extension() == ".vti")
        return read_stock(path, options.common.limits);
    return {naming(options.stock, [&] { return stock_of_mesh(options); })};
}

}  // namespace

bool may_be_mesh(const std::string& stock)
{
    return stock != "block" && !block_of_numbers(stock) && !are_dexels(stock) &&
           std::filesystem::path{stock}.extension() != ".vti";
}

bool are_dexels(const std::string& stock)
{
    return std::filesystem::path{stock}.extension() == ".dexels";
}

VerifyStock read_verify_stock(const VerifyOptions& options, const Part* part,
                              const ToolPath& path, const Cutter& cutter)
{
    if (options.stock == "block")
        return {default_block(part, path, cutter), {}, {}, {}};
    if (const auto block = block_of_numbers(options.stock))
        return {*block, {}, {}, {}};
    const ProgressLine progress{"reading the stock", options.common};
    if (are_dexels(options.stock)) {
        KeptDexels dexels = read_dexels(options.stock, options.common.limits);
        const Block box = dexels.dexels.block();
        return {box, {}, std::move(dexels), options.stock};
    }
    KeptStock stock = stock_of_file(options);
    const Block box = material_box(stock.heights);
    return {box, std::move(stock), {}, options.stock};
}

}  // namespace endmill
