// The readers under libFuzzer: fuzz-readers --target=NAME [FLAGS OF LIBFUZZER] CORPUS... tests/fuzz/run
// starts it.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "tests/fuzz/glb_mutator.h"
#include "tests/fuzz/targets.h"

using namespace tactum::fuzz;

namespace {
const Target* target = nullptr;
}

extern "C" {

std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

int LLVMFuzzerInitialize(int* argc, char*** argv) {
    constexpr std::string_view kFlag = "--target="; // libFuzzer passes over what begins with two dashes
    for (int i = 1; i < *argc; ++i) {
        const std::string_view word = (*argv)[i];
        if (!word.starts_with(kFlag)) continue;
        const auto named = [&](const Target& one) { return one.name == word.substr(kFlag.size()); };
        const auto found = std::ranges::find_if(targets(), named);
        if (found != targets().end()) target = &*found;
    }
    if (target) return 0;
    for (const Target& one : targets())
        std::cout << one.name << '\n';
    std::exit(2);
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    target->read({reinterpret_cast<const char*>(data), size});
    return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                    unsigned seed) {
    if (!target->isContainer) return LLVMFuzzerMutate(data, size, maxSize);
    const std::string changed =
        mutatedGlb({reinterpret_cast<const char*>(data), size}, seed, LLVMFuzzerMutate);
    if (changed.size() > maxSize) return size;
    std::memcpy(data, changed.data(), changed.size());
    return changed.size();
}
}
