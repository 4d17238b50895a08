// The colours of each of several hands.
#pragma once

#include <cstddef>

#include "ui/base/theme.h"

namespace tactum {

struct HandColours {
    QColor finger, proxy; ///< the force has that of the proxy
};

/// The first has those of the theme. A name always goes with the colour.
HandColours handColours(const Theme& theme, std::size_t hand);

} // namespace tactum
