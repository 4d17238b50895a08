#include "tests/fuzz/glb_mutator.h"

#include <cstring>
#include <random>

#include "core/files/gltf/gltf_file.h"
#include "core/files/gltf/write_gltf.h"
#include "tests/support/random_scene.h"

namespace tactum::fuzz {
namespace {

constexpr std::size_t kLongestText = 64;

class GlbMutator {
public:
    GlbMutator(unsigned seed, MutateBytes mutateBytes)
        : seed_(seed), random_(seed), mutateBytes_(mutateBytes) {}

    std::string fresh() { return glbOf(test::SceneDice(seed_).scene()).value(); }

    std::string change(const std::string& glb) {
        const Source source = Source::ofBytes("a.glb", glb);
        GltfFile file = openGltf(source);
        std::string binary(file.binary);
        for (std::size_t i = 1 + below(4); i > 0; --i)
            below(4) == 0 ? changeBinary(binary) : changeJson(file.json);
        return packGlb(file.json, binary);
    }
    std::size_t below(std::size_t count) { return random_() % count; }

private:
    /// Some member somewhere below, sooner among what is ours.
    Json& pick(Json& json) {
        Json* at = &json;
        for (const char* list : {"materials", "nodes", "animations"})
            if (below(3) == 0 && json.contains(list)) {
                at = &json[list];
                break;
            }
        while (at->is_structured() && !at->empty() && (at == &json || below(8) != 0))
            at = &*std::next(at->begin(), std::ptrdiff_t(below(at->size())));
        return *at;
    }

    Json hostile() {
        static const Json kValues[] = {0,
                                       1,
                                       -1,
                                       2,
                                       1e9,
                                       -1e9,
                                       1e38,
                                       1e-38,
                                       1e308,
                                       0.5,
                                       true,
                                       false,
                                       nullptr,
                                       "",
                                       "image",
                                       -0.0,
                                       4294967295u,
                                       4294967296,
                                       255,
                                       65536,
                                       "alpha",
                                       1e300 * 1e10,
                                       1e-6,
                                       1e6,
                                       100'000,
                                       Json::array(),
                                       Json::object(),
                                       {0, 0, 0, 0},
                                       {1e38, -1e38, 1e38},
                                       Json::array({0}),
                                       "2.0",
                                       0.001};
        return kValues[below(std::size(kValues))];
    }

    void changeText(Json& place) {
        std::string text = place.get<std::string>();
        text.resize(std::min(text.size(), kLongestText));
        std::uint8_t room[kLongestText] = {};
        std::memcpy(room, text.data(), text.size());
        const std::size_t size = mutateBytes_(room, text.size(), kLongestText);
        text.assign(reinterpret_cast<const char*>(room), size);
        for (char& c : text) // JSON is UTF-8
            c = char(c & 0x7f);
        place = text;
    }

    void changeJson(Json& json) {
        Json& place = pick(json);
        switch (below(6)) {
        case 0:
            if (place.is_string()) return changeText(place);
            [[fallthrough]];
        case 1:
            place = hostile();
            break;
        case 2:
            if (place.is_number()) place = place.get<double>() * (below(2) == 0 ? -1 : 1000);
            break;
        case 3: // what stands elsewhere
            place = Json(pick(json));
            break;
        case 4:
            if (place.is_array() && !place.empty()) place.push_back(Json(place[below(place.size())]));
            break;
        default:
            if (place.is_structured() && !place.empty())
                place.erase(std::next(place.begin(), std::ptrdiff_t(below(place.size()))));
        }
        if (!json.is_object()) json = Json::object();
    }

    void changeBinary(std::string& binary) {
        static constexpr float kNumbers[] = {0, 1, -1, 1e38f, -1e38f, 1e-38f, 1e6f, INFINITY, NAN};
        if (binary.size() < 4) return;
        const std::size_t at = below(binary.size() / 4) * 4;
        if (below(2) == 0)
            std::memcpy(binary.data() + at, &kNumbers[below(std::size(kNumbers))], 4);
        else
            mutateBytes_(reinterpret_cast<std::uint8_t*>(binary.data()) + at, 4, 4);
    }

    unsigned seed_;
    std::mt19937 random_;
    MutateBytes mutateBytes_;
};

} // namespace

std::string mutatedGlb(std::string_view glb, unsigned seed, MutateBytes mutateBytes) {
    GlbMutator mutator(seed, mutateBytes);
    std::string whole(glb);
    try {
        if (mutator.below(50) == 0) whole = mutator.fresh();
        return mutator.change(whole);
    } catch (const ReadFault&) {
        return mutator.change(mutator.fresh());
    }
}

} // namespace tactum::fuzz
