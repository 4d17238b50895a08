// Prints what tables show, a text a line: see resources/translations/update.
#include <cstdio>

#include "tests/ui/window/table_texts.h"

int main() {
    for (const QString& text : tactum::tableTexts())
        std::printf("%s\n", qPrintable(text));
}
