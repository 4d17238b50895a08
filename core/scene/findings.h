// What a person should know of a scene, in sentences.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/mesh_health.h"
#include "core/scene/scene.h"

namespace tactum {

/// Something about a scene that the person should know.
struct Finding {
    enum class Severity { Note, Warning, Error };
    Severity severity = Severity::Note;
    std::string object;   ///< name of the object, empty for the scene
    std::string sentence; ///< what is the matter, with its count
    std::string remedy;   ///< what to do, or what was done

    bool operator==(const Finding&) const = default;
};

/// "note", "warning" or "error".
std::string_view nameOf(Finding::Severity severity);
/// One line: "warning: lid: 3 faces left out; export it again".
std::string lineOf(const Finding& finding);

/// Everything that `tactum check` says: the health of each mesh and every value out of its range.
std::vector<Finding> validate(const Scene& scene);

/// What the health of a mesh lets a person expect, in sentences. Several parts, and edges where more than two
/// triangles meet, are no trouble: most models are put together so, and they feel as they look.
void appendHealth(std::vector<Finding>& findings, const std::string& object, const MeshHealth& health);
/// Whether a finding is one of those, about triangles: it was true of the mesh then, and may be repaired
/// since.
bool saysHealth(const Finding& finding);
/// "1 triangle", "7 triangles".
std::string counted(std::size_t count, std::string_view noun);

/// Findings about one object, each only if its count is not zero.
class CountedFindings {
public:
    CountedFindings(std::vector<Finding>& findings, const std::string& object)
        : findings_(findings), object_(object) {}

    void add(Finding::Severity severity, std::size_t count, std::string_view noun,
             const std::string& predicate, const std::string& remedy);

private:
    std::vector<Finding>& findings_;
    const std::string& object_;
};

} // namespace tactum
