#include "core/self_test/words.h"

namespace tactum {

std::string TrialWords::english() const {
    std::string text;
    for (std::size_t i = 0; i < form.size(); ++i) {
        const bool place = form[i] == '%' && i + 1 < form.size();
        const std::size_t part = place ? std::size_t(form[i + 1] - '1') : parts.size();
        if (part < parts.size())
            text += parts[part].english(), ++i;
        else
            text += form[i];
    }
    return text;
}

} // namespace tactum
