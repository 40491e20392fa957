// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/oriented_options.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(OrientedOptions, AreRefusedOutOfTheirDomain)
{
    const Cutter cutter{5, 1};
    EXPECT_NO_THROW(require_sound(OrientedOptions{}, cutter));
    const auto refused = [&](auto change) {
        OrientedOptions options;
        change(options);
        EXPECT_THROW(require_sound(options, cutter), DomainError);
    };
    refused([](OrientedOptions& options) { options.scallop_height = 0; });
    refused([](OrientedOptions& options) { options.scallop_height = 5; });
    refused([](OrientedOptions& options) { options.inner_tolerance = 0; });
    refused([](OrientedOptions& options) { options.inner_tolerance = 5; });
    refused([](OrientedOptions& options) {
        options.safe_height = std::numeric_limits<double>::quiet_NaN();
    });
}

}  // namespace
}  // namespace endmill
