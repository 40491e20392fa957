// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/section_march.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "endmill/strategy/detail/level_lines.h"
#include "endmill/strategy/detail/reach.h"

namespace endmill {
namespace {

// Least distance of the contacts of a pass, as a share of the distance of samples.
constexpr double section_step = 0.9;
// A place that no offset beyond this share of a strip after the last pass covers is lost:
// it lies in a notch, which is mended later.
constexpr double least_advance = 1.0 / 16;
// Steps in search of the place where a front crosses an edge.
constexpr int front_steps = 3;
// Halvings in search of an offset.
constexpr int offset_halvings = 9;
constexpr int last_halvings = 6;

// A contact that misses its plane by less than this share of an edge stays.
constexpr double least_correction = 1e-6;

constexpr double unlimited = std::numeric_limits<double>::infinity();

}  // namespace

SectionMarch::SectionMarch(Coverage& coverage, Angle direction, double slack,
                           SectionContacts contacts)
    : coverage_{&coverage},
      samples_{&coverage.samples()},
      slack_{slack},
      contacts_{contacts},
      is_planar_{true},
      sine_{std::sin(direction.radians())},
      cosine_{std::cos(direction.radians())},
      strip_{2 * std::sqrt(coverage.height() *
                           (2 * coverage.cutter().radius() - coverage.height()))},
      offsets_(samples_->size()),
      order_(samples_->size()),
      is_border_(samples_->size(), false),
      is_lost_(samples_->size(), false),
      walk_{*samples_},
      beyond_(samples_->size())
{
    // twins must agree, so that lines continue from one to the other
    for (std::size_t i = 0; i < samples_->size(); ++i)
        offsets_[i] = offset_of(samples_->point(samples_->representative(i)));
    sort_samples();
}

SectionMarch::SectionMarch(Coverage& coverage, std::vector<double> offsets, double slack)
    : coverage_{&coverage},
      samples_{&coverage.samples()},
      slack_{slack},
      contacts_{SectionContacts::OnSurface},
      is_planar_{false},
      strip_{2 * std::sqrt(coverage.height() *
                           (2 * coverage.cutter().radius() - coverage.height()))},
      offsets_{std::move(offsets)},
      order_(samples_->size()),
      is_border_(samples_->size(), false),
      is_lost_(samples_->size(), false),
      walk_{*samples_},
      beyond_(samples_->size())
{
    sort_samples();
}

// Fills order_ and is_border_.
void SectionMarch::sort_samples()
{
    for (const MeshEdge& edge : samples_->border())
        for (const std::int32_t i : edge)
            is_border_[i] = true;
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
        return offsets_[a] != offsets_[b] ? offsets_[a] < offsets_[b] : a < b;
    });
}

std::vector<LaidPass> SectionMarch::passes()
{
    for (;;) {
        const double offset = next_offset();
        if (offset == unlimited)
            return std::move(passes_);
        lay(offset);
    }
}

Vec3 SectionMarch::raised(const SampleEdge& place) const
{
    return (1 - place.share) * coverage_->raised(place.from) +
           place.share * coverage_->raised(place.to);
}

// Where the gap exceeds the slack between two neighbours, on the covered side.
SampleEdge SectionMarch::front_place(std::int32_t covered, std::int32_t uncovered) const
{
    double low = 0;
    double high = 1;
    double gap_low = coverage_->gaps()[covered] - slack_;
    double gap_high = coverage_->gaps()[uncovered] - slack_;
    for (int step = 0; step < front_steps; ++step) {
        const double share = std::lerp(low, high, gap_low / (gap_low - gap_high));
        const double gap = coverage_->gap_at({covered, uncovered, share}) - slack_;
        if (gap > 0) {
            high = share;
            gap_high = gap;
        } else {
            low = share;
            gap_low = gap;
        }
    }
    return {covered, uncovered, low};
}

// Finds the samples whose balls reach a place, and those around them, as far as they lie
// ahead. It ends where it has found one beyond the limit.
void SectionMarch::walk_reach(const SampleEdge& place, double limit)
{
    const double radius = coverage_->cutter().radius();
    const Vec3 point = raised(place);
    const double least =
        std::min(offsets_[place.from], offsets_[place.to]) - samples_->spacing() / 2;
    inside_.clear();
    around_.clear();
    bool is_beyond_limit = false;
    walk_.from(std::array{place.from, place.to}, [&](std::int32_t i) {
        if (is_beyond_limit)
            return false;
        const Vec3 centre = coverage_->centre(i);
        const double x = point.x() - centre.x();
        const double y = point.y() - centre.y();
        const double z = std::min(0.0, point.z() - centre.z());
        beyond_[i] = beyond_reach(x * x + y * y + z * z, radius) - slack_;
        const bool is_inside = beyond_[i] <= 0 && offsets_[i] >= least;
        (is_inside ? inside_ : around_).push_back(i);
        is_beyond_limit = is_inside && offsets_[i] >= limit;
        return is_inside;
    });
}

// Whether a few steps lead from a place to the limit, each to the neighbour with the greatest
// offset whose ball reaches the place. It saves the walk over all samples around.
bool SectionMarch::climbs_to(const SampleEdge& place, double limit) const
{
    const double radius = coverage_->cutter().radius();
    const Vec3 point = raised(place);
    const auto reaches = [&](std::int32_t i) {
        return point_reach(coverage_->centre(i), point, radius) <= slack_;
    };
    std::int32_t at = offsets_[place.from] < offsets_[place.to] ? place.to : place.from;
    if (!reaches(at))
        return false;
    for (;;) {
        if (offsets_[at] >= limit)
            return true;
        const std::int32_t before = at;
        for (const std::int32_t neighbour : samples_->neighbours(before))
            if (offsets_[neighbour] > offsets_[at] && reaches(neighbour))
                at = neighbour;
        if (at == before)
            return false;
    }
}

// A lower bound of the farthest offset, from the edges of the net: the distance of a ball
// is convex along an edge. If it is beyond the limit, any value beyond it.
double SectionMarch::nearly_farthest(const SampleEdge& place, double limit)
{
    if (limit < unlimited && climbs_to(place, limit))
        return limit;
    walk_reach(place, limit);
    double offset = -unlimited;
    if (!inside_.empty() && offsets_[inside_.back()] >= limit)
        return offsets_[inside_.back()];
    for (const std::int32_t i : inside_) {
        offset = std::max(offset, offsets_[i]);
        for (const std::int32_t neighbour : samples_->neighbours(i))
            if (offsets_[neighbour] > offsets_[i] && beyond_[neighbour] > 0)
                offset = std::max(
                    offset, std::lerp(offsets_[i], offsets_[neighbour],
                                      beyond_[i] / (beyond_[i] - beyond_[neighbour])));
    }
    return offset;
}

// The farthest offset at which a ball in contact covers the place of a demand.
double SectionMarch::farthest(const Demand& demand)
{
    const double radius = coverage_->cutter().radius();
    const Vec3 point = raised(demand.place);
    walk_reach(demand.place, unlimited);
    std::vector<std::int32_t> triangles;
    for (const std::vector<std::int32_t>* own : {&inside_, &around_})
        for (const std::int32_t i : *own)
            for (const std::int32_t number : samples_->triangles_at(i)) {
                const auto& [a, b, c] = samples_->triangles()[number];
                if (std::max({offsets_[a], offsets_[b], offsets_[c]}) > demand.farthest)
                    triangles.push_back(number);
            }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    // whether a ball on the section of a triangle reaches the point
    const auto reaches = [&](const Triangle& triangle, double offset) {
        std::array<Vec3, 2> ends;
        std::size_t count = 0;
        for (int k = 0; k < 3 && count < 2; ++k) {
            const std::int32_t from = triangle[k];
            const std::int32_t to = triangle[(k + 1) % 3];
            if ((offsets_[from] < offset) == (offsets_[to] < offset))
                continue;
            const double share =
                (offset - offsets_[from]) / (offsets_[to] - offsets_[from]);
            ends[count++] =
                (1 - share) * coverage_->centre(from) + share * coverage_->centre(to);
        }
        return count == 2 &&
               beyond_reach(UprightSweep{ends[0], ends[1]}.squared_distance(point),
                            radius) <= slack_;
    };
    double low = demand.farthest;
    double high = low + 2 * samples_->spacing();
    for (int step = 0; step < offset_halvings; ++step) {
        const double middle = (low + high) / 2;
        const bool is_covered =
            std::any_of(triangles.begin(), triangles.end(), [&](std::int32_t number) {
                return reaches(samples_->triangles()[number], middle);
            });
        (is_covered ? low : high) = middle;
    }
    return low;
}

// The covered neighbour of an uncovered sample from which the front is nearest to the last
// pass; -1 if none is covered.
std::int32_t SectionMarch::nearest_covered(std::int32_t uncovered) const
{
    std::int32_t nearest = -1;
    double least = unlimited;
    const double gap_there = coverage_->gaps()[uncovered] - slack_;
    for (const std::int32_t neighbour : samples_->neighbours(uncovered)) {
        if (is_uncovered(neighbour))
            continue;
        const double gap = coverage_->gaps()[neighbour] - slack_;
        const double offset =
            std::lerp(offsets_[neighbour], offsets_[uncovered], gap / (gap - gap_there));
        if (offset < least) {
            least = offset;
            nearest = neighbour;
        }
    }
    return nearest;
}

// Whether a part of the surface begins at an uncovered sample, and nothing is covered there.
bool SectionMarch::is_beginning(std::int32_t uncovered) const
{
    const std::span<const std::int32_t> around = samples_->neighbours(uncovered);
    return std::all_of(around.begin(), around.end(), [&](std::int32_t neighbour) {
        return is_uncovered(neighbour) && offsets_[neighbour] >= offsets_[uncovered];
    });
}

// Adds the place as a demand if its farthest offset is below the limit. Whether a further
// pass covers it.
bool SectionMarch::add_demand(const SampleEdge& place, Demands& demands)
{
    const double offset = nearly_farthest(place, demands.limit);
    if (offset <= last_ + least_advance * strip_)
        return false;
    if (offset < demands.limit) {
        demands.open.push_back({place, offset});
        demands.limit = std::min(demands.limit, offset + 2 * samples_->spacing());
    }
    return true;
}

// Adds the places beside an uncovered sample that the next pass must cover: on the front, or
// the sample itself where a part of the surface begins. The sample is lost if no further
// pass covers one of them.
void SectionMarch::add_demands_at(std::int32_t uncovered, Demands& demands)
{
    bool is_reached = true;
    if (is_border_[uncovered]) {
        // passes end here, so that each place of the front may be the decisive one
        for (const std::int32_t neighbour : samples_->neighbours(uncovered))
            if (!is_uncovered(neighbour))
                is_reached =
                    add_demand(front_place(neighbour, uncovered), demands) && is_reached;
    } else if (const std::int32_t covered = nearest_covered(uncovered); covered >= 0) {
        is_reached = add_demand(front_place(covered, uncovered), demands);
    }
    if (is_beginning(uncovered))
        is_reached = add_demand({uncovered, uncovered, 0}, demands) && is_reached;
    if (!is_reached && offsets_[uncovered] <= last_)
        is_lost_[uncovered] = true;
}

std::vector<SectionMarch::Demand> SectionMarch::demands()
{
    while (first_ < order_.size() &&
           (!is_uncovered(order_[first_]) || is_lost_[order_[first_]]))
        ++first_;
    Demands found{{}, unlimited};
    for (std::size_t k = first_; k < order_.size() && offsets_[order_[k]] < found.limit;
         ++k)
        if (is_uncovered(order_[k]) && !is_lost_[order_[k]])
            add_demands_at(order_[k], found);
    return std::move(found.open);
}

// The offset of the next pass; infinite if there is none.
double SectionMarch::next_offset()
{
    std::vector<Demand> open = demands();
    std::sort(open.begin(), open.end(),
              [](const Demand& a, const Demand& b) { return a.farthest < b.farthest; });
    double offset = unlimited;
    for (const Demand& demand : open) {
        if (demand.farthest >= offset)
            break;
        offset = std::min(offset, farthest(demand));
    }
    return offset;
}

// The contact of a section on an edge. The surface between two samples is not quite on
// the straight line, so the first contact may miss the plane.
PassContact SectionMarch::contact_on(const SampleEdge& place, double offset) const
{
    if (contacts_ == SectionContacts::OnNet) {
        const std::int32_t near = place.share < 0.5 ? place.from : place.to;
        const auto between = [&](const Vec3& from, const Vec3& to) -> Vec3 {
            return (1 - place.share) * from + place.share * to;
        };
        const CutterContact contact{
            between(samples_->point(place.from), samples_->point(place.to)),
            between(samples_->normal(place.from), samples_->normal(place.to))};
        return {{0, 0, contact}, 0, near};
    }
    PassContact contact = samples_->contact(place);
    if (!is_planar_)
        return contact;
    const double share = place.share + (offset - offset_of(contact.at.contact.point)) /
                                           (offsets_[place.to] - offsets_[place.from]);
    if (!(std::abs(share - place.share) > least_correction) || share < 0 || share > 1)
        return contact;
    return samples_->contact({place.from, place.to, share});
}

// The contacts of a section, without those that are too close together.
LaidPass SectionMarch::pass_on(const LevelLine& line, double offset) const
{
    LaidPass pass{{}, line.is_closed};
    const double least = section_step * samples_->spacing();
    for (std::size_t k = 0; k < line.places.size(); ++k) {
        const PassContact contact = contact_on(line.places[k], offset);
        const bool is_last = k + 1 == line.places.size();
        if (pass.contacts.empty() ||
            (contact.at.contact.point - pass.contacts.back().at.contact.point).norm() >=
                least)
            pass.contacts.push_back(contact);
        else if (is_last && !line.is_closed && pass.contacts.size() > 1)
            pass.contacts.back() = contact;
    }
    return pass;
}

std::vector<LaidPass> SectionMarch::sections(double offset) const
{
    // samples below the offset in triangles that the plane crosses
    const auto is_below = [&](std::int32_t i, double value) {
        return offsets_[i] < value;
    };
    const auto begin = std::lower_bound(order_.begin(), order_.end(),
                                        offset - samples_->spacing(), is_below);
    const auto end = std::lower_bound(begin, order_.end(), offset, is_below);
    std::vector<LaidPass> found;
    if (begin == end)
        return found;
    for (const LevelLine& line : level_lines(*samples_, offsets_, {begin, end}, offset))
        found.push_back(pass_on(line, offset));
    return found;
}

// Whether everything is covered but what is lost.
bool SectionMarch::is_complete() const
{
    return std::all_of(order_.begin() + static_cast<std::ptrdiff_t>(first_), order_.end(),
                       [&](std::int32_t i) { return !is_uncovered(i) || is_lost_[i]; });
}

// The middle of the offsets at which a pass covers all that is left, if there are some.
double SectionMarch::centred_last(double offset)
{
    const auto covers_rest = [&](double at) {
        for (const LaidPass& pass : sections(at))
            coverage_->add(pass.contacts, pass.is_closed);
        const bool is_last = is_complete();
        coverage_->withdraw();
        return is_last;
    };
    if (offsets_[order_.back()] - offset > strip_ || !covers_rest(offset))
        return offset;
    double high = offset;
    double low = std::max(last_, offsets_[order_.front()]);
    for (int step = 0; step < last_halvings; ++step) {
        const double middle = (low + high) / 2;
        (covers_rest(middle) ? high : low) = middle;
    }
    return (high + offset) / 2;
}

// Lays the sections of an offset that cover something.
void SectionMarch::lay(double offset)
{
    const double at = centred_last(offset);
    for (LaidPass& pass : sections(at)) {
        coverage_->add(pass.contacts, pass.is_closed);
        if (coverage_->newly_covered(slack_).empty()) {
            coverage_->withdraw();
            continue;
        }
        coverage_->accept();
        passes_.push_back(std::move(pass));
    }
    last_ = at;
}

PassLengths pass_lengths(std::span<const LaidPass> passes, double radius)
{
    PassLengths lengths;
    const auto add = [&](const PassContact& from, const PassContact& to) {
        const Vec3 way = to.at.contact.point - from.at.contact.point;
        lengths.contact_mm += way.norm();
        lengths.tip_mm +=
            (way + radius * (to.at.contact.normal - from.at.contact.normal)).norm();
    };
    for (const auto& [contacts, is_closed] : passes) {
        for (std::size_t k = 0; k + 1 < contacts.size(); ++k)
            add(contacts[k], contacts[k + 1]);
        if (is_closed)
            add(contacts.back(), contacts.front());
    }
    return lengths;
}

}  // namespace endmill
