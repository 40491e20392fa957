// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace endmill {

/// Asks the system to use large pages of 2 MB for the `bytes` bytes from `begin` on.
///
/// The first write to a page costs about two microseconds, whether the page has 4 kB or 2
/// MB. For ten megabytes that are written once, small pages take most of the time. The
/// request is only a hint: it changes no value, and has no effect where the system has no
/// large pages.
void prefer_large_pages(void* begin, std::size_t bytes);

/// Reserves room for `count` items. Newly allocated room uses large pages, so the items
/// should be filled in afterwards.
template <typename Item>
void reserve_in_large_pages(std::vector<Item>& items, std::size_t count)
{
    if (count <= items.capacity())
        return;
    items.reserve(count);
    prefer_large_pages(items.data(), items.capacity() * sizeof(Item));
}

/// Makes `items` `count` copies of `item`. Newly allocated room uses large pages.
template <typename Item>
void assign_in_large_pages(std::vector<Item>& items, std::size_t count, const Item& item)
{
    reserve_in_large_pages(items, count);
    items.assign(count, item);
}

}  // namespace endmill
