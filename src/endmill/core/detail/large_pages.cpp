// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/large_pages.h"

#include <memory>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace endmill {

void prefer_large_pages(void* begin, std::size_t bytes)
{
#ifdef MADV_HUGEPAGE
    constexpr std::size_t large_page = 2 * 1024 * 1024;  // bytes; also its alignment
    if (std::align(large_page, large_page, begin, bytes) != nullptr)
        madvise(begin, bytes / large_page * large_page, MADV_HUGEPAGE);
#else
    static_cast<void>(begin);
    static_cast<void>(bytes);
#endif
}

}  // namespace endmill
