// A long text that has to stay as it is: held against a file beside the test, so that nothing changes that
// nobody meant.
#pragma once

#include <QString>

#include "tests/support/compare.h"

/// COMPARE_SHOWN(text, name): the text is that of the file shown/NAME.txt beside the test. A failure prints
/// the first line that differs. Where TACTUM_WRITE_SHOWN is set, the file is written: read what has changed.
#define COMPARE_SHOWN(text, name) TACTUM_COMPARE_(isAsShown(text, name, {#text, name, __FILE__, __LINE__}))

namespace tactum::test {

bool isAsShown(const QString& text, const char* name, const Comparison& at);

} // namespace tactum::test
