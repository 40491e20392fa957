// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/planning/detail/piece_order.h"
#include "endmill/planning/linking.h"
#include "endmill/strategy/detail/covered_part.h"
#include "endmill/strategy/detail/covering_pieces.h"
#include "endmill/strategy/detail/pass_moves.h"
#include "endmill/strategy/strategy_options.h"

namespace endmill {

/// Makes the pieces of a path fewer and shorter, while everything remains covered.
///
/// Pieces are left out where others cover what they cover, and their ends are cut back.
/// A short piece becomes a detour of a piece beside it. Then the pieces are ordered, and
/// neighbours in that order whose ends are near are joined by contact links.
/// Source: docs/methods/iso-scallop.md, section 6.
///
/// \param covering the pieces.
/// \param samples  of the part.
/// \param part     tests the moves.
/// \param limits   of the moves.
/// \param options  order, axis, and the length that is kept short.
void join_pieces(CoveringPieces& covering, const PartSamples& samples,
                 const CoveredPart& part, const MoveLimits& limits,
                 const StrategyOptions& options);

/// An order of pieces with short links.
std::vector<OrderedPiece> cutting_order(std::span<const LaidPass> pieces,
                                        const BallCutter& cutter,
                                        const LinkOptions& options);

/// The contacts of a piece in the order of cutting. A closed piece returns to its start.
std::vector<PassContact> contacts_in_order(const LaidPass& piece,
                                           const OrderedPiece& order);

}  // namespace endmill
