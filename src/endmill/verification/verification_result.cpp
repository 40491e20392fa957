// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/verification_result.h"

namespace endmill {

Verdict verdict_with_contacts(const Verification& found, const DeviationLimits& limits)
{
    const bool is_in_part =
        found.part_collisions && found.part_collisions->moves.count > 0;
    if (found.contacts.rapid_cuts.count > 0 || found.contacts.collisions.count > 0 ||
        is_in_part)
        return Verdict::Gouged;
    const Verdict of_rest =
        found.deviation ? verdict(*found.deviation, limits) : Verdict::Clean;
    const auto& earlier = found.earlier_gouge;
    const bool may_be_in_part =
        found.part_collisions && found.part_collisions->bound_mm > closed_contact_bound;
    const bool may_be_gouged = earlier && earlier->found_mm + earlier->bound_mm >
                                              limits.tolerance + verdict_slack;
    const bool is_open = may_be_in_part || may_be_gouged;
    return is_open && of_rest != Verdict::Gouged ? Verdict::Undecided : of_rest;
}

}  // namespace endmill
