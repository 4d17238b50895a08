// "-" for a scene: standard input, and standard output for what is written.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/files/load_scene.h"

namespace tactum {

/// A folder for one file that comes or goes by a pipe; gone at the end.
class PipeFolder {
public:
    PipeFolder();
    PipeFolder(const PipeFolder&) = delete;
    PipeFolder& operator=(const PipeFolder&) = delete;
    ~PipeFolder();

    /// Empty when the machine has no place for it.
    const std::filesystem::path& path() const { return path_; }
    /// A sentence about a file in it, with what the person knows it as.
    Error renamed(Error error, const std::string& name) const;

private:
    std::filesystem::path path_;
};

/// importScene() of a file, or for "-" of standard input, whose format is told by its first bytes.
Result<LoadedScene> importGiven(const std::filesystem::path& file);

} // namespace tactum
