// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/move_contacts.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"

// Contacts by projection are searched from move to move, because neighbouring contacts
// are near each other. The moves are divided into blocks of fixed length. Each block is
// searched by one thread and starts without a predecessor, so the result does not depend
// on the number of threads.

namespace endmill {
namespace {

// Number of consecutive moves that are searched one from another. It is fixed, so that
// the result does not depend on the number of threads.
constexpr std::size_t block_moves = 128;

// The point at which the ball misses the part by most.
struct Miss {
    std::size_t point = 0;
    double distance = 0;  // mm from the ball to the part; negative if they overlap
};

Vec3 centre_at(const Vec3& tip, double radius)
{
    return tip + radius * Vec3::UnitZ();
}

std::optional<FootPlace> stated_place(const PathPoint& point, const ContactSearch& part)
{
    if (!point.contact() || point.patch < 0 ||
        static_cast<std::size_t>(point.patch) >= part.surfaces())
        return std::nullopt;
    return FootPlace{static_cast<std::size_t>(point.patch), point.contact()->u,
                     point.contact()->v};
}

// The middle between the feet at both ends, or the foot at the end if they are on
// different surfaces.
FootPlace between(const FootPlace& from, const FootPlace& to)
{
    if (from.surface != to.surface)
        return to;
    return {to.surface, (from.u + to.u) / 2, (from.v + to.v) / 2};
}

// Searches the contacts of consecutive moves, each starting from the last.
class BlockSearch {
public:
    BlockSearch(const ToolPath& path, const ContactSearch& part, const BallOnPart& ball)
        : path_{path},
          part_{part},
          ball_{ball}
    {
    }

    MoveContact contact(const CutMove& move)
    {
        const FootPlace from = last_ && last_point_ == move.point - 1
                                   ? *last_
                                   : end_place(move.point - 1, move.from());
        const FootPlace to = end_place(move.point, move.to());
        last_ = to;
        last_point_ = move.point;
        // The tolerance is the radius: the ball at the middle of a chord is off the part
        // by the sagitta, which is not an error.
        const BallFoot foot = part_.foot(centre_at(move.middle(), ball_.radius),
                                         between(from, to), ball_.radius, ball_.radius);
        return {foot.normal, foot};
    }

    const Miss& worst() const { return worst_; }

private:
    FootPlace end_place(std::size_t point, const Vec3& tip)
    {
        const auto stated = stated_place(path_.points[point], part_);
        const BallFoot foot =
            part_.foot(centre_at(tip, ball_.radius), stated ? stated : last_,
                       ball_.radius, ball_.tolerance);
        const double miss = foot.distance - ball_.radius;
        if (std::abs(miss) > std::abs(worst_.distance))
            worst_ = {point, miss};
        return foot.at;
    }

    const ToolPath& path_;
    const ContactSearch& part_;
    const BallOnPart& ball_;
    std::optional<FootPlace> last_;
    std::size_t last_point_ = 0;  // point of the path to which `last_` belongs
    Miss worst_;
};

void require_touch(const ToolPath& path, const Miss& worst, double tolerance)
{
    if (std::abs(worst.distance) <= tolerance)
        return;
    const PathPoint& point = path.points[worst.point];
    const Vec3& tip = point.location.tip;
    throw GeometryError{
        "the path does not belong to the part: the ball " +
        std::string{worst.distance > 0 ? "misses it by " : "reaches into it by "} +
        to_text(std::abs(worst.distance)) + " mm at point " +
        std::to_string(point.point) + " of pass " + std::to_string(point.pass) +
        " (tip " + to_text(tip.x()) + ", " + to_text(tip.y()) + ", " + to_text(tip.z()) +
        " mm); expected at most " + to_text(tolerance) + " mm (--contact-tolerance)"};
}

// Checks that a contact stated in the path belongs to this ball.
void require_ball(const PathPoint& point, const BallOnPart& ball)
{
    if (!point.contact())
        return;
    const Vec3 centre = centre_at(point.location.tip, ball.radius);
    const double distance = (point.contact()->contact.point - centre).norm();
    if (!(std::abs(distance - ball.radius) <= ball.tolerance))
        throw GeometryError{
            "the contact stated in the path for point " + std::to_string(point.point) +
            " of pass " + std::to_string(point.pass) + " is " + to_text(distance) +
            " mm from the centre of ball:" + to_text(2 * ball.radius) + "; expected " +
            to_text(ball.radius) + " mm within " + to_text(ball.tolerance) +
            " mm (--contact-tolerance): a path of this cutter, without an allowance"};
}

}  // namespace

void require_ball(const ToolPath& path, std::span<const CutMove> moves,
                  const BallOnPart& ball)
{
    for (const CutMove& move : moves) {
        require_ball(path.points[move.point - 1], ball);
        require_ball(path.points[move.point], ball);
    }
}

std::optional<MoveContact> stated_contact(const ToolPath& path, const CutMove& move)
{
    const Vec3* from = path.points[move.point - 1].normal();
    const Vec3* to = path.points[move.point].normal();
    if (!from || !to)
        return std::nullopt;
    const Vec3 sum = *from + *to;
    const double length = sum.norm();
    return length > 0 ? std::optional{MoveContact{sum / length}} : std::nullopt;
}

std::vector<std::optional<MoveContact>> projected_contacts(const ToolPath& path,
                                                           std::span<const CutMove> moves,
                                                           const ContactSearch& part,
                                                           const BallOnPart& ball)
{
    std::vector<std::optional<MoveContact>> contacts(moves.size());
    const std::size_t blocks = (moves.size() + block_moves - 1) / block_moves;
    std::vector<Miss> misses(blocks);
    parallel_for(blocks, [&](std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block) {
            BlockSearch search{path, part, ball};
            const std::size_t last = std::min((block + 1) * block_moves, moves.size());
            for (std::size_t i = block * block_moves; i < last; ++i)
                contacts[i] = search.contact(moves[i]);
            misses[block] = search.worst();
        }
    });
    Miss worst;
    for (const Miss& miss : misses)
        if (std::abs(miss.distance) > std::abs(worst.distance))
            worst = miss;
    require_touch(path, worst, ball.tolerance);
    return contacts;
}

}  // namespace endmill
