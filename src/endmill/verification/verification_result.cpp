// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/verification_result.h"

#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

// Whether a gouge of an earlier run beyond the tolerance is possible.
bool may_be_gouged_before(const PartFindings& found)
{
    return found.earlier_gouge &&
           found.earlier_gouge->found_mm + found.earlier_gouge->bound_mm >
               found.limits.tolerance + verdict_slack;
}

}  // namespace

bool may_be_in_part(const PartCollisions& found)
{
    return found.bound_mm > closed_contact_bound;
}

Verdict verdict_with_contacts(const Verification& found)
{
    const auto& on_part = found.on_part;
    if (found.contacts.rapid_cuts.count > 0 || found.contacts.collisions.count > 0 ||
        (on_part && on_part->collisions.moves.count > 0))
        return on_part ? Verdict::Gouged : Verdict::Collides;
    const bool may_touch_stock = found.contacts.possible_mm > ignored_contact;
    if (!on_part)
        return may_touch_stock ? Verdict::Undecided : Verdict::NotJudged;
    const Verdict of_rest = verdict(on_part->deviation, on_part->limits);
    const bool is_open = may_touch_stock || may_be_in_part(on_part->collisions) ||
                         may_be_gouged_before(*on_part);
    return is_open && of_rest != Verdict::Gouged ? Verdict::Undecided : of_rest;
}

}  // namespace endmill
