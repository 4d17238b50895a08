// The JSON schema of our glTF extension, made from the tables that the program itself reads and writes by.
#pragma once

#include <string>

namespace tactum {

/// docs/schema/TACTUM_haptics.schema.json: draft 2020-12, one definition for each place of the extension.
std::string formatSchema();

} // namespace tactum
