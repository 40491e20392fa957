// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "endmill/files/input_csv.h"
#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/trimming_methods.h"
#include "fuzz_program.h"

namespace endmill {
namespace {

double height(const std::vector<SectionCurve>& curves)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const SectionCurve& curve : curves)
        for (const SectionPoint& point : curve.points) {
            low = std::min(low, point.y());
            high = std::max(high, point.y());
        }
    return high - low;
}

void check_curves(const std::vector<SectionCurve>& curves)
{
    for (const SectionCurve& curve : curves) {
        const auto& points = curve.points;
        program_must(points.size() >= 2);
        program_must(curve.is_closed == (points.front() == points.back()));
        program_must(curve.is_closed || points.front().x() <= points.back().x());
        program_must(std::ranges::adjacent_find(points) == points.end());
        for (const SectionPoint& point : points)
            program_must(point.allFinite());
    }
}

void check_trimmed(const std::vector<SectionCurve>& curves, const Trimmed& trimmed)
{
    for (const TrimmedCurve& curve : trimmed.curves) {
        program_must(curve.points.size() >= 2);
        for (const TrimmedPoint& point : curve.points) {
            program_must(point.at.allFinite());
            const auto& points = curves.at(point.on.curve).points;
            program_must(point.kind != TrimmedKind::Vertex ||
                         point.at == points.at(point.on.point));
        }
    }
    for (const CutOut& cut : cut_out(curves, trimmed)) {
        program_must(0 <= cut.first_point && cut.first_point <= cut.last_point);
        program_must(cut.last_point < std::ssize(curves.at(cut.curve).points));
        program_must(!cut.place || cut.place->allFinite());
    }
}

// The steps of `endmill trim --polyline`, with every method of the table.
void trim_all(const std::vector<SectionCurve>& curves)
{
    const double extent = height(curves);
    TrimmingOptions options;
    options.scan_step = extent > 0 ? extent / 1000 : 1;
    options.scan_threshold = 4 * options.scan_step;
    for (const TrimmingMethod& method : trimming_methods())
        for (const FoldDetection detection :
             {FoldDetection::Literal, FoldDetection::Guarded})
            for (const BranchSearch search :
                 {BranchSearch::March, BranchSearch::Scan, BranchSearch::ScanToEnd}) {
                options.detection = detection;
                options.search = search;
                check_trimmed(curves, method.trim(curves, options));
            }
}

}  // namespace
}  // namespace endmill

// Curves that are read satisfy the contract of SectionCurve, and every method trims them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace endmill;
    const std::string_view text{reinterpret_cast<const char*>(bytes), size};
    try {
        const std::vector<SectionCurve> curves = parse_polylines(text, "f.csv");
        check_curves(curves);
        trim_all(curves);
    } catch (const FormatError& error) {
        program_must(error.file() == "f.csv" && is_fit_for_a_terminal(error.what()));
    } catch (const LimitError&) {
    }
    return 0;
}
