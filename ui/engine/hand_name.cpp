#include "ui/engine/hand_name.h"

#include "core/runtime/hands.h"
#include "ui/base/words.h"

namespace tactum {

QString handName(const Hands& hands, std::size_t hand) {
    const std::string& name = hands.device(hand).name;
    for (std::size_t other = 0; other < hands.count(); ++other)
        if (other != hand && hands.device(other).name == name)
            return QStringLiteral("%1 %2").arg(wordsOf(name)).arg(hand + 1);
    return wordsOf(name);
}

} // namespace tactum
