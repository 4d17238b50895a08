// How often a test tries what it tries at random.
#pragma once

#include <QtGlobal>

namespace tactum::test {

/// The number in a variable of the environment, or an ordinary one. Anything but a whole number from 1 on
/// ends the program: a run that tries nothing must not pass.
inline int repeats(const char* variable, int ordinary) {
    if (!qEnvironmentVariableIsSet(variable)) return ordinary;
    bool isNumber = false;
    const int wanted = qEnvironmentVariableIntValue(variable, &isNumber);
    if (!isNumber || wanted < 1) qFatal("%s must be a whole number from 1 on", variable);
    return wanted;
}

/// Is it `./check --all` or `./check ROOM`?
inline bool isLong() {
    return qEnvironmentVariableIsSet("TACTUM_ALL");
}

/// As many as `./check --all` and `./check ROOM` try, of which the short `./check` tries a tenth.
inline int longOnly(int all) {
    return isLong() ? all : all / 10;
}

} // namespace tactum::test
