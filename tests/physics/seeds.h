// How many random runs a test makes: TACTUM_SEEDS, or an ordinary number.
#pragma once

#include <QtGlobal>

namespace tactum::test {

/// None if TACTUM_SEEDS is set to anything but a whole number from 1 on: a run that proves nothing must fail.
inline int seeds(int ordinary) {
    if (!qEnvironmentVariableIsSet("TACTUM_SEEDS")) return ordinary;
    bool isNumber = false;
    const int wanted = qEnvironmentVariableIntValue("TACTUM_SEEDS", &isNumber);
    return isNumber && wanted > 0 ? wanted : 0;
}

inline constexpr const char* kNoSeeds = "TACTUM_SEEDS must be a whole number from 1 on";

} // namespace tactum::test
