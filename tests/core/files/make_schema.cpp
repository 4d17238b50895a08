// make-schema FILE: writes the JSON schema of the file format, which docs/schema holds.
#include <fstream>

#include "tests/core/files/format_schema.h"

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    std::ofstream out(argv[1]);
    out << tactum::formatSchema();
    out.close();
    return out ? 0 : 3;
}
