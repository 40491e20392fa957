// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/trimming/trimming.h"

namespace endmill {

/// Method `winding`: removes loops by the winding number of the curves around each face.
/// It also works for sections that are not graphs over s.
///
/// 1. The tool is on the left of every curve. Open curves are closed vertically downwards
///    from both ends, and below everything.
/// 2. The index of a face is 0 far above, -1 for each curve crossed on the way from left
///    to right, and +1 for each crossed from right to left. The contributions of
///    coincident segments are added.
/// 3. Kept are the faces of index >= 0 that are connected to the outer face through such
///    faces. If there is no open curve, all faces of index >= 0 are kept, and the index
///    outside is -1 if the outermost curve runs counter-clockwise.
/// 4. The result is the border of the kept region over the intervals of s between the
///    ends of open curves, without the closing lines.
///
/// Exact for all finite coordinates, as envelope_trimming is. It equals the envelope over
/// those intervals if the kept region has no overhang. About 10 us per segment, for an
/// arrangement with exact constructions.
/// Source: docs/methods/interference.md, section 6.
/// \param curves the section curves of one plane.
/// \param options ignored.
/// \throws DomainError if a coordinate is not finite.
/// \throws LimitError if the curves have 2^31 - 1 points or more.
Trimmed winding_trimming(std::span<const SectionCurve> curves,
                         const TrimmingOptions& options = {});

}  // namespace endmill
