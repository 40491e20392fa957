// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/guide_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

// The steps of guide_field:
// 1. The shape operator of each triangle, from the normals of its corners.
// 2. The direction of the widest strip, as a tensor n n^T so that n and -n are one line;
//    the tensors are smoothed by one sparse solve.
// 3. The lines become vectors: each triangle takes the sign of a neighbour, the most
//    certain lines first.
// 4. A Poisson equation gives f. Its factors are used again for each round.

namespace endmill {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::SimplicialLDLT<Matrix>;
using Tensor = Eigen::Matrix3d;

// Distance over which lines are smoothed where they are uncertain, in widths of strips.
constexpr double smoothing_widths = 3;
// Rounds in which the width is taken across the gradient of the round before.
constexpr int width_rounds = 4;
// 1 + R k is at least this: tighter concavities do not admit the ball.
constexpr double least_opening = 0.02;
// Weight by which values are held, as a share of the stiffness, so that the solution is
// unique.
constexpr double holding_share = 1e-9;

// Samples that differ by less are at one place, as a share of their spacing, and a triangle
// with less area, as a share of its square, has none. It exceeds rounding errors.
constexpr double same_place_share = 1e-9;
// Stiffness of the edges of triangles without area, against 1 of others. They give a value to
// places that have no other triangle.
constexpr double edge_stiffness = 1e-3;

// A triangle of the net with what the field needs of it.
struct Element {
    std::array<std::int32_t, 3> corners;  // numbers of places
    std::array<Vec3, 3> gradients;  // of the linear functions that are 1 at a corner
    double area;                    // mm^2
    Vec3 normal;                    // unit
    Tensor shape;                   // dn / dx on the triangle's plane, 1/mm
};

// The width of a strip for a direction across the feed, as a multiple of its width on a
// plane.
double strip_share(const Element& element, const Vec3& across, double radius,
                   TravelKind distance)
{
    const Tensor opening = Tensor::Identity() + radius * element.shape;
    const Vec3 feed = element.normal.cross(across);
    // half axes a_i^2 are 2 h R / (1 + R k_i): the inverse of `opening`
    Eigen::SelfAdjointEigenSolver<Tensor> axes;
    axes.computeDirect(opening);
    double square = 0;
    for (int k = 0; k < 3; ++k) {
        const double part = axes.eigenvectors().col(k).dot(across);
        square += part * part / std::max(axes.eigenvalues()[k], least_opening);
    }
    const double width = std::sqrt(square);
    return distance == TravelKind::Contact
               ? width
               : width / std::max((opening * feed).norm(), least_opening);
}

// The lowest of the samples at the place of each sample: of twins, and of the samples that
// triangles without area join at an edge of a mesh.
std::vector<std::int32_t> first_at_places(const PartSamples& samples)
{
    const double same = same_place_share * samples.spacing();
    std::vector<std::int32_t> first(samples.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        first[i] = samples.representative(i);
    const auto root = [&](std::int32_t i) {
        while (first[i] != i)
            i = first[i] = first[first[i]];
        return i;
    };
    for (const Triangle& triangle : samples.triangles())
        for (int k = 0; k < 3; ++k) {
            const std::int32_t a = triangle[k];
            const std::int32_t b = triangle[(k + 1) % 3];
            if ((samples.point(a) - samples.point(b)).norm() > same)
                continue;
            const std::int32_t one = root(a);
            const std::int32_t other = root(b);
            first[std::max(one, other)] = std::min(one, other);
        }
    for (std::size_t i = 0; i < first.size(); ++i)
        first[i] = root(static_cast<std::int32_t>(i));
    return first;
}

// The finite elements of the net. Samples at one place share a number.
class FieldElements {
public:
    explicit FieldElements(const PartSamples& samples) : place_of_(samples.size())
    {
        const std::vector<std::int32_t> first = first_at_places(samples);
        std::int32_t count = 0;
        for (std::size_t i = 0; i < samples.size(); ++i)
            place_of_[i] =
                first[i] == static_cast<std::int32_t>(i) ? count++ : place_of_[first[i]];
        places_ = count;
        find_normals(samples);
        for (const Triangle& triangle : samples.triangles())
            add(samples, triangle);
    }

    const std::vector<Element>& elements() const { return elements_; }
    std::int32_t places() const { return places_; }
    std::int32_t place_of(std::size_t sample) const { return place_of_[sample]; }

    Matrix stiffness() const
    {
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(9 * elements_.size() + 4 * edges_.size());
        for (const auto& [a, b, value] : edges_) {
            entries.emplace_back(a, a, value);
            entries.emplace_back(b, b, value);
            entries.emplace_back(a, b, -value);
            entries.emplace_back(b, a, -value);
        }
        for (const Element& element : elements_)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    entries.emplace_back(
                        element.corners[i], element.corners[j],
                        element.area * element.gradients[i].dot(element.gradients[j]));
        return assembled(entries);
    }

    // A diagonal matrix with a third of the area of each triangle, times its weight, at its
    // corners.
    template <typename Weight>
    Matrix masses(Weight&& weight) const
    {
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t k = 0; k < elements_.size(); ++k)
            for (const std::int32_t corner : elements_[k].corners)
                entries.emplace_back(corner, corner, elements_[k].area / 3 * weight(k));
        return assembled(entries);
    }

private:
    struct StiffEdge {
        std::int32_t a;
        std::int32_t b;
        double stiffness;
    };

    Matrix assembled(const std::vector<Eigen::Triplet<double>>& entries) const
    {
        Matrix matrix(places_, places_);
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }

    // The mean normal of each place, so that blunt edges count as curvature; at a sharp edge
    // the normal of each sample.
    void find_normals(const PartSamples& samples)
    {
        std::vector<Vec3> means(places_, Vec3::Zero());
        for (std::size_t i = 0; i < samples.size(); ++i)
            means[place_of_[i]] += samples.normal(i);
        normals_.reserve(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const Vec3 mean = means[place_of_[i]].normalized();
            const bool is_blunt = mean.dot(samples.normal(i)) > std::cos(crease_angle);
            normals_.push_back(is_blunt ? mean : samples.normal(i));
        }
    }

    void add_edges(const PartSamples& samples, const Triangle& triangle)
    {
        for (int k = 0; k < 3; ++k) {
            const std::int32_t a = triangle[k];
            const std::int32_t b = triangle[(k + 1) % 3];
            const double length = (samples.point(a) - samples.point(b)).norm();
            if (place_of_[a] != place_of_[b])
                edges_.push_back({place_of_[a], place_of_[b],
                                  edge_stiffness * samples.spacing() / length});
        }
    }

    void add(const PartSamples& samples, const Triangle& triangle)
    {
        const auto point = [&](int k) -> const Vec3& {
            return samples.point(triangle[k % 3]);
        };
        const Vec3 twice = (point(1) - point(0)).cross(point(2) - point(0));
        const double length = twice.norm();
        if (!(length > same_place_share * samples.spacing() * samples.spacing())) {
            add_edges(samples, triangle);
            return;
        }
        Element element{{}, {}, length / 2, twice / length, Tensor::Zero()};
        Vec3 mean = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            element.corners[k] = place_of_[triangle[k]];
            element.gradients[k] =
                element.normal.cross(point(k + 2) - point(k + 1)) / length;
            element.shape += normals_[triangle[k]] * element.gradients[k].transpose();
            mean += normals_[triangle[k]];
        }
        if (element.normal.dot(mean) < 0)
            element.normal = -element.normal;
        const Tensor onto =
            Tensor::Identity() - element.normal * element.normal.transpose();
        const Tensor tangential = onto * element.shape * onto;
        element.shape = (tangential + tangential.transpose()) / 2;
        elements_.push_back(element);
    }

    std::vector<std::int32_t> place_of_;
    std::int32_t places_;
    std::vector<Vec3> normals_;  // of the samples
    std::vector<Element> elements_;
    std::vector<StiffEdge> edges_;  // of triangles without area
};

// The direction across the feed of the widest strip, and how much wider it is than the
// narrowest one.
struct WidestStrip {
    Vec3 across;
    double certainty;
};

WidestStrip widest_strip(const Element& element, double radius, TravelKind distance)
{
    Eigen::SelfAdjointEigenSolver<Tensor> axes;
    axes.computeDirect(element.shape);
    // the axis nearest to the normal is not a direction on the part
    int normal_axis = 0;
    (axes.eigenvectors().transpose() * element.normal).cwiseAbs().maxCoeff(&normal_axis);
    const auto direction = [&](int k) -> Vec3 {
        const Vec3 axis = axes.eigenvectors().col((normal_axis + k) % 3);
        return (axis - element.normal.dot(axis) * element.normal).normalized();
    };
    const Vec3 first = direction(1);
    const Vec3 second = element.normal.cross(first);
    const double width_first = strip_share(element, first, radius, distance);
    const double width_second = strip_share(element, second, radius, distance);
    const bool is_first = width_first >= width_second;
    const double ratio =
        is_first ? width_first / width_second : width_second / width_first;
    return {is_first ? first : second, ratio - 1};
}

// The lines of the widest strips, smoothed, one for each triangle.
std::vector<WidestStrip> smooth_lines(const FieldElements& net, const Matrix& stiffness,
                                      double radius, TravelKind distance, double width)
{
    const std::vector<Element>& elements = net.elements();
    std::vector<WidestStrip> lines;
    lines.reserve(elements.size());
    double mean = 0;
    double area = 0;
    for (const Element& element : elements) {
        lines.push_back(widest_strip(element, radius, distance));
        mean += element.area * lines.back().certainty;
        area += element.area;
    }
    mean = std::max(mean / area, holding_share);
    Eigen::MatrixXd known = Eigen::MatrixXd::Zero(net.places(), 6);
    constexpr std::array<std::pair<int, int>, 6> parts{
        {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
    for (std::size_t k = 0; k < elements.size(); ++k) {
        const auto& [across, certainty] = lines[k];
        for (const std::int32_t corner : elements[k].corners)
            for (int part = 0; part < 6; ++part)
                known(corner, part) += elements[k].area / 3 * certainty / mean *
                                       across[parts[part].first] *
                                       across[parts[part].second];
    }
    const double length = smoothing_widths * width;
    const Matrix weights = net.masses(
        [&](std::size_t k) { return lines[k].certainty / mean + holding_share; });
    const Solver solver{Matrix{weights + length * length * stiffness}};
    const Eigen::MatrixXd smooth = solver.solve(known);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        Tensor tensor = Tensor::Zero();
        for (const std::int32_t corner : elements[k].corners)
            for (int part = 0; part < 6; ++part) {
                const auto [i, j] = parts[part];
                tensor(i, j) += smooth(corner, part);
                if (i != j)
                    tensor(j, i) += smooth(corner, part);
            }
        const Tensor onto =
            Tensor::Identity() - elements[k].normal * elements[k].normal.transpose();
        Eigen::SelfAdjointEigenSolver<Tensor> axes;
        axes.computeDirect(onto * tensor * onto);
        const Vec3 across = onto * axes.eigenvectors().col(2);
        if (across.norm() > 0.5)
            lines[k].across = across.normalized();
    }
    return lines;
}

// The numbers of the elements at each place.
std::vector<std::vector<std::int32_t>> elements_at_places(const FieldElements& net)
{
    std::vector<std::vector<std::int32_t>> at_places(net.places());
    for (std::size_t k = 0; k < net.elements().size(); ++k)
        for (const std::int32_t corner : net.elements()[k].corners)
            at_places[corner].push_back(static_cast<std::int32_t>(k));
    return at_places;
}

// Gives neighbouring lines the same sense. The most certain lines decide first.
void orient(std::vector<WidestStrip>& lines, const FieldElements& net)
{
    const std::vector<std::vector<std::int32_t>> at_places = elements_at_places(net);
    std::vector<bool> is_known(lines.size(), false);
    std::priority_queue<std::pair<double, std::int32_t>> queue;
    const auto know = [&](std::int32_t k) {
        is_known[k] = true;
        queue.emplace(lines[k].certainty, k);
    };
    const auto follow = [&](std::int32_t k, std::int32_t leader) {
        if (is_known[k])
            return;
        if (lines[k].across.dot(lines[leader].across) < 0)
            lines[k].across = -lines[k].across;
        know(k);
    };
    for (std::size_t start = 0; start < lines.size(); ++start) {
        if (is_known[start])
            continue;
        know(static_cast<std::int32_t>(start));
        while (!queue.empty()) {
            const std::int32_t leader = queue.top().second;
            queue.pop();
            for (const std::int32_t corner : net.elements()[leader].corners)
                for (const std::int32_t k : at_places[corner])
                    follow(k, leader);
        }
    }
}

}  // namespace

std::vector<double> guide_field(const PartSamples& samples, const BallCutter& cutter,
                                double height, TravelKind distance)
{
    const double radius = cutter.radius();
    const double width = 2 * std::sqrt(height * (2 * radius - height));
    const FieldElements net{samples};
    const std::vector<Element>& elements = net.elements();
    const Matrix stiffness = net.stiffness();
    std::vector<WidestStrip> lines =
        smooth_lines(net, stiffness, radius, distance, width);
    orient(lines, net);
    const Matrix held =
        net.masses([&](std::size_t) { return holding_share / (width * width); });
    const Solver solver{Matrix{stiffness + held}};
    Eigen::VectorXd values = Eigen::VectorXd::Zero(net.places());
    for (int round = 0; round <= width_rounds; ++round) {
        Eigen::VectorXd sources = Eigen::VectorXd::Zero(net.places());
        for (std::size_t k = 0; k < elements.size(); ++k) {
            const Element& element = elements[k];
            Vec3 gradient = Vec3::Zero();
            for (int i = 0; i < 3; ++i)
                gradient += values[element.corners[i]] * element.gradients[i];
            if (round > 0 && gradient.norm() > 0)
                lines[k].across = gradient.normalized();
            const Vec3 wanted =
                lines[k].across / strip_share(element, lines[k].across, radius, distance);
            for (int i = 0; i < 3; ++i)
                sources[element.corners[i]] +=
                    element.area * element.gradients[i].dot(wanted);
        }
        values = solver.solve(sources);
    }
    std::vector<double> result(samples.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = values[net.place_of(i)];
    return result;
}

}  // namespace endmill
