#include "ui/base/hand_colours.h"

#include <array>

namespace tactum {

// Apart from each other, and from what contact, stick, slip and faults are drawn in.
HandColours handColours(const Theme& theme, std::size_t hand) {
    static const std::array<HandColours, 3> kOnDark{{{{0xff, 0x6f, 0xb8}, {0xff, 0xc2, 0xe0}},
                                                     {{0x2f, 0xb8, 0xc9}, {0xa6, 0xec, 0xf2}},
                                                     {{0xb5, 0x8a, 0x5a}, {0xe6, 0xd3, 0xb3}}}};
    static const std::array<HandColours, 3> kOnLight{{{{0xc2, 0x1d, 0x78}, {0xe8, 0x74, 0xb4}},
                                                      {{0x0a, 0x7a, 0x8a}, {0x3d, 0xb4, 0xc4}},
                                                      {{0x7a, 0x53, 0x24}, {0xb3, 0x8b, 0x57}}}};
    if (hand == 0) return {theme.finger, theme.proxy};
    return (theme.dark ? kOnDark : kOnLight)[(hand - 1) % kOnDark.size()];
}

} // namespace tactum
