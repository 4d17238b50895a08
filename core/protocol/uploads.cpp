#include "core/protocol/uploads.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/base/scratch_folder.h"
#include "core/base/text.h"
#include "core/geometry/soup_builder.h"
#include "core/import/import_scene.h"

namespace tactum {
namespace {

/// Letters, digits and what harms nobody in the name of a file.
std::string safeName(std::string_view name) {
    std::string safe;
    for (const char c : name.substr(name.find_last_of('/') + 1)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        safe += plain || c == '-' || c == '_' || (c == '.' && !safe.empty()) ? c : '_';
    }
    constexpr std::size_t kLongest = 80;
    return safe.size() > kLongest ? safe.substr(safe.size() - kLongest) : safe;
}

bool isReadable(const std::string& name) {
    std::string ending = lowerCase(std::filesystem::path(name).extension().string());
    if (!ending.empty()) ending.erase(0, 1);
    return ending == "zip" || std::ranges::find(readableEndings(), ending) != readableEndings().end();
}

/// Nobody outside learns where our files are.
std::string withoutFolder(std::string text, const std::filesystem::path& folder) {
    const std::string prefix = folder.string() + '/';
    for (std::size_t at = text.find(prefix); at != text.npos; at = text.find(prefix, at))
        text.erase(at, prefix.size());
    return text;
}

Result<LoadedScene> readFile(const std::string& name, const std::string& bytes, const Progress& progress) {
    const ScratchFolder folder("upload");
    const auto file = folder.path() / safeName(name);
    std::ofstream out(file, std::ios::binary);
    out.write(bytes.data(), std::streamsize(bytes.size()));
    out.close();
    if (folder.path().empty() || !out)
        return machineError("the server has no room on its disk for this upload: try a smaller one");
    auto loaded = importScene(file, progress);
    if (!loaded)
        return tl::unexpected<Error>(
            {loaded.error().kind, withoutFolder(loaded.error().text, folder.path())});
    for (Finding& finding : loaded->findings)
        finding.sentence = withoutFolder(finding.sentence, folder.path());
    return loaded;
}

/// Takes lists of numbers off the front of bytes that nobody trusts.
class Numbers {
public:
    explicit Numbers(std::string_view bytes) : rest_(bytes) {}

    template <class T> bool take(std::vector<T>& to, std::size_t count) {
        if (count > rest_.size() / sizeof(T)) return false;
        to.resize(count);
        if (count > 0) std::memcpy(static_cast<void*>(to.data()), rest_.data(), count * sizeof(T));
        rest_.remove_prefix(count * sizeof(T));
        return true;
    }
    bool empty() const { return rest_.empty(); }

private:
    std::string_view rest_;
};

constexpr const char* kWrongSize = "a mesh has not as many bytes as its head says";
constexpr std::uint64_t kMostMeshCorners = std::uint64_t(1) << 31;
constexpr std::uint32_t kMostSurfaces = 1 << 16;

template <class T> Result<void> takePositions(Numbers& numbers, TriangleSoup& soup, std::size_t count) {
    std::vector<std::array<T, 3>> read;
    if (!numbers.take(read, count)) return inputError(kWrongSize);
    soup.positions.reserve(count);
    for (const auto& p : read) {
        soup.positions.emplace_back(double(p[0]), double(p[1]), double(p[2]));
        if (!(isCoordinate(soup.positions.back().x()) && isCoordinate(soup.positions.back().y()) &&
              isCoordinate(soup.positions.back().z())))
            return inputError("a corner of a mesh is not within 1e6 m");
    }
    return {};
}

template <class V> bool makeUnit(std::vector<V>& normals) {
    for (V& normal : normals) {
        const float length = normal.norm();
        if (!(length > 1e-12f && length < 1e12f)) return false;
        normal /= length;
    }
    return true;
}

} // namespace

std::uint64_t Uploads::keep(ClientId client, LoadedScene loaded) {
    auto shared = std::make_shared<const LoadedScene>(std::move(loaded));
    const std::lock_guard lock(mutex_);
    auto& kept = kept_[client];
    kept.push_back({++last_, std::move(shared)});
    if (kept.size() > limits_.kept) kept.pop_front();
    return last_;
}

std::shared_ptr<const LoadedScene> Uploads::find(ClientId client, std::uint64_t number) const {
    const std::lock_guard lock(mutex_);
    const auto all = kept_.find(client);
    if (all == kept_.end()) return nullptr;
    const auto found = std::ranges::find(all->second, number, &Kept::number);
    return found == all->second.end() ? nullptr : found->loaded;
}

void Uploads::forget(ClientId client) {
    const std::lock_guard lock(mutex_);
    kept_.erase(client);
}

Incoming::~Incoming() {
    uploads_.underWay_ -= bytes_.size();
}

Result<void> Incoming::begin(const v1::UploadHead& head) {
    if (head.size() == 0 || head.size() > uploads_.limits_.one)
        return inputError("an upload has from 1 to " + std::to_string(uploads_.limits_.one) + " bytes");
    if (head.what_case() == v1::UploadHead::WHAT_NOT_SET)
        return inputError("an upload is a file, a mesh or a scene: its head has to say which");
    if (head.has_file() && !isReadable(safeName(head.file())))
        return inputError(inQuotes(head.file()) + " has no ending that can be read");
    head_ = head;
    return {};
}

Result<void> Incoming::add(std::string_view bytes) {
    if (bytes.size() > head_.size() - bytes_.size())
        return inputError("more bytes came than the upload was said to have");
    if ((uploads_.underWay_ += bytes.size()) > uploads_.limits_.all) {
        uploads_.underWay_ -= bytes.size();
        return machineError("too much is being uploaded at once: wait until other uploads are done");
    }
    bytes_ += bytes;
    return {};
}

Result<LoadedScene> Incoming::read(const Progress& progress) {
    if (!complete()) return inputError("the upload ended before it was complete");
    if (head_.has_file()) return readFile(head_.file(), bytes_, progress);
    if (head_.scene())
        return sceneOf_(bytes_).map([](Scene&& scene) { return LoadedScene{std::move(scene), {}, true}; });
    auto soup = meshOf(head_.mesh(), bytes_);
    if (!soup) return tl::unexpected(soup.error());
    const std::size_t surfaces = std::max<std::size_t>(head_.mesh().surface_count(), 1);
    return sceneOfMesh("mesh", std::move(*soup), std::vector<Surface>(surfaces), progress);
}

Result<TriangleSoup> meshOf(const v1::MeshHead& head, std::string_view bytes) {
    if (head.positions() > kMostMeshCorners || head.triangles() > kMostMeshCorners / 3 ||
        head.surface_count() > kMostSurfaces)
        return inputError("a mesh has more corners, triangles or surfaces than can be");
    TriangleSoup soup;
    Numbers numbers(bytes);
    const std::size_t positions = head.positions(), triangles = head.triangles();
    if (auto taken = head.doubles() ? takePositions<double>(numbers, soup, positions)
                                    : takePositions<float>(numbers, soup, positions);
        !taken)
        return tl::unexpected(taken.error());
    if (!numbers.take(soup.triangles, triangles)) return inputError(kWrongSize);
    for (const auto& triangle : soup.triangles)
        for (const Index corner : triangle)
            if (corner >= positions) return inputError("a triangle names a corner that there is not");
    if (head.normals() && !numbers.take(soup.cornerNormals, 3 * triangles)) return inputError(kWrongSize);
    if (!makeUnit(soup.cornerNormals)) return inputError("a normal of a mesh has no length");
    if (head.uvs() && !numbers.take(soup.cornerUvs, 3 * triangles)) return inputError(kWrongSize);
    if (!std::ranges::all_of(soup.cornerUvs, [](const auto& uv) { return uv.allFinite(); }))
        return inputError("a texture coordinate of a mesh is not finite");
    const Index surfaces = std::max<Index>(head.surface_count(), 1);
    if (!head.surfaces()) soup.surfaceOf.assign(triangles, 0);
    if (head.surfaces() && !numbers.take(soup.surfaceOf, triangles)) return inputError(kWrongSize);
    if (std::ranges::any_of(soup.surfaceOf, [&](Index surface) { return surface >= surfaces; }))
        return inputError("a triangle is of a surface that there is not");
    if (!numbers.empty()) return inputError(kWrongSize);
    return soup;
}

} // namespace tactum
