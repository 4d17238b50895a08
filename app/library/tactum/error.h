// What cannot be, as an exception with one sentence.
#pragma once

#include <stdexcept>
#include <string>

#include <tactum/export.h>

namespace tactum::library {

/// what() is one line for a person, the one that the program says: what, where, what to do. Nothing has
/// changed where one is thrown. What runs in real time throws nothing.
class TACTUM_API Error : public std::runtime_error {
public:
    /// Whose fault it is.
    enum class Kind : int {
        Input = 1,  ///< a file, an array or a value that was given
        Machine = 3 ///< disk, memory or device
    };

    Error(Kind kind, const std::string& sentence);
    ~Error() override;

    Kind kind() const noexcept { return kind_; }

private:
    Kind kind_;
};

} // namespace tactum::library
