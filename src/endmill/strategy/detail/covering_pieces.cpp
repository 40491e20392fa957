// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/covering_pieces.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// Halvings of the sides of a triangle in search of places that are not covered. Between two
// strips the gap rises by half_width / R of the distance.
constexpr int most_halvings = 6;

// Triangles that are tested before the results are kept. It limits memory.
constexpr std::size_t updated_at_once = 100'000;

}  // namespace

double pass_length(const LaidPass& pass)
{
    double length = 0;
    const auto point = [&](std::size_t k) { return pass.contacts[k].at.contact.point; };
    for (std::size_t k = 0; k + 1 < pass.contacts.size(); ++k)
        length += (point(k + 1) - point(k)).norm();
    return pass.is_closed ? length + (point(0) - point(pass.contacts.size() - 1)).norm()
                          : length;
}

// Tests triangles one by one.
class CoveringPieces::TriangleTest {
public:
    explicit TriangleTest(const CoveringPieces& pieces) : pieces_{pieces} {}

    // Whether a triangle is covered.
    bool is_covered(std::int32_t triangle)
    {
        ends_at_first_ = true;
        return !run(triangle);
    }

    // The worst place in a triangle that is found not to be covered.
    std::optional<MissedPlace> worst(std::int32_t triangle)
    {
        ends_at_first_ = false;
        return run(triangle);
    }

private:
    struct Corner {
        CutterContact contact;
        Vec3 raised;
        std::array<double, 3> weights;
        std::span<const double>
            gaps;  // by the moves near the triangle; empty before a search
    };

    const UprightSweep& sweep(std::int32_t move) const
    {
        return pieces_.moves_[move].sweep;
    }

    Corner corner(const CutterContact& contact,
                  const std::array<double, 3>& weights) const
    {
        return {contact, contact.point + pieces_.height_ * contact.normal, weights, {}};
    }

    Corner middle(const Corner& a, const Corner& b) const
    {
        std::array<double, 3> weights{};
        for (int k = 0; k < 3; ++k)
            weights[k] = (a.weights[k] + b.weights[k]) / 2;
        return corner(pieces_.samples_.near_place(a.contact, b.contact, 0.5), weights);
    }

    // Measures the gaps of three corners that a search with so many halvings left meets.
    // Those of earlier corners remain as long as the parts of their triangle are searched.
    void measure(std::array<Corner, 3>& corners, int halvings)
    {
        const std::size_t moves = rows_.size();
        std::span<double> gaps =
            std::span{gaps_}.subspan(3 * moves * (most_halvings - halvings), 3 * moves);
        for (Corner& own : corners) {
            rows_.gaps_at(own.raised, pieces_.radius_, gaps.first(moves));
            own.gaps = gaps.first(moves);
            gaps = gaps.subspan(moves);
        }
    }

    // Keeps a place if it is missed by more than the places before.
    void note(const Corner& corner)
    {
        double gap = pieces_.radius_;
        for (const double own : corner.gaps)
            gap = std::min(gap, own);
        if (gap > 0 && (!worst_ || gap > worst_->gap))
            worst_ = {triangle_, corner.weights, gap};
    }

    // How far the part may lie below the plane through the corners. On an edge a quadratic
    // form lies d / 8 below its chord, in the triangle at most d / 6, where d is the greatest
    // product of an edge with the turn of the normal along it.
    static double sag(const std::array<Corner, 3>& corners)
    {
        double greatest = 0;
        for (int k = 0; k < 3; ++k) {
            const CutterContact& a = corners[k].contact;
            const CutterContact& b = corners[(k + 1) % 3].contact;
            greatest =
                std::max(greatest, -(b.point - a.point).dot(b.normal - a.normal) / 6);
        }
        return greatest;
    }

    // Whether one of some moves covers a triangle. What a move covers is convex.
    bool is_covered_at_once(const std::array<Corner, 3>& corners,
                            std::span<const std::int32_t> moves) const
    {
        const double margin = sag(corners);
        return std::any_of(moves.begin(), moves.end(), [&](std::int32_t move) {
            return std::all_of(corners.begin(), corners.end(), [&](const Corner& corner) {
                return beyond_reach(sweep(move).squared_distance(corner.raised),
                                    pieces_.radius_) <= -margin;
            });
        });
    }

    // The same for the moves near the triangle.
    static bool is_covered_at_once(const std::array<Corner, 3>& corners)
    {
        const double least = -sag(corners);
        const auto& [a, b, c] = corners;
        for (std::size_t k = 0; k < a.gaps.size(); ++k)
            if (a.gaps[k] <= least && b.gaps[k] <= least && c.gaps[k] <= least)
                return true;
        return false;
    }

    void search(const std::array<Corner, 3>& corners, int halvings)
    {
        const auto& [a, b, c] = corners;
        if (halvings == 0 || is_covered_at_once(corners))
            return;
        std::array<Corner, 3> middles{middle(a, b), middle(b, c), middle(c, a)};
        measure(middles, halvings - 1);
        for (const Corner& own : middles)
            note(own);
        const auto& [ab, bc, ca] = middles;
        const std::array<std::array<Corner, 3>, 4> parts{
            {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}};
        for (const auto& part : parts) {
            if (ends_at_first_ && worst_)
                return;
            search(part, halvings - 1);
        }
    }

    // The moves that cover a sample at a triangle or beside it.
    void find_near(const Triangle& triangle)
    {
        rows_.clear();
        seen_.resize(pieces_.moves_.size(), 0);
        ++search_;
        for (const int corner : {0, 1, 2})
            for (const std::int32_t i : pieces_.samples_.neighbours(triangle[corner]))
                for (const std::int32_t move : pieces_.moves_at_[i])
                    if (std::exchange(seen_[move], search_) != search_)
                        rows_.add(sweep(move));
        gaps_.resize(std::max(gaps_.size(), 3 * rows_.size() * (most_halvings + 1)));
    }

    std::optional<MissedPlace> run(std::int32_t number)
    {
        const PartSamples& samples = pieces_.samples_;
        const Triangle& triangle = samples.triangles()[number];
        const auto corner_at = [&](int k) {
            std::array<double, 3> weights{};
            weights[k] = 1;
            return corner(samples.place_at(triangle[k]), weights);
        };
        std::array<Corner, 3> corners{corner_at(0), corner_at(1), corner_at(2)};
        const auto is_wanted = [&](std::int32_t i) { return samples.is_wanted(i); };
        const auto has_move = [&](std::int32_t i) {
            return !pieces_.moves_at_[i].empty();
        };
        triangle_ = number;
        worst_.reset();
        const bool are_wanted = std::all_of(triangle.begin(), triangle.end(), is_wanted);
        const bool are_covered = std::all_of(triangle.begin(), triangle.end(), has_move);
        if (are_covered && is_covered_at_once(corners, pieces_.moves_at_[triangle[0]]))
            return std::nullopt;
        find_near(triangle);
        measure(corners, most_halvings);
        for (int k = 0; k < 3; ++k)
            if (is_wanted(triangle[k]) && !has_move(triangle[k]))
                note(corners[k]);
        if (!worst_ && are_wanted)
            search(corners, most_halvings);
        return worst_;
    }

    const CoveringPieces& pieces_;
    bool ends_at_first_ = false;
    std::int32_t triangle_ = 0;
    std::optional<MissedPlace> worst_;
    SweepRows rows_;                   // of the moves near the triangle
    std::vector<double> gaps_;         // of corners by these moves
    std::vector<std::uint32_t> seen_;  // by move, the last search that found it
    std::uint32_t search_ = 0;         // number of the current search
};

CoveringPieces::CoveringPieces(const PartSamples& samples, const BallCutter& cutter,
                               double height)
    : samples_{samples},
      radius_{cutter.radius()},
      height_{height},
      moves_at_(samples.size()),
      walk_{samples},
      tested_(samples.triangles().size(), 0),
      outdated_(samples.triangles().size()),
      is_outdated_(samples.triangles().size(), 1),
      is_missed_(samples.triangles().size(), 1)
{
    for (std::size_t k = 0; k < outdated_.size(); ++k)
        outdated_[k] = static_cast<std::int32_t>(k);
}

// The number of a new move.
std::int32_t CoveringPieces::move_between(const PassContact& from, const PassContact& to)
{
    const auto centre = [&](const PassContact& contact) -> Vec3 {
        return contact.at.contact.point + radius_ * contact.at.contact.normal;
    };
    CoveringMove move{{centre(from), centre(to)}, {}, {}};
    walk_.from(std::array{from.near, to.near}, [&](std::int32_t i) {
        const Vec3 raised = samples_.point(i) + height_ * samples_.normal(i);
        const bool is_inside =
            beyond_reach(move.sweep.squared_distance(raised), radius_) <= 0;
        (is_inside ? move.covered : move.around).push_back(i);
        return is_inside;
    });
    if (free_moves_.empty()) {
        moves_.push_back(std::move(move));
        return static_cast<std::int32_t>(moves_.size() - 1);
    }
    const std::int32_t number = free_moves_.back();
    free_moves_.pop_back();
    moves_[number] = std::move(move);
    return number;
}

CoveringPieces::MoveNumbers CoveringPieces::moves_along(
    std::span<const PassContact> contacts)
{
    MoveNumbers moves;
    moves.reserve(contacts.size());
    for (std::size_t k = 0; k + 1 < contacts.size(); ++k)
        moves.push_back(move_between(contacts[k], contacts[k + 1]));
    return moves;
}

void CoveringPieces::enter(std::int32_t move)
{
    for (const std::int32_t i : moves_[move].covered)
        moves_at_[i].push_back(move);
}

void CoveringPieces::leave(std::int32_t move)
{
    for (const std::int32_t i : moves_[move].covered) {
        MoveNumbers& moves = moves_at_[i];
        moves.erase(std::find(moves.begin(), moves.end(), move));
    }
}

void CoveringPieces::release(std::span<const std::int32_t> moves)
{
    free_moves_.insert(free_moves_.end(), moves.begin(), moves.end());
}

// Has the triangles around moves tested again: those that are missed, or all.
void CoveringPieces::outdate(std::span<const std::int32_t> moves, bool also_covered)
{
    for (const std::int32_t move : moves)
        for (const auto* around : {&moves_[move].covered, &moves_[move].around})
            for (const std::int32_t i : *around)
                for (const std::int32_t triangle : samples_.triangles_at(i))
                    if ((also_covered || is_missed_[triangle] != 0) &&
                        std::exchange(is_outdated_[triangle], 1) == 0)
                        outdated_.push_back(triangle);
}

void CoveringPieces::update()
{
    std::vector<std::optional<MissedPlace>> worst;
    for (std::size_t first = 0; first < outdated_.size(); first += updated_at_once) {
        const std::size_t count = std::min(updated_at_once, outdated_.size() - first);
        worst.assign(count, std::nullopt);
        parallel_for(count, [&](std::size_t begin, std::size_t end) {
            TriangleTest test{*this};
            for (std::size_t k = begin; k < end; ++k)
                worst[k] = test.worst(outdated_[first + k]);
        });
        for (std::size_t k = 0; k < count; ++k) {
            const std::int32_t triangle = outdated_[first + k];
            is_outdated_[triangle] = 0;
            is_missed_[triangle] = worst[k] ? 1 : 0;
            if (worst[k])
                missed_[triangle] = *worst[k];
            else
                missed_.erase(triangle);
        }
    }
    outdated_.clear();
}

std::vector<MissedPlace> CoveringPieces::missed()
{
    update();
    std::vector<MissedPlace> places;
    places.reserve(missed_.size());
    for (const auto& [triangle, place] : missed_)
        places.push_back(place);
    return places;
}

std::size_t CoveringPieces::add(LaidPass piece)
{
    const std::vector<PassContact>& contacts = piece.contacts;
    MoveNumbers moves = moves_along(contacts);
    if (contacts.size() == 1)
        moves.push_back(move_between(contacts[0], contacts[0]));
    piece.is_closed = piece.is_closed && contacts.size() > 2;
    if (piece.is_closed)
        moves.push_back(move_between(contacts.back(), contacts.front()));
    for (const std::int32_t move : moves)
        enter(move);
    outdate(moves, false);
    pieces_.push_back(std::move(piece));
    moves_of_pieces_.push_back(std::move(moves));
    return pieces_.size() - 1;
}

void CoveringPieces::remove(std::size_t number)
{
    for (const std::int32_t move : moves_of_pieces_[number])
        leave(move);
    outdate(moves_of_pieces_[number], true);
    release(moves_of_pieces_[number]);
    moves_of_pieces_[number].clear();
    pieces_[number] = {};
}

// Whether the triangles around moves that have been taken away are covered, or have not been
// covered before.
bool CoveringPieces::remains_covered(std::span<const std::int32_t> without)
{
    ++change_;
    const auto for_triangles = [&](std::int32_t i, const auto& is_good) {
        const auto triangles = samples_.triangles_at(i);
        return std::all_of(triangles.begin(), triangles.end(), is_good);
    };
    const auto is_missed = [&](std::int32_t triangle) {
        return is_missed_[triangle] != 0;
    };
    for (const std::int32_t move : without)
        for (const std::int32_t i : moves_[move].covered)
            if (moves_at_[i].empty() && samples_.is_wanted(i) &&
                !for_triangles(i, is_missed))
                return false;
    TriangleTest test{*this};
    const auto is_good = [&](std::int32_t triangle) {
        return std::exchange(tested_[triangle], change_) == change_ ||
               is_missed(triangle) || test.is_covered(triangle);
    };
    for (const std::int32_t move : without)
        for (const auto* around : {&moves_[move].covered, &moves_[move].around})
            for (const std::int32_t i : *around)
                if (!for_triangles(i, is_good))
                    return false;
    return true;
}

void CoveringPieces::swap_moves(std::span<const std::int32_t> removed,
                                std::span<const std::int32_t> added)
{
    for (const std::int32_t move : removed)
        leave(move);
    for (const std::int32_t move : added)
        enter(move);
}

// Removes moves and adds others, if everything remains covered.
bool CoveringPieces::exchange(std::span<const std::int32_t> removed,
                              std::span<const std::int32_t> added)
{
    swap_moves(removed, added);
    if (!remains_covered(removed)) {
        swap_moves(added, removed);
        release(added);
        return false;
    }
    outdate(added, false);
    release(removed);
    return true;
}

bool CoveringPieces::leave_out(std::size_t number)
{
    update();
    if (!exchange(moves_of_pieces_[number], {}))
        return false;
    moves_of_pieces_[number].clear();
    pieces_[number] = {};
    return true;
}

CoveringPieces::MoveExchange CoveringPieces::exchange_for(const PieceChange& change)
{
    const LaidPass& piece = pieces_[change.piece];
    const MoveNumbers& moves = moves_of_pieces_[change.piece];
    const std::vector<PassContact>& contacts = piece.contacts;
    const std::size_t count = contacts.size();
    const auto& [number, first, last, by, without] = change;
    const std::size_t new_count = first + by.size() + (count - last);
    require(first <= last && last <= count && new_count > 0 &&
                (!piece.is_closed || (first > 0 && new_count > 2)),
            "CoveringPieces: a change within the piece");
    std::vector<PassContact> window;
    window.reserve(by.size() + 2);
    if (first > 0)
        window.push_back(contacts[first - 1]);
    window.insert(window.end(), by.begin(), by.end());
    if (last < count || piece.is_closed)
        window.push_back(contacts[last % count]);
    MoveExchange exchanged{
        {}, moves_along(window), first > 0 ? first - 1 : 0, std::min(last, moves.size())};
    if (new_count == 1)
        exchanged.added.push_back(move_between(window[0], window[0]));
    exchanged.removed.assign(moves.begin() + static_cast<std::ptrdiff_t>(exchanged.first),
                             moves.begin() + static_cast<std::ptrdiff_t>(exchanged.last));
    if (without)
        exchanged.removed.insert(exchanged.removed.end(),
                                 moves_of_pieces_[*without].begin(),
                                 moves_of_pieces_[*without].end());
    return exchanged;
}

bool CoveringPieces::would_cover(const PieceChange& change)
{
    update();
    const MoveExchange moves = exchange_for(change);
    swap_moves(moves.removed, moves.added);
    const bool covers = remains_covered(moves.removed);
    swap_moves(moves.added, moves.removed);
    release(moves.added);
    return covers;
}

bool CoveringPieces::make(const PieceChange& change)
{
    update();
    const MoveExchange exchanged = exchange_for(change);
    if (!exchange(exchanged.removed, exchanged.added))
        return false;
    std::vector<PassContact>& contacts = pieces_[change.piece].contacts;
    MoveNumbers& moves = moves_of_pieces_[change.piece];
    const auto replace_in = [](auto& list, std::size_t from, std::size_t to,
                               const auto& with) {
        const auto at = list.erase(list.begin() + static_cast<std::ptrdiff_t>(from),
                                   list.begin() + static_cast<std::ptrdiff_t>(to));
        list.insert(at, with.begin(), with.end());
    };
    replace_in(contacts, change.first, change.last, change.by);
    replace_in(moves, exchanged.first, exchanged.last, exchanged.added);
    if (change.without) {
        moves_of_pieces_[*change.without].clear();
        pieces_[*change.without] = {};
    }
    return true;
}

void CoveringPieces::reverse(std::size_t number)
{
    LaidPass& piece = pieces_[number];
    MoveNumbers& moves = moves_of_pieces_[number];
    std::reverse(piece.contacts.begin(), piece.contacts.end());
    // the move that closes a piece remains the last one
    std::reverse(moves.begin(), moves.end() - (piece.is_closed ? 1 : 0));
}

void CoveringPieces::open(std::size_t number, std::size_t start)
{
    LaidPass& piece = pieces_[number];
    MoveNumbers& moves = moves_of_pieces_[number];
    const auto shift = static_cast<std::ptrdiff_t>(start);
    std::rotate(piece.contacts.begin(), piece.contacts.begin() + shift,
                piece.contacts.end());
    std::rotate(moves.begin(), moves.begin() + shift, moves.end());
    piece.contacts.push_back(piece.contacts.front());
    piece.is_closed = false;
}

void CoveringPieces::append(std::size_t number, std::span<const PassContact> way,
                            std::size_t next)
{
    LaidPass& piece = pieces_[number];
    LaidPass& other = pieces_[next];
    std::vector<PassContact> link{piece.contacts.back()};
    link.insert(link.end(), way.begin(), way.end());
    const bool is_joined =
        way.empty() && is_same_place(piece.contacts.back(), other.contacts.front());
    if (!is_joined)
        link.push_back(other.contacts.front());
    const MoveNumbers link_moves = moves_along(link);
    for (const std::int32_t move : link_moves)
        enter(move);
    outdate(link_moves, false);
    // a piece of one contact has a move of length 0, which covers no more than the others
    for (const std::size_t one : {number, next})
        if (pieces_[one].contacts.size() == 1) {
            for (const std::int32_t move : moves_of_pieces_[one])
                leave(move);
            release(moves_of_pieces_[one]);
            moves_of_pieces_[one].clear();
        }
    MoveNumbers& moves = moves_of_pieces_[number];
    moves.insert(moves.end(), link_moves.begin(), link_moves.end());
    const MoveNumbers next_moves = std::exchange(moves_of_pieces_[next], {});
    moves.insert(moves.end(), next_moves.begin(), next_moves.end());
    piece.contacts.insert(piece.contacts.end(), way.begin(), way.end());
    piece.contacts.insert(piece.contacts.end(),
                          other.contacts.begin() + (is_joined ? 1 : 0),
                          other.contacts.end());
    other = {};
}

}  // namespace endmill
