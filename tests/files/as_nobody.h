// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <stdexcept>

#include <unistd.h>

namespace endmill {

/// While it exists, root acts as another user, so that file permissions apply.
class AsNobody {
public:
    AsNobody() : was_root_{::geteuid() == 0}
    {
        constexpr uid_t nobody = 65534;
        if (was_root_ && ::seteuid(nobody) != 0)
            throw std::runtime_error{"cannot become another user"};
    }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;
    ~AsNobody()
    {
        if (was_root_ && ::seteuid(0) != 0)
            std::terminate();
    }

private:
    bool was_root_;
};

}  // namespace endmill
