#include "core/archive/bundle_files.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/archive/sha256.h"
#include "core/base/text.h"

namespace tactum {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMajor = 1;
constexpr const char* kFormat = "Tactum bundle";

bool isOfThisKind(const std::string& version) {
    return version.substr(0, version.find('.')) == std::to_string(kMajor);
}

/// Nothing where the manifest is not one, or is of a later kind.
Result<Json> manifestOf(std::string_view text) {
    Json json = Json::parse(text, nullptr, false);
    const bool shaped = json.is_object() && json.value("format", Json()) == kFormat &&
                        json["version"].is_string() && json["files"].is_array();
    if (!shaped) return inputError("its manifest.json is not that of a Tactum bundle; export it again");
    if (!isOfThisKind(json["version"]))
        return inputError("is a bundle of a later Tactum; update the program");
    return json;
}

Result<void> checked(const ZipEntry& file, const Json& manifest) {
    for (const Json& said : manifest["files"]) {
        if (!said.is_object() || said.value("name", Json()) != file.name) continue;
        if (said.value("bytes", Json()) == file.bytes.size() &&
            said.value("sha256", Json()) == sha256(file.bytes))
            return {};
        return inputError("its " + file.name + " is not the file that was exported; copy the bundle again");
    }
    return inputError("its " + file.name + " is not in the manifest; export the bundle again");
}

} // namespace

std::string packBundle(std::span<const ZipEntry> files) {
    Json manifest{{"format", kFormat}, {"version", std::to_string(kMajor) + ".1"}, {"files", Json::array()}};
    for (const ZipEntry& file : files)
        manifest["files"].push_back(
            {{"name", file.name}, {"bytes", file.bytes.size()}, {"sha256", sha256(file.bytes)}});
    std::vector<ZipEntry> all{{bundle_name::kManifest, manifest.dump(2) + "\n"}};
    all.insert(all.end(), files.begin(), files.end());
    return writeZip(all);
}

std::optional<std::string> laterBundle(std::string_view zip) {
    const auto archive = ZipArchive::open(zip);
    if (!archive) return std::nullopt;
    const auto& names = archive->names();
    const auto place = std::ranges::find(names, bundle_name::kManifest);
    if (place == names.end()) return std::nullopt;
    const auto manifest = archive->read(std::size_t(place - names.begin()));
    if (!manifest) return std::nullopt;
    const Json json = Json::parse(*manifest, nullptr, false); // the rest of it may be of any shape
    if (!json.is_object() || json.value("format", Json()) != kFormat || !json.contains("version"))
        return std::nullopt;
    const Json& said = json["version"];
    const std::string version = said.is_string() ? said.get<std::string>() : said.dump();
    if (isOfThisKind(version)) return std::nullopt;
    return printable(version, 20);
}

Result<BundleFiles> BundleFiles::open(std::string_view zip) {
    auto entries = readZip(zip);
    if (!entries) return tl::unexpected<Error>(entries.error());
    const auto manifest = std::ranges::find(*entries, bundle_name::kManifest, &ZipEntry::name);
    if (manifest == entries->end())
        return inputError(
            "is a zip without a manifest.json, so no bundle; unpack it and open the model that is inside");
    const auto json = manifestOf(manifest->bytes);
    if (!json) return tl::unexpected<Error>(json.error());
    entries->erase(manifest);
    if (entries->size() != (*json)["files"].size())
        return inputError("has fewer files than its manifest says, or more; copy the bundle again");
    for (const ZipEntry& file : *entries)
        if (const auto same = checked(file, *json); !same) return tl::unexpected<Error>(same.error());
    BundleFiles bundle;
    bundle.files_ = std::move(*entries);
    return bundle;
}

std::string_view BundleFiles::file(std::string_view name) const {
    const auto found = std::ranges::find(files_, name, &ZipEntry::name);
    return found == files_.end() ? std::string_view() : std::string_view(found->bytes);
}

} // namespace tactum
