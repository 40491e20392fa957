// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace endmill {

/// Asks the system to back `bytes` bytes from `begin` on with large pages where it can. A page
/// that is written to for the first time costs about two microseconds, of 4 kB or of 2 MB:
/// for ten million bytes that are written once it is most of the time. Only a hint: no
/// value changes, and nothing is done where the system knows no such pages.
void prefer_large_pages(void* begin, std::size_t bytes);

/// Room for `count` items in `items`, in large pages if it is new: before they are filled in.
template <typename Item>
void reserve_in_large_pages(std::vector<Item>& items, std::size_t count)
{
    if (count <= items.capacity())
        return;
    items.reserve(count);
    prefer_large_pages(items.data(), items.capacity() * sizeof(Item));
}

}  // namespace endmill
