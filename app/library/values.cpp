#include "app/library/values.h"

#include <algorithm>

#include <tactum/parameter.h>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/scene/world_fields.h"

namespace tactum::library {
namespace {

/// What is a plain member, reached by `at`.
template <class T, class At> Number<T> plain(const core::Parameter& parameter, At at) {
    return {parameter.key, [&parameter](const T&) -> const core::Parameter& { return parameter; },
            [at](const T& of) { return at(const_cast<T&>(of)); },
            [at](T& of, double value) { at(of) = value; }};
}

/// Of the two coefficients of friction the other one follows, as in the window.
Number<core::Surface> materialNumber(const MaterialField& field) {
    auto number = plain<core::Surface>(
        *field.parameter, [&field](core::Surface& of) -> double& { return of.material.*field.value; });
    number.set = [&field](core::Surface& of, double value) {
        of.material = withValue(of.material, field, value);
    };
    return number;
}

Number<core::TextureLayer> strengthNumber() {
    return {
        "strength",
        [](const core::TextureLayer& of) -> const core::Parameter& { return strengthParameter(of.target); },
        [](const core::TextureLayer& of) { return of.strength; },
        [](core::TextureLayer& of, double value) { of.strength = value; }};
}

template <class T, class Names, class At> Choice<T> choice(std::string_view key, const Names& names, At at) {
    std::vector<std::string_view> words;
    for (const auto& one : names)
        words.push_back(one.key);
    return {key, std::move(words), [at](const T& of) { return std::size_t(at(const_cast<T&>(of))); },
            [at](T& of, std::size_t place) {
                auto& to = at(of);
                to = std::remove_reference_t<decltype(to)>(place);
            }};
}

/// What is a height and what a ratio have other units: the strength begins anew.
Choice<core::TextureLayer> targetChoice() {
    auto target = choice<core::TextureLayer>(
        "target", kTextureTargets, [](core::TextureLayer& of) -> TextureTarget& { return of.target; });
    target.set = [set = target.set](core::TextureLayer& of, std::size_t place) {
        const core::Parameter& before = strengthParameter(of.target);
        set(of, place);
        const core::Parameter& now = strengthParameter(of.target);
        if (&now != &before) of.strength = now.initial;
    };
    return target;
}

std::string textOf(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

std::string listOf(const std::vector<std::string_view>& words) {
    std::string text;
    for (const std::string_view word : words)
        text += (text.empty() ? "" : ", ") + std::string(word);
    return text;
}

template <class T> void append(std::vector<Parameter>& all, const Numbers<T>& numbers, std::string_view of) {
    for (const Number<T>& number : numbers) {
        const core::Parameter& one = number.parameter(T{});
        all.push_back({std::string(number.key), std::string(of), std::string(one.label),
                       std::string(one.unit), std::string(one.sentence), one.minimum, one.maximum,
                       one.initial});
    }
}

} // namespace

const Numbers<core::Scene>& sceneNumbers() {
    static const Numbers<core::Scene> all = [] {
        Numbers<core::Scene> made{
            plain<core::Scene>(kProxyRadius, [](core::Scene& of) -> double& { return of.proxyRadius; })};
        for (const WorldField& field : kWorldFields)
            made.push_back(plain<core::Scene>(*field.parameter, [&field](core::Scene& of) -> double& {
                return of.mechanics.*field.value;
            }));
        return made;
    }();
    return all;
}

const Numbers<core::Surface>& surfaceNumbers() {
    static const Numbers<core::Surface> all = [] {
        Numbers<core::Surface> made;
        for (const MaterialField& field : kMaterialFields)
            made.push_back(materialNumber(field));
        made.push_back(plain<core::Surface>(
            kCreaseAngle, [](core::Surface& of) -> double& { return of.shading.creaseAngle; }));
        return made;
    }();
    return all;
}

const Choices<core::Surface>& surfaceChoices() {
    static constexpr NamedChoice kNormals[] = {{"file", ""}, {"computed", ""}};
    static const Choices<core::Surface> all{
        {"sides",
         {kSidesNames.begin(), kSidesNames.end()},
         [](const core::Surface& of) { return std::size_t(of.sides); },
         [](core::Surface& of, std::size_t place) { of.sides = Sides(place); }},
        choice<core::Surface>("normals", kNormals,
                              [](core::Surface& of) -> NormalSource& { return of.shading.normals; })};
    return all;
}

const Numbers<core::TextureLayer>& layerNumbers() {
    static const Numbers<core::TextureLayer> all = [] {
        Numbers<core::TextureLayer> made{
            strengthNumber(),
            plain<core::TextureLayer>(kTextureOpacity,
                                      [](core::TextureLayer& of) -> double& { return of.opacity; })};
        for (const PatternField& field : kPatternFields)
            made.push_back(
                plain<core::TextureLayer>(*field.parameter, [&field](core::TextureLayer& of) -> double& {
                    return of.pattern.*field.value;
                }));
        return made;
    }();
    return all;
}

const Choices<core::TextureLayer>& layerChoices() {
    static const Choices<core::TextureLayer> all{
        choice<core::TextureLayer>(
            "mapping", kTextureMappings,
            [](core::TextureLayer& of) -> TextureMapping& { return of.pattern.mapping; }),
        targetChoice(),
        choice<core::TextureLayer>("blend", kTextureBlends,
                                   [](core::TextureLayer& of) -> TextureBlend& { return of.blend; })};
    return all;
}

std::vector<std::string_view> layerSources() {
    std::vector<std::string_view> words;
    for (const NamedChoice& source : kTextureSources)
        words.push_back(source.key);
    return words;
}

void refuseValue(std::string_view key, const core::Parameter& parameter, double value) {
    refuse(std::string(key) + ": " + textOf(value) + " is not from " + textOf(parameter.minimum) + " to " +
           textOf(parameter.maximum) + (parameter.unit.empty() ? "" : " " + std::string(parameter.unit)));
}

void refuseKey(std::string_view key, const std::vector<std::string_view>& keys) {
    refuse(inQuotes(std::string(key)) + " cannot be set here; there are " + listOf(keys));
}

std::size_t placeOf(std::string_view word, const std::vector<std::string_view>& words, std::string_view key) {
    const auto found = std::ranges::find(words, word);
    if (found == words.end())
        refuse(std::string(key) + ": " + inQuotes(std::string(word)) + " is none of " + listOf(words));
    return std::size_t(found - words.begin());
}

std::vector<Parameter> parameters() {
    std::vector<Parameter> all;
    append(all, surfaceNumbers(), "surface");
    append(all, layerNumbers(), "layer");
    append(all, sceneNumbers(), "scene");
    return all;
}

} // namespace tactum::library
