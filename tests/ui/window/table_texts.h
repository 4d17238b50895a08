// What the program's tables show to a person, in English: what no reader of sources finds for a translation.
#pragma once

#include <set>

#include <QString>

namespace tactum {

std::set<QString> tableTexts();

} // namespace tactum
