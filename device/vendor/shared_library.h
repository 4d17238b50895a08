// A maker's library that is loaded when the user has it, and a sentence when not.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace tactum {

/// What is looked for, in words that a person understands.
struct LibraryWanted {
    std::string name;               ///< "OpenHaptics"
    std::string variable;           ///< of the environment: the path of the file, and nothing else is tried
    std::vector<std::string> files; ///< tried one after the other, by the rules of the system's loader
    std::string remedy;             ///< a sentence: what to install
};

/// Stays in memory once it was loaded: its threads may outlive whoever asked for it.
/// Thread of every member: any but real time, one at a time.
class SharedLibrary {
public:
    /// Error: names the library, what was tried and why that failed, and what to install.
    static Result<SharedLibrary> open(const LibraryWanted& wanted);
    ~SharedLibrary();
    SharedLibrary(SharedLibrary&& other) noexcept;
    SharedLibrary(const SharedLibrary&) = delete;
    SharedLibrary& operator=(const SharedLibrary&) = delete;

    /// Takes the function if it is there.
    template <class Function> bool find(const char* symbol, Function*& function) const {
        function = reinterpret_cast<Function*>(address(symbol));
        return function != nullptr;
    }
    /// Takes the function, or remembers that it is missing, for complete().
    template <class Function> void need(const char* symbol, Function*& function) {
        if (!find(symbol, function) && missing_.empty()) missing_ = symbol;
    }
    /// An error about the first function that was needed and is not there.
    Result<void> complete() const;

private:
    SharedLibrary(void* handle, std::string file, LibraryWanted wanted);
    void* address(const char* symbol) const;

    void* handle_;
    std::string file_;
    LibraryWanted wanted_;
    std::string missing_;
};

} // namespace tactum
