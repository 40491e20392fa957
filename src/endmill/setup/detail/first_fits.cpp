// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/first_fits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>

#include <Eigen/Geometry>

#include "endmill/core/parallel.h"
#include "endmill/setup/detail/axis_node.h"
#include "endmill/setup/detail/range_limits.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
constexpr double infinity = std::numeric_limits<double>::infinity();

// The following numbers trade time for the quality of the first fit. They do not affect
// bounds.
constexpr double arc_band =
    0.2 * degree;  ///< cells this close to a circle lie on its arc
constexpr double arc_reach = 0.5 * degree;  ///< the same while a circle is improved
constexpr std::size_t cells_scanned = 512;  ///< most cells of a cone that span circles
constexpr std::size_t arcs_improved = 60;   ///< number of short arcs that are improved
constexpr std::size_t arcs_used = 12;       ///< number of arcs along which axes are tried
constexpr std::size_t poles_on_circle = 24;  ///< axes on a circle besides the cells on it
constexpr std::size_t fits_improved = 6;     ///< number of best fits that are improved
constexpr std::size_t round_size =
    32;  ///< fits before the best is updated; fixed, so that the
         ///< result does not depend on threads

constexpr double worth_keeping = 1.2;  ///< a descent may improve a fit by this factor
constexpr double rough = 0.02;         ///< slack of fits that are improved later
constexpr double coarse_step = 0.1 * degree;  ///< last step of a first descent

/// rad: two circles are equal if their normals differ by less.
constexpr double same_circle = 1e-6;

/// Relative: two fits with objectives this close are the same range, or mirror images.
constexpr double same_objective = 1e-9;

bool is_better(const AxisFit& a, const AxisFit& b)
{
    return a.objective < b.objective;
}

/// Finds the circles through a cell whose bands meet all cones. Circles through the cell
/// are binned by their azimuth there; a bin holds the AND of the columns of the cells
/// that its band may meet.
class CircleScan {
public:
    explicit CircleScan(const ConeFitting& fitting) : fitting_{fitting} {}

    /// Normals of the circles through cell `from` and one of `others` whose bins meet all
    /// cones.
    std::vector<Vec3> normals(std::size_t from, std::span<const std::size_t> others)
    {
        const Vec3& pole = fitting_.centres[from];
        const AxisView view =
            axis_view({RotaryFamily::AB, pole, arc_band, {pi, pi}}, fitting_.centres);
        with_words(fitting_.cones->words(),
                   [&](auto w) { fill<decltype(w)::value>(view); });
        const Vec3 zero = azimuth_zero(pole);
        const Vec3 quarter = pole.cross(zero);
        std::vector<Vec3> found;
        for (const std::size_t other : others) {
            const Vec3& centre = fitting_.centres[other];
            const Vec3 normal = pole.cross(centre);
            const double azimuth =
                std::atan2(centre.dot(quarter), centre.dot(zero)) + 2 * pi;
            if (normal.norm() > arc_band && complete_[bin(azimuth)] != 0)
                found.push_back(normal.normalized());
        }
        return found;
    }

private:
    static constexpr std::size_t bins =
        1440;  // of 0.125 degrees, less than a band's width

    /// Azimuths half a turn apart have the same bin, because a circle leaves the cell in
    /// both directions.
    static std::size_t bin(double azimuth)
    {
        return std::size_t(azimuth / pi * double(bins)) % bins;
    }

    template <std::size_t W>
    void fill(const AxisView& view)
    {
        const ConeSet& cones = *fitting_.cones;
        const MissingWords<W> words{cones.words()};
        const std::size_t stride = words.count();
        std::vector<std::uint64_t> always(cones.everything(),
                                          cones.everything() + stride);
        for (const SeenCell& cell : view.free)
            words.meet(always.data(), cones.missing(cell.cell));
        missing_.resize(bins * stride);
        for (std::size_t k = 0; k < bins; ++k)
            words.copy(missing_.data() + k * stride, always.data());
        for (const SeenCell& cell : view.swept) {
            const std::size_t last = bin(cell.end);
            for (std::size_t k = bin(cell.begin);; k = (k + 1) % bins) {
                words.meet(missing_.data() + k * stride, cones.missing(cell.cell));
                if (k == last)
                    break;
            }
        }
        complete_.resize(bins);
        for (std::size_t k = 0; k < bins; ++k) {
            const std::uint64_t* const here = missing_.data() + k * stride;
            complete_[k] = words.complete(here, here) ? 1 : 0;
        }
    }

    ConeFitting fitting_;
    std::vector<std::uint64_t> missing_;  ///< by bin: AND of the columns
    std::vector<char> complete_;          ///< by bin: 1 if its cells meet all cones
};

/// A key of a circle that is equal for normals within `same_circle` and for opposite
/// normals. Normals on two sides of a rounding limit get different keys and are kept
/// twice.
std::array<std::int64_t, 3> circle_key(const Vec3& normal)
{
    std::array<std::int64_t, 3> key{};
    for (int k = 0; k < 3; ++k)
        key[std::size_t(k)] = std::llround(normal[k] / same_circle);
    for (const std::int64_t first : key) {
        if (first > 0)
            break;
        if (first == 0)
            continue;
        for (std::int64_t& number : key)
            number = -number;
        break;
    }
    return key;
}

/// At most about `cells_scanned` of the cells, evenly spaced. On grids of a thousand
/// cells these are all; on finer grids the descent starts from a neighbouring circle.
std::vector<std::size_t> thinned(std::span<const std::size_t> cells)
{
    const std::size_t step = (cells.size() + cells_scanned - 1) / cells_scanned;
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < cells.size(); k += step)
        kept.push_back(cells[k]);
    return kept;
}

/// Normals of all circles of the scan, each once.
std::vector<Vec3> scanned_circles(const ConeFitting& fitting)
{
    const auto cells = thinned(fitting.cones->smallest_cone());
    const auto others = thinned(fitting.cones->other_cone());
    std::vector<std::vector<Vec3>> by_cell(cells.size());
    parallel_for(cells.size(), [&](std::size_t begin, std::size_t end) {
        CircleScan scan{fitting};
        for (std::size_t k = begin; k < end; ++k)
            by_cell[k] = scan.normals(cells[k], others);
    });
    std::vector<Vec3> circles;
    std::set<std::array<std::int64_t, 3>> known;
    for (const auto& normals : by_cell)
        for (const Vec3& normal : normals)
            if (known.insert(circle_key(normal)).second)
                circles.push_back(normal);
    return circles;
}

/// Improves the first `count` fits with different objectives by descent. \return best
/// first.
std::vector<AxisFit> improved(std::vector<AxisFit> fits, std::size_t count,
                              const ConeFitting& fitting, const Descent& descent)
{
    auto same = [](const AxisFit& a, const AxisFit& b) {
        return std::abs(a.objective - b.objective) <= same_objective * a.objective;
    };
    fits.erase(std::unique(fits.begin(), fits.end(), same), fits.end());
    fits.erase(fits.begin() + std::ptrdiff_t(std::min(fits.size(), count)), fits.end());
    parallel_for(fits.size(), [&](std::size_t begin, std::size_t end) {
        AxisFitter fitter{fitting};
        for (std::size_t k = begin; k < end; ++k)
            fits[k] = descend(fitter, fits[k], descent);
    });
    std::stable_sort(fits.begin(), fits.end(), is_better);
    return fits;
}

/// Axes on the circle with this normal: from them an arc of the circle is a thin window.
std::vector<Vec3> axes_on_circle(const ConeFitting& fitting, const Vec3& normal)
{
    std::vector<Vec3> axes;
    for (const Vec3& cell : fitting.centres)
        if (std::abs(cell.dot(normal)) < arc_band)
            axes.push_back(cell);
    const Vec3 zero = azimuth_zero(normal);
    for (std::size_t k = 0; k < poles_on_circle; ++k) {
        const double azimuth = 2 * pi * double(k) / double(poles_on_circle);
        axes.push_back(std::cos(azimuth) * zero + std::sin(azimuth) * normal.cross(zero));
    }
    return axes;
}

/// If a single cell meets all cones: an axis about which this direction alone is a range.
std::optional<Vec3> three_axis(const ConeFitting& fitting)
{
    const MissingWords<0> words{fitting.cones->words()};
    for (std::size_t cell = 0; cell < fitting.centres.size(); ++cell) {
        const Vec3& towards = fitting.centres[cell];
        const std::uint64_t* const missing = fitting.cones->missing(cell);
        if (words.complete(missing, missing))
            return fitting.measure.family == RotaryFamily::CA ? towards
                                                              : azimuth_zero(towards);
    }
    return std::nullopt;
}

}  // namespace

std::vector<AxisFit> fits_about(const ConeFitting& fitting, std::span<const Vec3> axes,
                                double below)
{
    std::vector<AxisFit> kept;
    for (std::size_t from = 0; from < axes.size(); from += round_size) {
        const std::size_t count = std::min(round_size, axes.size() - from);
        std::vector<std::optional<AxisFit>> fits(count);
        parallel_for(count, [&](std::size_t begin, std::size_t end) {
            AxisFitter fitter{fitting};
            for (std::size_t k = begin; k < end; ++k)
                fits[k] = fitter.best(axes[from + k], {worth_keeping * below, rough});
        });
        for (const auto& fit : fits) {
            if (!fit)
                continue;
            kept.push_back(*fit);
            below = std::min(below, fit->objective);
        }
    }
    std::erase_if(
        kept, [&](const AxisFit& fit) { return fit.objective > worth_keeping * below; });
    std::stable_sort(kept.begin(), kept.end(), is_better);
    return kept;
}

std::vector<Vec3> short_arcs(const ConeFitting& fitting)
{
    const ConeFitting arcs = arc_fitting(fitting, arc_reach);
    const auto fits = improved(fits_about(arcs, scanned_circles(fitting), infinity),
                               arcs_improved, arcs, {arc_band / 4});
    std::vector<Vec3> normals;
    normals.reserve(fits.size());
    for (const AxisFit& fit : fits)
        normals.push_back(fit.axis);
    return normals;
}

namespace {

// The exact best fit about these axes. Fits that were improved from rough ones may be
// slightly worse than the range about their first axis.
std::optional<AxisFit> exact_fit(const ConeFitting& fitting, std::span<const Vec3> axes)
{
    AxisFitter fitter{fitting};
    std::optional<AxisFit> best;
    double below = infinity;
    for (const Vec3& axis : axes)
        if (const auto fit = fitter.best(axis, {below})) {
            best = fit;
            below = fit->objective;
        }
    return best;
}

}  // namespace

std::optional<AxisFit> first_fit(const ConeFitting& fitting, std::span<const Vec3> starts)
{
    std::vector<Vec3> axes{starts.begin(), starts.end()};
    if (const auto axis = three_axis(fitting))
        axes.push_back(*axis);
    std::vector<AxisFit> fits = fits_about(fitting, axes, infinity);
    std::optional<AxisFit> best = exact_fit(fitting, axes);
    auto least = [&] {
        if (fits.empty())
            return infinity;
        return fits.front().objective;
    };
    auto add = [&](std::span<const Vec3> about, double first_step) {
        const auto rest = improved(fits_about(fitting, about, least()), fits_improved,
                                   fitting, {first_step, coarse_step});
        fits.insert(fits.end(), rest.begin(), rest.end());
        std::stable_sort(fits.begin(), fits.end(), is_better);
    };
    if (fitting.measure.objective != SetupObjective::Tilt) {
        auto normals = short_arcs(fitting);
        if (normals.size() > arcs_used)
            normals.erase(normals.begin() + arcs_used, normals.end());
        std::vector<Vec3> places;
        for (const Vec3& normal : normals) {
            if (fitting.measure.family == RotaryFamily::AB)
                places.push_back(normal);
            const auto on_circle = axes_on_circle(fitting, normal);
            places.insert(places.end(), on_circle.begin(), on_circle.end());
        }
        add(places, degree / 2);
    }
    std::vector<Vec3> spread;
    for (const AxisNode& node : root_nodes(fitting))
        if (node.kind == NodeKind::Axis)
            spread.push_back(centre(node));
    add(spread, 4 * degree);
    fits = improved(std::move(fits), fits_improved / 2, fitting, {coarse_step});
    if (!fits.empty() && (!best || is_better(fits.front(), *best)))
        best = fits.front();
    return best;
}

}  // namespace endmill
