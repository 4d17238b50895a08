#include "tests/support/test_program.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

namespace tactum::test {
namespace {

std::vector<const TestEntry*>& entries() {
    static std::vector<const TestEntry*> all; // made by the first entry, whichever file that is in
    return all;
}

std::string running;

int listEntries(FILE* to) {
    std::sort(entries().begin(), entries().end(), [](auto* a, auto* b) { return a->name < b->name; });
    for (const TestEntry* entry : entries())
        std::fprintf(to, "%s\n", entry->name.c_str());
    return to == stderr ? 2 : 0;
}

} // namespace

TestEntry::TestEntry(const char* file, Run inIt)
    : name(std::filesystem::path(file).stem().string()), run(inIt) {
    entries().push_back(this);
}

const std::string& runningTest() {
    return running;
}

} // namespace tactum::test

/// PROGRAM TEST [FUNCTION...] with the options of Qt Test after them. Without a TEST: the names of all.
int main(int argc, char** argv) {
    using namespace tactum::test;
    if (argc < 2) return listEntries(stdout);
    for (const TestEntry* entry : entries()) {
        if (entry->name != argv[1]) continue;
        running = entry->name;
        std::rotate(argv + 1, argv + 2, argv + argc + 1); // Qt Test wants the program and its own words only
        return entry->run(argc - 1, argv);
    }
    std::fprintf(stderr, "%s: there is no test %s; these there are:\n", argv[0], argv[1]);
    return listEntries(stderr);
}
