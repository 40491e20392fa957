// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/winding_faces.h"

#include <algorithm>

namespace endmill {
namespace {

// The steps sorted by the face that they leave, with the first step of each face.
class StepTable {
public:
    StepTable(std::span<const FaceStep> steps, std::int32_t count)
        : steps_{steps.begin(), steps.end()},
          first_(static_cast<std::size_t>(count) + 1, 0)
    {
        std::ranges::stable_sort(steps_, {}, &FaceStep::from);
        for (const FaceStep& step : steps_)
            ++first_[step.from + 1];
        for (std::size_t k = 1; k < first_.size(); ++k)
            first_[k] += first_[k - 1];
    }

    // Visits the faces that are reached from `start` by steps for which `enter(step)` is
    // true.
    template <typename Enter>
    void walk(std::int32_t start, const Enter& enter) const
    {
        std::vector<std::int32_t> open{start};
        while (!open.empty()) {
            const std::int32_t face = open.back();
            open.pop_back();
            for (std::size_t k = first_[face]; k < first_[face + 1]; ++k)
                if (enter(steps_[k]))
                    open.push_back(steps_[k].to);
        }
    }

private:
    std::vector<FaceStep> steps_;
    std::vector<std::size_t> first_;
};

}  // namespace

std::vector<bool> kept_faces(std::span<const FaceStep> steps, const FaceRule& rule)
{
    const StepTable table{steps, rule.count};
    std::vector<bool> is_counted(rule.count, false);
    std::vector<std::int32_t> index(rule.count, 0);
    is_counted[rule.outer] = true;
    index[rule.outer] = rule.index_outside;
    table.walk(rule.outer, [&](const FaceStep& step) {
        if (is_counted[step.to])
            return false;
        is_counted[step.to] = true;
        index[step.to] = index[step.from] - step.fall;
        return true;
    });
    std::vector<bool> is_kept(rule.count, false);
    if (!rule.must_be_joined_to_outer) {
        for (std::int32_t face = 0; face < rule.count; ++face)
            is_kept[face] = index[face] >= 0;
        return is_kept;
    }
    is_kept[rule.outer] = true;
    table.walk(rule.outer, [&](const FaceStep& step) {
        if (is_kept[step.to] || index[step.to] < 0)
            return false;
        is_kept[step.to] = true;
        return true;
    });
    return is_kept;
}

}  // namespace endmill
