// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/box_heights.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

std::vector<ProjectedBox> random_boxes(int count, double width)
{
    test::Random random{8};
    std::vector<ProjectedBox> boxes;
    for (int k = 0; k < count; ++k) {
        ProjectedBox& box = boxes.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
            const double low = random.uniform(-1, 1);
            box.low[axis] = static_cast<float>(low);
            box.high[axis] = static_cast<float>(low + random.uniform(0, width));
        }
    }
    return boxes;
}

bool overlap(const ProjectedBox& a, const ProjectedBox& b)
{
    return (a.low.head<2>().array() <= b.high.head<2>().array()).all() &&
           (b.low.head<2>().array() <= a.high.head<2>().array()).all();
}

// Boxes that overlap in x and y are always found; most of the others are not.
TEST(BoxHeights, FindEachBoxThatRisesAboveAnother)
{
    for (const double width : {1e-3, 0.02, 0.3, 2.0}) {
        const std::vector<ProjectedBox> boxes = random_boxes(400, width);
        BoxHeights heights;
        heights.reset(boxes);
        for (std::size_t k = 0; k < boxes.size(); k += 2)
            heights.add(boxes[k]);
        int needless = 0;
        for (const ProjectedBox& box : boxes) {
            bool expected = false;
            for (std::size_t k = 0; k < boxes.size(); k += 2)
                expected = expected ||
                           (overlap(box, boxes[k]) && boxes[k].high.z() >= box.low.z());
            if (expected) {
                EXPECT_FALSE(heights.are_clear_of(box));
            } else
                needless += !heights.are_clear_of(box);
        }
        if (width < 0.1) {
            EXPECT_LT(needless, 100);
        }
    }
}

TEST(BoxHeights, AreClearOfAllBoxesIfThereAreNone)
{
    const std::vector<ProjectedBox> boxes = random_boxes(100, 0.1);
    BoxHeights heights;
    heights.reset(boxes);
    for (const ProjectedBox& box : boxes)
        EXPECT_TRUE(heights.are_clear_of(box));
    heights.add(boxes[0]);
    heights.reset(boxes);
    EXPECT_TRUE(heights.are_clear_of(boxes[0]));
}

TEST(BoxHeights, TakeBoxesWithoutAnExtent)
{
    const ProjectedBox box{{0.5F, 0.5F, 0}, {0.5F, 0.5F, 1}};
    BoxHeights heights;
    heights.reset(std::vector{box, box});
    EXPECT_TRUE(heights.are_clear_of(box));
    heights.add(box);
    EXPECT_FALSE(heights.are_clear_of(box));
}

}  // namespace
}  // namespace endmill
