// What judges the processor itself, and not the program.
#pragma once

#include <QtGlobal>

namespace tactum::test {

/// Whether other programs may run beside the test: then it does not judge how soon something came. ctest says
/// so to all tests but to those of the label "quiet", which it runs alone; whoever starts a test by hand is
/// asked to let it have the machine.
inline bool mayBeBusy() {
    return qEnvironmentVariableIsSet("TACTUM_BUSY");
}

} // namespace tactum::test

/// At the beginning of a test function that means nothing on a busy machine.
#define TACTUM_NEEDS_QUIET()                                                                                 \
    do {                                                                                                     \
        if (tactum::test::mayBeBusy()) QSKIP("it judges the processor: ctest -L quiet");                     \
    } while (false)
