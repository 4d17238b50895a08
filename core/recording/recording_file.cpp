#include "core/recording/recording_file.h"

#include <algorithm>
#include <fstream>
#include <new>

#include <nlohmann/json.hpp>

#include "core/base/fingerprint.h"
#include "core/base/realtime.h"
#include "core/base/text.h"
#include "core/files/source.h"
#include "core/import/import_scene.h"
#include "core/port/device_figures.h"
#include "core/recording/row_checks.h"
#include "core/recording/scene_list_bytes.h"

namespace tactum {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMagic = "TACTUMRC";
/// Of one hand, and of several.
constexpr std::uint32_t kVersion = 20, kVersionOfHands = 21;
/// Of each loop; a state is much larger in memory than it may be in the file.
constexpr std::uint64_t kMaxStates = 2 * std::uint64_t(kRecorded / kStateEvery);
constexpr std::size_t kStart = 16, kSeal = 8; ///< bytes before the header, and after everything
constexpr std::uint64_t kLargestFile = std::uint64_t(4) << 30;

std::uint64_t fingerprintOf(std::string_view bytes) {
    Fingerprint print;
    print.add(bytes.data(), bytes.size());
    return print.value();
}

Json toJson(const DeviceInfo& device) {
    Json json{{"name", device.name}};
    for (const DeviceFigure& figure : kDeviceFigures)
        json[figure.key] = device.*figure.value;
    json["measures_velocity"] = device.measuresVelocity;
    return json;
}

DeviceInfo deviceOf(const Json& json) {
    DeviceInfo device;
    device.name = printable(json.at("name").get<std::string>());
    for (const DeviceFigure& figure : kDeviceFigures)
        device.*figure.value = json.value(figure.key, device.*figure.value);
    device.measuresVelocity = json.value("measures_velocity", device.measuresVelocity);
    return device;
}

template <class Row, class State>
Json toJson(const NumberedRows<Row>& rows, const std::vector<State>& states) {
    return {{"first", rows.first},
            {"rows", rows.rows.size()},
            {"row_bytes", sizeof(Row)},
            {"states", states.size()}};
}

template <class State> void writeStates(StringOut& out, const std::vector<State>& states) {
    for (const State& state : states) {
        std::uint64_t row = state.row, size = state.size;
        out(row), out(size);
        out.bytes.append(reinterpret_cast<const char*>(state.bytes.data()), size);
    }
}

template <class Row> void writeRows(StringOut& out, const std::vector<Row>& rows) {
    out.bytes.append(reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(Row));
}

void writeHand(StringOut& out, const HandRecord& hand) {
    writeRows(out, hand.proxy.rows);
    writeRows(out, hand.servo.rows);
    writeStates(out, hand.proxyStates);
    writeStates(out, hand.servoStates);
}

std::string headerOf(const Recording& recording, std::size_t sceneBytes) {
    const RecordedRun& run = recording.run;
    Json json{{"format", "tactum-recording"},
              {"reason", recording.reason},
              {"seconds", run.end() - run.begin()},
              {"device", toJson(run.device)},
              {"sources", Json::array()},
              {"scene_bytes", sceneBytes},
              {"proxy", toJson(run.proxy, run.proxyStates)},
              {"servo", toJson(run.servo, run.servoStates)}};
    for (const HandRecord& other : run.others)
        json["others"].push_back({{"device", toJson(other.device)},
                                  {"proxy", toJson(other.proxy, other.proxyStates)},
                                  {"servo", toJson(other.servo, other.servoStates)}});
    for (const auto& source : recording.sources)
        json["sources"].push_back(source.string());
    return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

[[noreturn]] void failFor(const std::filesystem::path& file, const std::string& text) {
    throw ByteFault{{Error::Kind::Input, printable(file.filename().string()) + ": " + text}};
}

/// Whether it begins as a recording that can be read: what is none is not read any further.
void demandStart(std::string_view bytes, const std::filesystem::path& file) {
    if (bytes.size() < kStart || !bytes.starts_with(kMagic))
        failFor(file,
                "is no recording of Tactum; choose a file that ends in ." + std::string(kRecordingEnding));
    std::uint32_t version = 0;
    std::memcpy(&version, bytes.data() + kMagic.size(), sizeof version);
    if (version != kVersion && version != kVersionOfHands)
        failFor(file, "was written by another version of Tactum (format " + std::to_string(version) +
                          ", this one reads " + std::to_string(kVersion) + " and " +
                          std::to_string(kVersionOfHands) + "); open it with that one");
}

/// What the loaded models offer. `folder` first: a recording may have come from another machine together with
/// its model.
KnownParts partsOf(const std::vector<std::filesystem::path>& sources, const std::filesystem::path& folder) {
    KnownParts parts;
    for (const auto& source : sources)
        for (const auto& place : {folder / source.filename(), source}) {
            const auto loaded = importScene(place);
            if (!loaded) continue;
            parts.add(loaded->scene);
            Scene fitted = loaded->scene;
            fitDiagonal(fitted, kHandDiagonal);
            parts.add(fitted);
            break;
        }
    return parts;
}

/// What may be left out: nothing of scenes that are small, else what the models really hold by now.
KnownParts leftOut(const Recording& recording) {
    if (recording.sources.empty() || areSmall(recording.run.scenes)) return {};
    return partsOf(recording.sources, recording.sources.front().parent_path());
}

/// The parts of a file in the order in which they come.
class Reader {
public:
    Reader(std::string_view bytes, const std::filesystem::path& file)
        : bytes_(bytes), file_(file), name_(printable(file.filename().string())) {}

    Recording read() {
        readHeader();
        Recording recording;
        RecordedRun& run = recording.run;
        try {
            recording.reason = printable(header_.at("reason").get<std::string>(), 400);
            for (const auto& source : header_.at("sources"))
                recording.sources.emplace_back(source.get<std::string>());
            ByteIn scenes = part(header_.at("scene_bytes").get<std::uint64_t>());
            run.scenes = readScenes(scenes, [&] { return partsOf(recording.sources, file_.parent_path()); });
            scenes.demand(scenes.left() == 0, "the scenes are followed by something else");
            readHand(header_, run);
            readOthers(run.others);
        } catch (const Json::exception&) {
            fail("its header lacks something or has it wrong; the recording is damaged, use another one");
        }
        if (at_ != bytes_.size() - kSeal)
            fail("is longer than it says; the recording is damaged, use another one");
        if (const std::string fault = faultIn(run); !fault.empty())
            fail(fault + "; the recording is damaged, use another one");
        return recording;
    }

private:
    [[noreturn]] void fail(const std::string& text) const { failFor(file_, text); }

    void readHeader() {
        demandStart(bytes_, file_);
        std::uint32_t length = 0;
        std::memcpy(&length, bytes_.data() + 12, 4);
        if (bytes_.size() < kStart + kSeal) fail("was cut off; copy it again");
        std::uint64_t seal = 0;
        std::memcpy(&seal, bytes_.data() + bytes_.size() - kSeal, kSeal);
        if (seal != fingerprintOf(bytes_.substr(0, bytes_.size() - kSeal)))
            fail("its fingerprint does not fit: it was cut off or changed; copy it again");
        if (length > bytes_.size() - kStart - kSeal)
            fail("its header is longer than the file; use another one");
        header_ = Json::parse(bytes_.substr(kStart, length), nullptr, false);
        if (!header_.is_object()) fail("its header is no JSON; the recording is damaged, use another one");
        at_ = kStart + length;
    }

    ByteIn part(std::uint64_t size) {
        if (size > bytes_.size() - kSeal - at_)
            fail("byte " + std::to_string(at_) +
                 ": it ends too early; the recording is damaged, use another one");
        ByteIn in(bytes_.substr(at_, size), name_, at_, "the recording is damaged, use another one");
        at_ += size;
        return in;
    }

    void readHand(const Json& json, HandRecord& hand) {
        hand.device = deviceOf(json.at("device"));
        readRows(json.at("proxy"), hand.proxy);
        readRows(json.at("servo"), hand.servo);
        readStates(json.at("proxy"), hand.proxy, hand.proxyStates);
        readStates(json.at("servo"), hand.servo, hand.servoStates);
    }

    void readOthers(std::vector<HandRecord>& others) {
        if (!header_.contains("others")) return;
        const Json& hands = header_.at("others");
        if (!hands.is_array() || hands.size() >= std::size_t(kMaxHands))
            fail("has more hands than can be; the recording is damaged, use another one");
        for (const Json& hand : hands)
            readHand(hand, others.emplace_back());
    }

    template <class Row> void readRows(const Json& json, NumberedRows<Row>& rows) {
        rows.first = json.at("first").get<std::uint64_t>();
        const auto count = json.at("rows").get<std::uint64_t>();
        if (json.at("row_bytes").get<std::uint64_t>() != sizeof(Row) || count > bytes_.size() / sizeof(Row) ||
            rows.first > ~std::uint64_t(0) / 2)
            fail("its rows are not as long as they should be; the recording is damaged, use another one");
        const ByteIn in = part(count * sizeof(Row));
        rows.rows.resize(count);
        if (count > 0)
            std::memcpy(static_cast<void*>(rows.rows.data()), in.rest().data(), count * sizeof(Row));
    }

    template <class Row, class State>
    void readStates(const Json& json, const NumberedRows<Row>& rows, std::vector<State>& states) {
        const auto count = json.at("states").get<std::uint64_t>();
        if (count > kMaxStates)
            fail("has more states than a minute can have; the recording is damaged, use another one");
        std::uint64_t next = rows.first;
        for (std::uint64_t i = 0; i < count; ++i) {
            ByteIn numbers = part(16);
            State state;
            numbers(state.row), numbers(state.size);
            numbers.demand(state.row >= next && state.row < rows.end(), "a state belongs to no row");
            numbers.demand(state.size <= state.bytes.size(), "a state is too long");
            next = state.row + 1;
            const ByteIn in = part(state.size);
            std::memcpy(state.bytes.data(), in.rest().data(), state.size);
            states.push_back(state);
        }
    }

    std::string_view bytes_;
    std::filesystem::path file_;
    std::string name_;
    Json header_;
    std::size_t at_ = 0;
};

/// Of a file that can be read at all: whether it begins as a recording and is no longer than one.
void demandRecording(const std::filesystem::path& file) {
    std::error_code unknown; // then whoever reads it says more
    if (!std::filesystem::is_regular_file(file, unknown)) return;
    std::ifstream in(file, std::ios::binary);
    if (!in) return;
    std::string start(kStart, '\0');
    in.read(start.data(), std::streamsize(start.size()));
    start.resize(std::size_t(in.gcount()));
    demandStart(start, file);
    if (const auto size = std::filesystem::file_size(file, unknown); !unknown && size > kLargestFile)
        failFor(file, "is larger than 4 GB, as no recording is; use another one");
}

} // namespace

void sealRecording(std::string& bytes) {
    const std::uint64_t seal = fingerprintOf(std::string_view(bytes).substr(0, bytes.size() - kSeal));
    std::memcpy(bytes.data() + bytes.size() - kSeal, &seal, kSeal);
}

std::string recordingBytes(const Recording& recording) {
    assertNotRealtime();
    const RecordedRun& run = recording.run;
    const std::string scenes = sceneBytes(run.scenes, leftOut(recording));
    const std::string header = headerOf(recording, scenes.size());
    StringOut out;
    out.bytes = kMagic;
    std::uint32_t version = run.others.empty() ? kVersion : kVersionOfHands,
                  length = std::uint32_t(header.size());
    out(version), out(length);
    out.bytes += header;
    out.bytes += scenes;
    for (std::size_t i = 0; i < run.hands(); ++i)
        writeHand(out, run.hand(i));
    out.bytes.append(kSeal, '\0');
    sealRecording(out.bytes);
    return std::move(out.bytes);
}

Result<Recording> parseRecording(std::string_view bytes, const std::filesystem::path& file) {
    assertNotRealtime();
    try {
        return Reader(bytes, file).read();
    } catch (const ByteFault& fault) {
        return tl::unexpected<Error>(fault.error);
    }
}

Result<Recording> readRecording(const std::filesystem::path& file) {
    try {
        demandRecording(file);
        return parseRecording(Source::open(file, kLargestFile).bytes(), file);
    } catch (const ByteFault& fault) {
        return tl::unexpected<Error>(fault.error);
    } catch (const ReadFault& fault) {
        return tl::unexpected<Error>(fault.error);
    } catch (const std::bad_alloc&) {
        return machineError(printable(file.filename().string()) +
                            ": not enough memory to read it; close other programs");
    }
}

} // namespace tactum
