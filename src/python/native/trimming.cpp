// SPDX-License-Identifier: GPL-3.0-or-later
// endmill.trim_curves and endmill.compare_trimming.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "endmill/core/error.h"
#include "endmill/offset/section_curve.h"
#include "endmill/offset/slicer.h"
#include "endmill/trimming/trimmed_planes.h"
#include "endmill/trimming/trimming.h"
#include "endmill/trimming/trimming_methods.h"
#include "endmill/trimming/trimming_quality.h"
#include "module.h"

namespace endmill::python {
namespace {

// Share of the length in s that rounding may leave uncovered.
constexpr double rounding_of_length = 1e-12;

constexpr std::array<std::string_view, 4> kind_names{"vertex", "crossing", "link", "end"};

// A curve of an argument, as files give it too: a point that equals the one before is left out.
SectionCurve curve_of(const py::handle& values, const std::string& name)
{
    const DoubleArray array = rows(values, name, 2);
    const double* data = array.data();
    SectionCurve curve;
    for (py::ssize_t k = 0; k < array.shape(0); ++k) {
        const SectionPoint point{checked_length(data[2 * k], name.c_str()),
                                 checked_length(data[2 * k + 1], name.c_str())};
        if (curve.points.empty() || curve.points.back() != point)
            curve.points.push_back(point);
    }
    if (curve.points.size() < 2)
        throw DomainError{name + ": found " + std::to_string(curve.points.size()) +
                          " different points; expected two or more"};
    curve.is_closed = curve.points.front() == curve.points.back();
    return curve;
}

PlaneSection section_of(const py::handle& curves, const std::string& name)
{
    if (!py::isinstance<py::sequence>(curves) || py::isinstance<py::str>(curves))
        throw py::type_error(name +
                             ": expected a list of arrays (n, 2) of s and z in mm");
    PlaneSection section;
    std::size_t number = 0;
    for (const py::handle curve : py::reinterpret_borrow<py::sequence>(curves))
        section.curves.push_back(
            curve_of(curve, name + "[" + std::to_string(number++) + "]"));
    section.curves = arranged(std::move(section.curves));
    return section;
}

const TrimmingMethod& method_of(const std::string& name)
{
    std::string known;
    for (const TrimmingMethod& method : trimming_methods()) {
        if (method.name == name)
            return method;
        known += (known.empty() ? "" : ", ") + std::string{method.name};
    }
    throw DomainError{"method: found " + name + "; expected one of " + known};
}

TrimmingOptions options_for(std::span<const PlaneSection> sections,
                            const std::string& detection, std::optional<double> scan_step,
                            std::optional<double> scan_threshold)
{
    TrimmingOptions options = default_trimming_options(section_height(sections));
    if (detection != "guarded" && detection != "literal")
        throw DomainError{"detection: found " + detection +
                          "; expected guarded or literal"};
    options.detection =
        detection == "guarded" ? FoldDetection::Guarded : FoldDetection::Literal;
    options.scan_step = scan_step.value_or(options.scan_step);
    options.scan_threshold =
        scan_threshold.value_or(scan_threshold_in_steps * options.scan_step);
    return options;
}

py::list arrays_of(std::span<const SectionCurve> curves)
{
    py::list arrays;
    for (const SectionCurve& curve : curves)
        arrays.append(moved<double>(std::vector<SectionPoint>{curve.points},
                                    {static_cast<py::ssize_t>(curve.points.size()), 2}));
    return arrays;
}

py::list arrays_of(const Trimmed& trimmed)
{
    py::list arrays;
    for (const TrimmedCurve& curve : trimmed.curves) {
        std::vector<SectionPoint> points;
        points.reserve(curve.points.size());
        for (const TrimmedPoint& point : curve.points)
            points.push_back(point.at);
        const auto count = static_cast<py::ssize_t>(points.size());
        arrays.append(moved<double>(std::move(points), {count, 2}));
    }
    return arrays;
}

py::list kinds_of(const Trimmed& trimmed)
{
    py::list lists;
    for (const TrimmedCurve& curve : trimmed.curves) {
        py::list kinds;
        for (const TrimmedPoint& point : curve.points)
            kinds.append(kind_names.at(static_cast<std::size_t>(point.kind)));
        lists.append(std::move(kinds));
    }
    return lists;
}

py::list rules_of(const Trimmed& trimmed)
{
    py::list rules;
    for (const AppliedRule& rule : trimmed.rules)
        rules.append(
            py::make_tuple(rule.curve, rule.first_point, rule.last_point, rule.rule));
    return rules;
}

Trimmed trim(const py::object& curves, const std::string& method,
             const std::string& detection, std::optional<double> scan_step,
             std::optional<double> scan_threshold)
{
    const PlaneSection section = section_of(curves, "curves");
    const TrimmingMethod& known = method_of(method);
    const TrimmingOptions options =
        options_for({&section, 1}, detection, scan_step, scan_threshold);
    const py::gil_scoped_release release;
    return trim_planes({&section, 1}, {}, known, options).front();
}

// The result of a Python function that trims the curves of a plane.
Trimmed trimmed_by(const py::object& method, const PlaneSection& section)
{
    const py::object result = method(arrays_of(section.curves));
    Trimmed trimmed{};
    for (SectionCurve& curve : section_of(result, "result of the method").curves) {
        TrimmedCurve& kept = trimmed.curves.emplace_back();
        kept.is_closed = curve.is_closed;
        for (const SectionPoint& point : curve.points)
            kept.points.push_back({point, {0, 0}, {0, 0}, TrimmedKind::Vertex});
    }
    return trimmed;
}

// Wall times of a method, and its worst errors.
struct Comparison {
    std::vector<double> times_ms;
    std::size_t wrong = 0;
    TrimmingQuality worst = {};
};

Comparison compared(const py::object& method, std::span<const PlaneSection> sections,
                    const TrimmingOptions& options, int repeat, double tolerance)
{
    using Clock = std::chrono::steady_clock;
    Comparison found;
    std::vector<Trimmed> results;
    for (int k = 0; k < repeat; ++k) {
        const auto start = Clock::now();
        if (py::isinstance<py::str>(method)) {
            const TrimmingMethod& known = method_of(py::str(method));
            const py::gil_scoped_release release;
            results = trim_planes(sections, {}, known, options);
        } else {
            results.clear();
            for (const PlaneSection& section : sections)
                results.push_back(trimmed_by(method, section));
        }
        found.times_ms.push_back(
            std::chrono::duration<double, std::milli>(Clock::now() - start).count());
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
    }
    const py::gil_scoped_release release;
    TrimmingTolerance accepted;
    accepted.step_back_mm = step_back_on_parts_mm;
    accepted.gouge_mm = tolerance;
    accepted.uncovered = rounding_of_length;
    for (std::size_t k = 0; k < sections.size(); ++k) {
        const TrimmingQuality quality = trimming_quality(sections[k].curves, results[k]);
        found.wrong += is_right(quality, accepted) ? 0 : 1;
        found.worst.step_back_mm =
            std::max(found.worst.step_back_mm, quality.step_back_mm);
        found.worst.gouge_mm = std::max(found.worst.gouge_mm, quality.gouge_mm);
        found.worst.uncovered = std::max(found.worst.uncovered, quality.uncovered);
    }
    return found;
}

py::list compare(const py::object& planes, const py::object& methods, int repeat,
                 double tolerance, const std::string& detection)
{
    if (repeat < 1)
        throw DomainError{"repeat: expected a whole number from 1"};
    if (!(tolerance >= 0))
        throw DomainError{"tolerance: expected a number from 0, in mm"};
    std::vector<PlaneSection> sections;
    for (const py::handle curves : planes.cast<py::sequence>())
        sections.push_back(
            section_of(curves, "planes[" + std::to_string(sections.size()) + "]"));
    const TrimmingOptions options = options_for(sections, detection, {}, {});
    const auto chosen = methods.cast<std::vector<py::object>>();
    for (const py::object& method : chosen) {
        if (py::isinstance<py::str>(method))
            method_of(py::str(method));  // refuses an unknown one before any work
        else if (PyCallable_Check(method.ptr()) == 0)
            throw py::type_error("methods: expected names of methods and functions");
    }
    py::list rows;
    for (const py::object& method : chosen) {
        const Comparison found = compared(method, sections, options, repeat, tolerance);
        py::dict row;
        row["method"] = py::isinstance<py::str>(method)
                            ? method
                            : py::getattr(method, "__name__", py::str(method));
        row["planes"] = sections.size();
        row["wrong"] = found.wrong;
        row["max_gouge_mm"] = found.worst.gouge_mm;
        row["max_step_back_mm"] = found.worst.step_back_mm;
        row["max_uncovered"] = found.worst.uncovered;
        row["times_ms"] = found.times_ms;
        rows.append(std::move(row));
    }
    return rows;
}

}  // namespace

void add_trimming(py::module_& module)
{
    py::class_<Trimmed>(module, "Trimmed", only_constructed(false),
                        R"(The curves of a drive plane without their loops.)")
        .def_property_readonly(
            "curves", [](const Trimmed& trimmed) { return arrays_of(trimmed); },
            "List of arrays (n, 2) of s and z in mm.")
        .def_property_readonly("kinds", &kinds_of,
                               R"(The origin of each point, a list for each curve.

vertex: of the curve; crossing: of two segments; link: above or below a vertex; end.)")
        .def_property_readonly(
            "rules", &rules_of,
            "Tuples (curve, first point, last point, rule) of what was cut out.")
        .def_readonly("unresolved", &Trimmed::unresolved, "Number of folds that remain.")
        .def("__repr__", [](const Trimmed& trimmed) {
            return "<Trimmed: " + std::to_string(trimmed.curves.size()) + " curves, " +
                   std::to_string(trimmed.unresolved) + " unresolved folds>";
        });
    std::vector<std::string> names;
    for (const TrimmingMethod& method : trimming_methods())
        names.emplace_back(method.name);
    module.attr("trimming_methods") = py::cast(names);
    module.def("trim_curves", &trim, py::arg("curves"), py::arg("method") = "envelope",
               py::arg("detection") = "guarded", py::arg("scan_step") = py::none(),
               py::arg("scan_threshold") = py::none(),
               R"(Remove the loops from the curves of one drive plane.

curves: arrays (n, 2) of s along the feed and z in mm, of the cutter's reference point; a curve
is closed if its last point equals its first. method: one of trimming_methods. detection:
"guarded" or "literal" (as printed), for methods 1, 2 and 3. scan_step and scan_threshold: of
method 1, in mm; by default a thousandth of the extent in z, and four steps.
Returns a Trimmed. Raises DomainError for values out of range.
Source: Jang, Kim and Jeong.)");
    module.def("_compare_trimming", &compare, py::arg("planes"), py::arg("methods"),
               py::arg("repeat"), py::arg("tolerance"), py::arg("detection"));
}

}  // namespace endmill::python
