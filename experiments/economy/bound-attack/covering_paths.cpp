// SPDX-License-Identifier: GPL-3.0-or-later
#include "economy/bound-attack/covering_paths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "endmill/core/error.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

using std::numbers::pi;
using Lines = std::vector<std::vector<PlanePoint>>;

constexpr double step_share = 0.1;    // of a strip, between contacts
constexpr double sample_share = 0.2;  // of a strip, between samples
// Samples within so many strips of a contact in the plane of lengths are looked at. Samples
// farther away may be reached too; to leave them out only makes paths longer.
constexpr double looked_at = 1.5;
constexpr double pitch_falls = 0.97;
constexpr int most_pitches = 100;
// The most plunges of a path, as a share of the squares of a strip that the part has room for.
constexpr double greatest_plunge_share = 0.15;

double share(std::mt19937_64& engine)
{
    return std::ldexp(static_cast<double>(engine() >> 11), -53);
}

double uniform(std::mt19937_64& engine, double low, double high)
{
    return low + (high - low) * share(engine);
}

// Random numbers of a path; the same for every distance of passes.
struct Shape {
    PathKind kind;
    double angle;
    double start;  // share of the distance of passes
    double wave;   // share of the distance of passes
    double wave_length;
    PlanePoint centre;
    std::uint64_t seed;
};

Shape random_shape(PathKind kind, const PlanePoint& size, double strip,
                   std::mt19937_64& engine)
{
    Shape shape{};
    shape.kind = kind;
    shape.angle = uniform(engine, 0, pi);
    shape.start = share(engine);
    shape.wave = uniform(engine, 0.05, 0.3);
    shape.wave_length = uniform(engine, 4, 12) * strip;
    shape.centre = {uniform(engine, 0.2, 0.8) * size.x(),
                    uniform(engine, 0.2, 0.8) * size.y()};
    shape.seed = engine();
    return shape;
}

// Passes across the whole plane of lengths, in turns from both ends.
Lines straight_lines(const Shape& shape, const PlanePoint& size, double pitch,
                     double step)
{
    std::mt19937_64 errors{shape.seed};
    const double reach = size.norm() / 2 + pitch;
    const PlanePoint along{std::cos(shape.angle), std::sin(shape.angle)};
    const PlanePoint across{-along.y(), along.x()};
    Lines lines;
    for (double t = -reach + shape.start * pitch; t < reach; t += pitch) {
        const double error =
            shape.kind == PathKind::Jittered ? uniform(errors, -0.2, 0.2) * pitch : 0;
        std::vector<PlanePoint>& line = lines.emplace_back();
        for (double s = -reach; s < reach; s += step) {
            const double bend =
                shape.kind == PathKind::Wavy
                    ? shape.wave * pitch * std::sin(2 * pi * s / shape.wave_length)
                    : 0;
            line.push_back(size / 2 + s * along + (t + error + bend) * across);
        }
        if (lines.size() % 2 == 0)
            std::ranges::reverse(line);
    }
    return lines;
}

Lines spiral_line(const Shape& shape, const PlanePoint& size, double pitch, double step)
{
    std::vector<PlanePoint> line;
    double angle = 0;
    for (double radius = 0; radius < size.norm();
         radius = (shape.start * pitch / 2) + pitch * angle / (2 * pi)) {
        line.push_back(shape.centre + radius * PlanePoint{std::cos(angle + shape.angle),
                                                          std::sin(angle + shape.angle)});
        angle += step / std::max(radius, step);
    }
    return {line};
}

// Points at equal distances on the closed line through corners.
std::vector<PlanePoint> closed_line(const std::vector<PlanePoint>& corners, double step)
{
    std::vector<PlanePoint> line{corners.back()};
    PlanePoint from = corners.back();
    for (const PlanePoint& to : corners) {
        const int parts =
            std::max(1, static_cast<int>(std::ceil((to - from).norm() / step)));
        for (int k = 1; k <= parts; ++k)
            line.push_back(from + (to - from) * (static_cast<double>(k) / parts));
        from = to;
    }
    return line;
}

Lines contour_lines(const Shape& shape, const PlanePoint& size, double pitch, double step)
{
    Lines lines;
    const double middle = size.minCoeff() / 2;
    for (double in = shape.start * pitch / 2; in < middle + pitch; in += pitch) {
        const double x = std::min(in, size.x() / 2);
        const double y = std::min(in, size.y() / 2);
        lines.push_back(closed_line(
            {{x, y}, {size.x() - x, y}, {size.x() - x, size.y() - y}, {x, size.y() - y}},
            step));
    }
    return lines;
}

Lines lines_of(const Shape& shape, const PlanePoint& size, double pitch, double step)
{
    if (shape.kind == PathKind::Spiral)
        return spiral_line(shape, size, pitch, step);
    if (shape.kind == PathKind::Contour)
        return contour_lines(shape, size, pitch, step);
    return straight_lines(shape, size, pitch, step);
}

// The parts of lines that lie in the plane of lengths.
Lines clipped(const Lines& lines, const PlanePoint& size)
{
    Lines parts;
    for (const std::vector<PlanePoint>& line : lines) {
        bool is_inside = false;
        for (const PlanePoint& place : line) {
            const bool was_inside = is_inside;
            is_inside = place.x() >= 0 && place.y() >= 0 && place.x() <= size.x() &&
                        place.y() <= size.y();
            if (is_inside && !was_inside)
                parts.emplace_back();
            if (is_inside)
                parts.back().push_back(place);
        }
    }
    return parts;
}

// All lines as one, joined by straight lines.
Lines joined(const Lines& lines, double step)
{
    Lines one(1);
    std::vector<PlanePoint>& all = one.front();
    for (const std::vector<PlanePoint>& line : lines) {
        if (!all.empty()) {
            const PlanePoint from = all.back();
            const PlanePoint way = line.front() - from;
            const int parts = static_cast<int>(std::ceil(way.norm() / step));
            for (int k = 1; k < parts; ++k)
                all.push_back(from + way * (static_cast<double>(k) / parts));
        }
        all.insert(all.end(), line.begin(), line.end());
    }
    return one;
}

// The mean length of the surface along a parameter.
double mean_length(const Surface& surface, Parameter along)
{
    constexpr int lines = 9;
    constexpr int parts = 200;
    const Interval run = surface.range(along);
    const Interval other =
        surface.range(along == Parameter::U ? Parameter::V : Parameter::U);
    double length = 0;
    for (int j = 0; j < lines; ++j) {
        const double fixed = other.low + (other.high - other.low) * j / (lines - 1);
        const auto point = [&](int i) -> Vec3 {
            const double at = run.low + (run.high - run.low) * i / parts;
            return along == Parameter::U ? surface.tangents(at, fixed).point
                                         : surface.tangents(fixed, at).point;
        };
        for (int i = 0; i < parts; ++i)
            length += (point(i + 1) - point(i)).norm();
    }
    return length / lines;
}

}  // namespace

std::string_view path_kind_name(PathKind kind)
{
    constexpr std::array<std::string_view, every_path_kind.size()> names{
        "parallel", "wavy", "jittered", "zigzag", "spiral", "contour"};
    return names.at(static_cast<std::size_t>(kind));
}

CoverTask::CoverTask(const Surface& surface, const BallCutter& ball,
                     double scallop_height)
    : surface_{surface},
      side_{tool_side_signs({&surface_, 1}, Vec3::UnitZ()).front()},
      ball_{ball},
      scallop_height_{scallop_height},
      strip_mm_{2 * std::sqrt(scallop_height * (2 * ball.radius() - scallop_height))},
      size_{mean_length(surface_, Parameter::U), mean_length(surface_, Parameter::V)},
      columns_{1 + static_cast<int>(std::ceil(size_.x() / (sample_share * strip_mm_)))},
      rows_{1 + static_cast<int>(std::ceil(size_.y() / (sample_share * strip_mm_)))}
{
    raised_.reserve(static_cast<std::size_t>(columns_) * rows_);
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i) {
            const Contact contact =
                contact_at({size_.x() * i / (columns_ - 1), size_.y() * j / (rows_ - 1)});
            const Vec3 centre = contact.tip + ball_.radius() * Vec3::UnitZ();
            const Vec3 normal = (centre - contact.point) / ball_.radius();
            raised_.push_back(contact.point + scallop_height_ * normal);
        }
}

PlanePoint CoverTask::place_of(std::size_t sample) const
{
    const auto columns = static_cast<std::size_t>(columns_);
    const std::size_t row = sample / columns;
    const std::size_t column = sample % columns;
    return {size_.x() * static_cast<double>(column) / (columns_ - 1),
            size_.y() * static_cast<double>(row) / (rows_ - 1)};
}

CoverTask::Contact CoverTask::contact_at(const PlanePoint& place) const
{
    const Interval u = surface_.range(Parameter::U);
    const Interval v = surface_.range(Parameter::V);
    const SurfaceTangents at =
        surface_.tangents(u.low + (u.high - u.low) * place.x() / size_.x(),
                          v.low + (v.high - v.low) * place.y() / size_.y());
    const Vec3 centre = at.point + ball_.radius() * side_ * unit_normal(at);
    return {at.point, centre - ball_.radius() * Vec3::UnitZ(), {}};
}

std::vector<std::size_t> CoverTask::reached_from(const PlanePoint& place,
                                                 const Vec3& centre) const
{
    const double dx = size_.x() / (columns_ - 1);
    const double dy = size_.y() / (rows_ - 1);
    const auto least = [&](double at, double d) {
        return std::max(0, static_cast<int>(std::ceil((at - looked_at * strip_mm_) / d)));
    };
    const auto greatest = [&](double at, double d, int count) {
        return std::min(count - 1,
                        static_cast<int>(std::floor((at + looked_at * strip_mm_) / d)));
    };
    std::vector<std::size_t> reached;
    for (int j = least(place.y(), dy); j <= greatest(place.y(), dy, rows_); ++j)
        for (int i = least(place.x(), dx); i <= greatest(place.x(), dx, columns_); ++i) {
            const std::size_t sample = static_cast<std::size_t>(j) * columns_ + i;
            Vec3 away = raised_[sample] - centre;
            away.z() = std::min(0.0, away.z());  // above the centre the flank takes it
            if (away.squaredNorm() <= ball_.radius() * ball_.radius())
                reached.push_back(sample);
        }
    return reached;
}

std::vector<CoverTask::Piece> CoverTask::pieces_on(
    const std::vector<std::vector<PlanePoint>>& lines) const
{
    std::vector<Piece> pieces;
    pieces.reserve(lines.size());
    for (const std::vector<PlanePoint>& line : lines) {
        Piece& piece = pieces.emplace_back();
        piece.reserve(line.size());
        for (const PlanePoint& place : line) {
            Contact contact = contact_at(place);
            contact.reached =
                reached_from(place, contact.tip + ball_.radius() * Vec3::UnitZ());
            piece.push_back(std::move(contact));
        }
    }
    return pieces;
}

std::vector<int> CoverTask::times_reached(const std::vector<Piece>& pieces) const
{
    std::vector<int> times(raised_.size(), 0);
    for (const Piece& piece : pieces)
        for (const Contact& contact : piece)
            for (const std::size_t sample : contact.reached)
                ++times[sample];
    return times;
}

bool CoverTask::reach_by_plunges(std::vector<Piece>& pieces, std::vector<int>& times,
                                 std::int64_t most) const
{
    std::int64_t plunges = 0;
    for (std::size_t sample = 0; sample < times.size(); ++sample) {
        if (times[sample] > 0)
            continue;
        if (++plunges > most)
            return false;
        Contact contact = contact_at(place_of(sample));
        contact.reached =
            reached_from(place_of(sample), contact.tip + ball_.radius() * Vec3::UnitZ());
        for (const std::size_t reached : contact.reached)
            ++times[reached];
        pieces.push_back({std::move(contact)});
    }
    return true;
}

RandomCover CoverTask::random_cover(PathKind kind, std::mt19937_64& engine) const
{
    const Shape shape = random_shape(kind, size_, strip_mm_, engine);
    const double step = step_share * strip_mm_;
    const auto most_plunges =
        static_cast<std::int64_t>(uniform(engine, 0, greatest_plunge_share) *
                                  size_.prod() / (strip_mm_ * strip_mm_));
    RandomCover cover;
    cover.pitch_mm = uniform(engine, 0.95, 1.05) * strip_mm_;
    std::vector<Piece> pieces;
    std::vector<int> times;
    bool is_covering = false;
    for (int k = 0; k < most_pitches && !is_covering; ++k) {
        cover.pitch_mm *= k > 0 ? pitch_falls : 1;
        Lines lines = clipped(lines_of(shape, size_, cover.pitch_mm, step), size_);
        if (kind == PathKind::Zigzag)
            lines = joined(lines, step);
        pieces = pieces_on(lines);
        times = times_reached(pieces);
        is_covering = reach_by_plunges(pieces, times, most_plunges);
    }
    require(is_covering, "random_cover: the passes do not cover the surface");
    without_needless_ends(pieces, times);
    for (const Piece& piece : pieces) {
        cover.pieces += piece.empty() ? 0 : 1;
        for (std::size_t i = 1; i < piece.size(); ++i) {
            cover.contact_mm += (piece[i].point - piece[i - 1].point).norm();
            cover.tip_mm += (piece[i].tip - piece[i - 1].tip).norm();
        }
    }
    return cover;
}

void CoverTask::without_needless_ends(std::vector<Piece>& pieces, std::vector<int>& times)
{
    const auto is_needless = [&](const Contact& contact) {
        return std::ranges::all_of(contact.reached,
                                   [&](std::size_t sample) { return times[sample] > 1; });
    };
    const auto forget = [&](const Contact& contact) {
        for (const std::size_t sample : contact.reached)
            --times[sample];
    };
    for (Piece& piece : pieces) {
        while (!piece.empty() && is_needless(piece.back())) {
            forget(piece.back());
            piece.pop_back();
        }
        auto first = piece.begin();
        for (; first != piece.end() && is_needless(*first); ++first)
            forget(*first);
        piece.erase(piece.begin(), first);
    }
}

}  // namespace endmill
