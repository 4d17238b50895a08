// Another program that is asked a question.
#pragma once

#include <string>
#include <vector>

namespace tactum {

/// What `program` writes with these arguments, at most 1 MB; empty when it does not start, fails or takes
/// longer than `patience` ms, after which it is killed. Thread: any but real time.
std::string outputOf(const std::string& program, std::vector<std::string> arguments, int patience);

} // namespace tactum
