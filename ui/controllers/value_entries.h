// "static friction 0.3" in the command palette: the numbers of the parameter table, set by words.
#pragma once

#include <vector>

#include <QString>

#include "ui/widgets/command_palette.h"

namespace tactum {

class Document;

/// What a line sets that ends in a number: each value of a material whose label has words that begin as the
/// typed ones do, for all selected surfaces that are not locked, and the radius of the proxy. The number may
/// have any unit of its kind. What cannot be set says why: no surface, out of its range, another kind of
/// unit. Nothing for other lines. The document outlives the entries. Thread: ui.
std::vector<PaletteEntry> valueEntries(Document& document, const QString& typed);

} // namespace tactum
