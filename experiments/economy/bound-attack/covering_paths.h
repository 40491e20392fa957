// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/surface/surface.h"

// Random paths that cover a surface. They are laid, checked and measured without the modules
// `bound` and `strategy`.
namespace endmill {

/// How passes lie in the plane of lengths: the parameters, each multiplied by the length of
/// the surface along it.
enum class PathKind {
    Parallel,  ///< straight passes in a random direction
    Wavy,      ///< passes that follow a sine in a random direction
    Jittered,  ///< straight passes with random errors of their distances
    Zigzag,    ///< straight passes that are joined in contact to one piece
    Spiral,    ///< one spiral around a random place, cut at the borders
    Contour,   ///< rectangles from the border inwards
};

inline constexpr std::array every_path_kind{PathKind::Parallel, PathKind::Wavy,
                                            PathKind::Jittered, PathKind::Zigzag,
                                            PathKind::Spiral,   PathKind::Contour};

std::string_view path_kind_name(PathKind kind);

/// A place of the plane of lengths, mm.
using PlanePoint = Eigen::Vector2d;

/// A random path that covers the surface, as a polyline of contacts and of tips.
struct RandomCover {
    double contact_mm = 0;    ///< sum of the chords between contacts
    double tip_mm = 0;        ///< sum of the chords between tips
    std::int64_t pieces = 0;  ///< parts of passes, and plunges
    double pitch_mm = 0;      ///< the distance of passes in the plane of lengths
};

/// A surface with sampled raised points, which a path has to reach.
class CoverTask {
public:
    /// \param surface        seen from +z; every contact is one of the ball.
    /// \param ball           the tool, upright, with a flank above the ball.
    /// \param scallop_height that may be left, mm.
    CoverTask(const Surface& surface, const BallCutter& ball, double scallop_height);

    /// A random path of a kind. The distance of passes begins between 0.95 and 1.05 strips
    /// and falls until a few plunges reach the samples that passes do not. Their number
    /// has a random limit. Then ends of pieces that reach nothing alone are removed.
    /// A place between samples may be missed; such a path is only shorter.
    RandomCover random_cover(PathKind kind, std::mt19937_64& engine) const;

    double strip_mm() const { return strip_mm_; }  ///< that the ball covers on a plane

private:
    struct Contact {
        Vec3 point;
        Vec3 tip;
        std::vector<std::size_t> reached;  // samples
    };
    using Piece = std::vector<Contact>;

    PlanePoint place_of(std::size_t sample) const;
    Contact contact_at(const PlanePoint& place) const;
    std::vector<std::size_t> reached_from(const PlanePoint& place,
                                          const Vec3& centre) const;
    std::vector<Piece> pieces_on(const std::vector<std::vector<PlanePoint>>& lines) const;
    std::vector<int> times_reached(const std::vector<Piece>& pieces) const;
    bool reach_by_plunges(std::vector<Piece>& pieces, std::vector<int>& times,
                          std::int64_t most) const;
    static void without_needless_ends(std::vector<Piece>& pieces,
                                      std::vector<int>& times);

    Surface surface_;
    double side_;
    BallCutter ball_;
    double scallop_height_;
    double strip_mm_;
    PlanePoint size_;  // of the plane of lengths
    int columns_;      // of samples
    int rows_;
    std::vector<Vec3> raised_;  // row by row
};

}  // namespace endmill
