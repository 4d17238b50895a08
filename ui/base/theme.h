// Every colour of the program, in one table for each theme. View, plots, panels and legends read it.
#pragma once

#include <QColor>

namespace tactum {

/// Greys for surroundings, one accent, and colours with a fixed meaning. The meaning is the same in both
/// themes, chosen to stay apart for colour-blind eyes; a shape or a word always goes with it.
struct Theme {
    bool dark;

    // Surroundings of the window.
    QColor window; ///< behind docks and bars
    QColor panel;  ///< inside docks
    QColor field;  ///< inside of editors and lists
    QColor border; ///< lines between things
    QColor text;
    QColor textDimmed; ///< units, hints, what is off
    QColor accent;     ///< the selected, the focused, the primary button
    QColor accentText; ///< on the accent

    // The 3-D view.
    QColor skyTop; ///< upper end of the background
    QColor skyBottom;
    QColor label; ///< behind the words in the view
    QColor labelText;

    // Meaning.
    QColor finger;
    QColor proxy;   ///< the force has this colour too
    QColor contact; ///< contact plane and its normal
    QColor stick;
    QColor slip;
    QColor fault;       ///< limits and faults
    QColor faultGround; ///< behind white words about one

    // Plots.
    QColor plotGrid;
    QColor axisX, axisY, axisZ; ///< the coordinate cross
};

inline const Theme kDarkTheme{
    .dark = true,
    .window = {0x1b, 0x1d, 0x21},
    .panel = {0x23, 0x26, 0x2b},
    .field = {0x2c, 0x30, 0x36},
    .border = {0x3a, 0x3f, 0x47},
    .text = {0xe4, 0xe6, 0xea},
    .textDimmed = {0x8f, 0x96, 0xa1},
    .accent = {0x2f, 0xb8, 0xc9},
    .accentText = {0x06, 0x20, 0x24},
    .skyTop = {0x4b, 0x52, 0x5d},
    .skyBottom = {0x1d, 0x20, 0x25},
    .label = {0x14, 0x16, 0x1a, 205},
    .labelText = {0xf1, 0xf3, 0xf5},
    .finger = {0x4f, 0x95, 0xff},
    .proxy = {0xff, 0x9a, 0x2e},
    .contact = {0x2f, 0xc9, 0x8c},
    .stick = {0xf4, 0xd8, 0x4a},
    .slip = {0xb9, 0x8c, 0xff},
    .fault = {0xf0, 0x4f, 0x4f},
    .faultGround = {0xbf, 0x2d, 0x2d},
    .plotGrid = {0x3a, 0x3f, 0x47},
    .axisX = {0xe0, 0x6c, 0x75},
    .axisY = {0x8c, 0xc2, 0x65},
    .axisZ = {0x61, 0x9c, 0xe8},
};

inline const Theme kLightTheme{
    .dark = false,
    .window = {0xec, 0xee, 0xf1},
    .panel = {0xf7, 0xf8, 0xfa},
    .field = {0xff, 0xff, 0xff},
    .border = {0xcf, 0xd4, 0xda},
    .text = {0x1e, 0x22, 0x28},
    .textDimmed = {0x6a, 0x72, 0x7d},
    .accent = {0x0a, 0x8a, 0x9c},
    .accentText = {0xff, 0xff, 0xff},
    .skyTop = {0xf6, 0xf8, 0xfa},
    .skyBottom = {0xc3, 0xca, 0xd3},
    .label = {0xff, 0xff, 0xff, 222},
    .labelText = {0x1e, 0x22, 0x28},
    .finger = {0x1f, 0x6f, 0xeb},
    .proxy = {0xe0, 0x7b, 0x0c},
    .contact = {0x0f, 0x9d, 0x66},
    .stick = {0xd6, 0xa9, 0x00},
    .slip = {0x83, 0x4d, 0xe0},
    .fault = {0xd0, 0x2c, 0x2c},
    .faultGround = {0xc4, 0x27, 0x27},
    .plotGrid = {0xd7, 0xdb, 0xe0},
    .axisX = {0xc8, 0x3a, 0x46},
    .axisY = {0x4d, 0x8a, 0x2a},
    .axisZ = {0x2b, 0x66, 0xc0},
};

inline const Theme& themeFor(bool dark) {
    return dark ? kDarkTheme : kLightTheme;
}

} // namespace tactum
