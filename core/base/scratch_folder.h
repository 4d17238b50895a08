// A folder of this process alone, for files that other parts want by their name.
#pragma once

#include <filesystem>
#include <string_view>

namespace tactum {

/// Below the folder for temporary files, for this person alone; gone with its object, with all that is in it.
/// Thread: any but real time.
class ScratchFolder {
public:
    /// `purpose`: a part of its name.
    explicit ScratchFolder(std::string_view purpose);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    /// Empty when the machine has no place for it.
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace tactum
