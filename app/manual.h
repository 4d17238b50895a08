// What the command line says of itself in other forms than --help, from the same table: the man page and what
// shells complete.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace tactum {

/// The forms that there are, for --help: man|bash|zsh|fish.
inline constexpr const char* kManualForms = "man|bash|zsh|fish";

/// Every verb of `program` with its options, in one of kManualForms; nothing for another word. Verbs and
/// options without a group, which are for the program itself, are left out. Thread: any but real time
std::optional<std::string> manual(const CLI::App& program, std::string_view form);

} // namespace tactum
