#include "device/falcon/falcon_firmware.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>

#include "core/archive/sha256.h"
#include "core/base/atomic_file.h"
#include "core/base/realtime.h"
#include "core/base/text.h"

namespace tactum {
namespace {

namespace fs = std::filesystem;

/// More than the processor has room for.
constexpr std::size_t kLargest = 64 * 1024;

struct KnownImage {
    std::string_view fingerprint, name;
};

/// The best first.
constexpr KnownImage kKnown[] = {
    {"1119e39c39fab1f37678ea62dfc715b23dd86ee7f13d78f88f707d9f09b896a1", "Novint nVent"},
    {"b2700d5cd5ca217e48565fb4de5a502a636c53f6e01ebd0cad193e9f84856c6a", "Novint SDK test utilities"},
    {"ae838730af34b5822c9c3949859b446614af0410730b832cc17a6ad627ea64a4", "Novint T0"},
    {"e0ae3598670fa1c8d9277bd6943c99b3152b97c400c46c1c42c60de77ff4e816", "Novint T2"},
};

std::string nameOf(std::span<const std::uint8_t> bytes) {
    const std::string print = sha256({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    for (const KnownImage& known : kKnown)
        if (print == known.fingerprint) return std::string(known.name);
    return {};
}

std::size_t rankOf(const std::string& name) {
    const auto* found = std::ranges::find(kKnown, name, &KnownImage::name);
    return std::size_t(found - std::begin(kKnown));
}

fs::path fromEnvironment(const char* variable) {
    const char* value = std::getenv(variable);
    return value ? fs::path(value) : fs::path();
}

/// Of the files *.bin in a folder the best, if one is good.
std::optional<FalconFirmware> bestIn(const fs::path& folder) {
    std::optional<FalconFirmware> best;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (at->path().extension() != ".bin") continue;
        auto found = readFalconFirmware(at->path());
        if (!found) continue;
        const auto order = [](const FalconFirmware& f) { return std::pair(rankOf(f.name), f.file); };
        if (!best || order(*found) < order(*best)) best = std::move(*found);
    }
    return best;
}

std::optional<FalconFirmware> goodAt(const fs::path& place) {
    std::error_code error;
    if (fs::is_directory(place, error)) return bestIn(place);
    auto found = readFalconFirmware(place);
    return found ? std::optional(std::move(*found)) : std::nullopt;
}

} // namespace

std::size_t bootStreamLength(std::span<const std::uint8_t> bytes) {
    constexpr unsigned kKey = 0x08aa;
    constexpr std::size_t kWordsBeforeBlocks = 1 + 8 + 2; // key, reserved, entry point
    const std::size_t words = bytes.size() / 2;
    const auto word = [&](std::size_t at) { return unsigned(bytes[2 * at] | bytes[2 * at + 1] << 8); };
    if (words <= kWordsBeforeBlocks || word(0) != kKey) return 0;
    for (std::size_t at = kWordsBeforeBlocks; at < words;) {
        const unsigned length = word(at);
        if (length == 0) return 2 * (at + 1);
        at += 1 + 2 + length; // length, destination, content
    }
    return 0;
}

Result<FalconFirmware> readFalconFirmware(const fs::path& file) {
    assertNotRealtime();
    const std::string shown = inQuotes(file.string());
    std::error_code error;
    if (!fs::is_regular_file(file, error))
        return inputError("There is no file " + shown + ": put your copy of the Falcon's firmware there.");
    std::ifstream in(file, std::ios::binary);
    std::vector<std::uint8_t> bytes(kLargest + 1);
    in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    if (in.bad() || !in.eof() || in.gcount() == 0)
        bytes.clear();
    else
        bytes.resize(std::size_t(in.gcount()));
    if (bytes.empty() || bootStreamLength(bytes) != bytes.size())
        return inputError("The file " + shown +
                          " is no firmware of a Falcon, or not all of it: take nvent_firmware.bin.");
    std::string name = nameOf(bytes);
    return FalconFirmware{std::move(bytes), file, std::move(name)};
}

std::vector<fs::path> falconFirmwarePlaces() {
    const fs::path home = fromEnvironment("HOME");
    fs::path config = fromEnvironment("XDG_CONFIG_HOME");
    if (config.empty()) config = home / ".config";
    return {config / "Tactum" / "falcon",
            "/usr/local/share/tactum/falcon",
            "/usr/share/tactum/falcon",
            home / "libnifalcon" / "firmware",
            "/usr/local/share/libnifalcon/firmware",
            "/usr/share/libnifalcon/firmware",
            "/usr/local/share/libnifalcon",
            "/usr/share/libnifalcon"};
}

Result<FalconFirmware> findFalconFirmware(const fs::path& chosen, const std::vector<fs::path>& places) {
    if (!chosen.empty()) return readFalconFirmware(chosen);
    if (const fs::path named = fromEnvironment("TACTUM_FALCON_FIRMWARE"); !named.empty())
        return readFalconFirmware(named);
    for (const fs::path& place : places)
        if (auto found = goodAt(place)) return std::move(*found);
    const std::string own = places.empty() ? "its settings" : inQuotes(places.front().string());
    return inputError("The Falcon needs its firmware, which this program may not carry: put your copy of "
                      "nvent_firmware.bin (from libnifalcon's source, folder firmware, or Novint's driver) "
                      "into " +
                      own + ", choose it in the dock Device, or name it in TACTUM_FALCON_FIRMWARE.");
}

Result<FalconFirmware> keepFalconFirmware(const fs::path& file) {
    auto firmware = readFalconFirmware(file);
    if (!firmware) return firmware;
    const fs::path folder = falconFirmwarePlaces().front();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return machineError("The folder " + inQuotes(folder.string()) +
                            " cannot be made: " + error.message() + ".");
    firmware->file = folder / file.filename().replace_extension(".bin"); // only those are looked at
    const std::string_view bytes(reinterpret_cast<const char*>(firmware->bytes.data()),
                                 firmware->bytes.size());
    if (const auto written = writeFileAtomically(firmware->file, bytes, 0); !written)
        return tl::unexpected<Error>(written.error());
    return firmware;
}

} // namespace tactum
