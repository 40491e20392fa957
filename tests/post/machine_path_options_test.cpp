// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/machine_path_options.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(MachinePathOptions, AreSoundByDefault)
{
    EXPECT_NO_THROW(require_sound(MachinePathOptions{}));
    EXPECT_NO_THROW(require_sound(
        MachinePathOptions{.singular = SingularRule::Retract, .retract = 10}));
}

TEST(MachinePathOptions, AreRefusedOutOfTheirDomain)
{
    for (const MachinePathOptions& options :
         {MachinePathOptions{.frame = Interpolation::Linear},
          MachinePathOptions{.tolerance = 0}, MachinePathOptions{.tolerance = 1e-7},
          MachinePathOptions{.singular = SingularRule::Retract},
          MachinePathOptions{.singular_cone = Angle::degrees(-1)},
          MachinePathOptions{.singular_cone = Angle::degrees(10)},
          MachinePathOptions{.retract = 0}, MachinePathOptions{.rapid_feed = -5}})
        EXPECT_THROW(require_sound(options), DomainError);
}

}  // namespace
}  // namespace endmill
