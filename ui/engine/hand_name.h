// What a hand is called where there are several.
#pragma once

#include <QString>

namespace tactum {

class Hands;

/// The name of its device; of several devices of one name it has its number behind, from 1 on. `hand` below
/// hands.count(). Thread: ui.
QString handName(const Hands& hands, std::size_t hand);

} // namespace tactum
