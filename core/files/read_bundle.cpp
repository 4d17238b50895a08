// The scene inside a bundle, after all of the bundle was held against its manifest.
#include "core/archive/bundle_files.h"
#include "core/files/readers.h"

namespace tactum {

LoadedScene readBundle(const Source& source, const Progress& progress) {
    const auto bundle = BundleFiles::open(source.bytes());
    if (!bundle) source.fail(bundle.error().text);
    const std::string_view scene = bundle->file(bundle_name::kScene);
    if (scene.empty())
        source.fail(std::string("has no ") + bundle_name::kScene + "; export the bundle again");
    return readGltf(Source::ofBytes(source.path(), scene), progress);
}

} // namespace tactum
