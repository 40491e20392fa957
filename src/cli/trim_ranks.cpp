// SPDX-License-Identifier: GPL-3.0-or-later
// Rank 0 sends each other rank the name of the method, its options and a share of the curves.
// The answer names the vertices that are left by their numbers, a run at a time, so that it is
// short; only other points have coordinates. All ranks run one program on machines of one
// kind, so that numbers are sent as they lie in memory.

#include "cli/trim_ranks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "cli/program_ranks.h"
#include "endmill/core/parallel.h"
#include "endmill/trimming/curve_shares.h"
#include "endmill/trimming/trimmed_planes.h"

namespace endmill {
namespace {

class MessageWriter {
public:
    template <typename Value>
    void add(const Value& value)
    {
        static_assert(std::is_trivially_copyable_v<Value>);
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }

    void add_count(std::size_t count) { add(static_cast<std::uint64_t>(count)); }

    void add_text(std::string_view text)
    {
        add_count(text.size());
        bytes_.append(text);
    }

    void add_point(const SectionPoint& point)
    {
        add(point.x());
        add(point.y());
    }

    std::string_view bytes() const { return bytes_; }
    void reserve(std::size_t size) { bytes_.reserve(size); }

private:
    std::string bytes_;
};

class MessageReader {
public:
    explicit MessageReader(std::string_view bytes) : rest_{bytes} {}

    template <typename Value>
    Value take()
    {
        Value value;
        std::memcpy(&value, take_bytes(sizeof(value)).data(), sizeof(value));
        return value;
    }

    std::size_t take_count() { return take<std::uint64_t>(); }
    std::string_view take_text() { return take_bytes(take_count()); }

    SectionPoint take_point()
    {
        const auto s = take<double>();
        const auto z = take<double>();
        return {s, z};
    }

private:
    std::string_view take_bytes(std::size_t count)
    {
        if (count > rest_.size())
            throw std::runtime_error{"a message of another rank ends too early"};
        const std::string_view bytes = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return bytes;
    }

    std::string_view rest_;
};

using Curves = std::span<const SectionCurve>;

// The work of another rank.
struct TrimJob {
    const TrimmingMethod* method;
    TrimmingOptions options;
    std::vector<std::vector<SectionCurve>> planes;
};

std::size_t point_count(std::span<const SectionCurve> curves)
{
    std::size_t points = 0;
    for (const SectionCurve& curve : curves)
        points += curve.points.size();
    return points;
}

void add_curves(MessageWriter& message, Curves curves)
{
    message.add_count(curves.size());
    for (const SectionCurve& curve : curves) {
        message.add(curve.is_closed);
        message.add_count(curve.points.size());
        for (const SectionPoint& point : curve.points)
            message.add_point(point);
    }
}

std::vector<SectionCurve> take_curves(MessageReader& message)
{
    std::vector<SectionCurve> curves(message.take_count());
    for (SectionCurve& curve : curves) {
        curve.is_closed = message.take<bool>();
        curve.points.resize(message.take_count());
        for (SectionPoint& point : curve.points)
            point = message.take_point();
    }
    return curves;
}

void send_job(int rank, const TrimmingMethod& method, const TrimmingOptions& options,
              std::span<const Curves> planes)
{
    std::size_t bytes = 200;
    for (const Curves curves : planes)
        bytes += point_count(curves) * 2 * sizeof(double) + curves.size() * 16 + 8;
    MessageWriter message;
    message.reserve(bytes);
    message.add_text(method.name);
    message.add(options);
    message.add_count(planes.size());
    for (const Curves curves : planes)
        add_curves(message, curves);
    program_ranks().send(rank, message.bytes());
}

TrimJob job_in(std::string_view bytes)
{
    MessageReader message{bytes};
    const auto methods = trimming_methods();
    const auto method =
        std::ranges::find(methods, message.take_text(), &TrimmingMethod::name);
    if (method == methods.end())
        throw std::runtime_error{"rank 0 asks for a method that this program lacks"};
    TrimJob job{&*method, message.take<TrimmingOptions>(), {}};
    job.planes.resize(message.take_count());
    for (std::vector<SectionCurve>& curves : job.planes)
        curves = take_curves(message);
    return job;
}

// Whether the point is the vertex `on`, so that its number suffices.
bool is_plain_vertex(const TrimmedPoint& point, std::span<const SectionCurve> curves)
{
    if (point.kind != TrimmedKind::Vertex || point.on != point.across)
        return false;
    const SectionPoint& vertex = curves[point.on.curve].points[point.on.point];
    return std::bit_cast<std::uint64_t>(vertex.x()) ==
               std::bit_cast<std::uint64_t>(point.at.x()) &&
           std::bit_cast<std::uint64_t>(vertex.y()) ==
               std::bit_cast<std::uint64_t>(point.at.y());
}

// The number of points from `first` on that are consecutive vertices of one curve.
std::size_t run_length(std::span<const TrimmedPoint> points,
                       std::span<const SectionCurve> curves)
{
    std::size_t length = 0;
    while (length < points.size() && is_plain_vertex(points[length], curves) &&
           points[length].on.curve == points[0].on.curve &&
           points[length].on.point ==
               points[0].on.point + static_cast<std::int32_t>(length))
        ++length;
    return length;
}

void add_curve(MessageWriter& message, const TrimmedCurve& curve,
               std::span<const SectionCurve> curves)
{
    message.add(curve.is_closed);
    message.add_count(curve.points.size());
    for (std::span<const TrimmedPoint> rest{curve.points}; !rest.empty();) {
        const std::size_t length = run_length(rest, curves);
        message.add_count(length);
        message.add(rest[0].on);
        if (length == 0) {
            message.add_point(rest[0].at);
            message.add(rest[0].across);
            message.add(rest[0].kind);
        }
        rest = rest.subspan(std::max<std::size_t>(1, length));
    }
}

TrimmedCurve take_curve(MessageReader& message, std::span<const SectionCurve> curves)
{
    TrimmedCurve curve;
    curve.is_closed = message.take<bool>();
    const std::size_t count = message.take_count();
    curve.points.reserve(count);
    while (curve.points.size() < count) {
        const std::size_t length = message.take_count();
        auto on = message.take<SegmentNumber>();
        if (length == 0) {
            const SectionPoint at = message.take_point();
            const auto across = message.take<SegmentNumber>();
            curve.points.push_back({at, on, across, message.take<TrimmedKind>()});
        }
        for (std::size_t k = 0; k < length; ++k, ++on.point)
            curve.points.push_back(
                {curves[on.curve].points.at(on.point), on, on, TrimmedKind::Vertex});
    }
    return curve;
}

// The same text with static lifetime, which rules need.
std::string_view lasting(std::string_view text)
{
    static std::set<std::string, std::less<>> texts;
    const auto known = texts.find(text);
    return known != texts.end() ? *known : *texts.emplace(text).first;
}

void add_result(MessageWriter& message, const Trimmed& result, Curves curves)
{
    message.add_text(result.rule);
    message.add(result.unresolved);
    message.add_count(result.rules.size());
    for (const AppliedRule& rule : result.rules) {
        message.add(rule.curve);
        message.add(rule.first_point);
        message.add(rule.last_point);
        message.add_text(rule.rule);
    }
    message.add_count(result.curves.size());
    for (const TrimmedCurve& curve : result.curves)
        add_curve(message, curve, curves);
}

Trimmed take_result(MessageReader& message, Curves curves)
{
    Trimmed result;
    result.rule = lasting(message.take_text());
    result.unresolved = message.take<int>();
    result.rules.resize(message.take_count());
    for (AppliedRule& rule : result.rules) {
        rule.curve = message.take<std::int32_t>();
        rule.first_point = message.take<std::int32_t>();
        rule.last_point = message.take<std::int32_t>();
        rule.rule = lasting(message.take_text());
    }
    result.curves.resize(message.take_count());
    for (TrimmedCurve& curve : result.curves)
        curve = take_curve(message, curves);
    return result;
}

// Trims the curves of each plane.
std::vector<Trimmed> trimmed_here(std::span<const Curves> planes,
                                  const TrimmingMethod& method,
                                  const TrimmingOptions& options)
{
    std::vector<Trimmed> results(planes.size());
    parallel_for(planes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            results[i] = method.trim(planes[i], options);
    });
    return results;
}

// The results of another rank for its planes.
std::vector<Trimmed> received(int rank, std::span<const Curves> planes)
{
    const std::string bytes = program_ranks().receive_from(rank).content;
    MessageReader message{bytes};
    std::vector<Trimmed> results;
    results.reserve(planes.size());
    for (const Curves curves : planes)
        results.push_back(take_result(message, curves));
    return results;
}

// Divides planes into shares of consecutive ones with about the same number of points.
// \return the end of each share.
std::vector<std::size_t> plane_shares(std::span<const Curves> planes, std::size_t count)
{
    std::size_t all = 0;
    for (const Curves curves : planes)
        all += point_count(curves);
    std::vector<std::size_t> ends;
    std::size_t points = 0;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        while (ends.size() < count && points >= all * (ends.size() + 1) / count)
            ends.push_back(i);
        points += point_count(planes[i]);
    }
    ends.resize(count, planes.size());
    return ends;
}

std::vector<Curves> curves_of(std::span<const PlaneSection> sections)
{
    std::vector<Curves> planes;
    planes.reserve(sections.size());
    for (const PlaneSection& plane : sections)
        planes.emplace_back(plane.curves);
    return planes;
}

// Trims planes that do not depend on each other, a share on each rank.
std::vector<Trimmed> divided_planes(std::span<const PlaneSection> sections,
                                    const TrimmingMethod& method,
                                    const TrimmingOptions& options,
                                    const std::function<void(double share)>& progress)
{
    const std::vector<Curves> planes = curves_of(sections);
    const auto count = static_cast<std::size_t>(program_ranks().count());
    const std::vector<std::size_t> ends = plane_shares(planes, count);
    const auto share = [&](std::size_t k) {
        const std::size_t begin = k == 0 ? 0 : ends[k - 1];
        return std::span{planes}.subspan(begin, ends[k] - begin);
    };
    for (std::size_t k = 1; k < count; ++k)
        send_job(static_cast<int>(k), method, options, share(k));
    std::vector<Trimmed> results = trimmed_here(share(0), method, options);
    for (std::size_t k = 1; k < count; ++k) {
        if (progress)
            progress(static_cast<double>(k) / static_cast<double>(count));
        std::ranges::move(received(static_cast<int>(k), share(k)),
                          std::back_inserter(results));
    }
    return results;
}

// Trims the curves of a plane, a share on each rank.
Trimmed divided_trimming(std::span<const SectionCurve> curves,
                         const TrimmingMethod& method, const TrimmingOptions& options,
                         const std::function<void(double share)>& progress)
{
    Ranks& ranks = program_ranks();
    const std::vector<CurveShare> shares =
        curve_shares(curves, method.coupling, static_cast<std::size_t>(ranks.count()));
    const auto share_of = [&](const CurveShare& share) {
        return std::array{curves.subspan(share.first, share.count)};
    };
    for (std::size_t k = 1; k < shares.size(); ++k)
        send_job(static_cast<int>(k), method, options, share_of(shares[k]));
    std::vector<Trimmed> results;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const auto share = share_of(shares[k]);
        results.push_back(k == 0 ? method.trim(share[0], options)
                                 : received(static_cast<int>(k), share).front());
        if (progress)
            progress(static_cast<double>(k + 1) / static_cast<double>(shares.size()));
    }
    return joined(shares, std::move(results));
}

}  // namespace

std::vector<Trimmed> trimmed_sections(const TrimInput& input,
                                      const TrimmingMethod& method,
                                      const TrimmingOptions& options,
                                      const std::function<void(double share)>& progress)
{
    if (input.part || program_ranks().count() == 1)
        return trim_planes(input.sections, input.ranges(), method, options, progress);
    std::vector<Trimmed> trimmed;
    if (input.sections.size() == 1)
        trimmed.push_back(
            divided_trimming(input.sections[0].curves, method, options, progress));
    else
        trimmed = divided_planes(input.sections, method, options, progress);
    clip_planes(input.sections, input.ranges(), trimmed);
    return trimmed;
}

void serve_trimming(const TrimOptions& options)
{
    while (!options.polyline.empty()) {
        const TrimJob job = job_in(program_ranks().receive_from(0).content);
        const std::vector<Curves> planes{job.planes.begin(), job.planes.end()};
        const auto results = trimmed_here(planes, *job.method, job.options);
        MessageWriter message;
        for (std::size_t i = 0; i < planes.size(); ++i)
            add_result(message, results[i], planes[i]);
        program_ranks().send(0, message.bytes());
    }
}

}  // namespace endmill
