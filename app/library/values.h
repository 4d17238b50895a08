// The numbers and choices of scenes, surfaces and layers, by the keys of the parameter table.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/library/parts.h"
#include "core/surface/parameter.h"

namespace tactum::library {

/// A number of a T.
template <class T> struct Number {
    std::string_view key;
    std::function<const core::Parameter&(const T&)> parameter;
    std::function<double(const T&)> get;
    std::function<void(T&, double)> set; ///< what is in its range
};
template <class T> using Numbers = std::vector<Number<T>>;

/// One of some words.
template <class T> struct Choice {
    std::string_view key;
    std::vector<std::string_view> words;
    std::function<std::size_t(const T&)> get;
    std::function<void(T&, std::size_t)> set;
};
template <class T> using Choices = std::vector<Choice<T>>;

const Numbers<core::Scene>& sceneNumbers();
const Numbers<core::Surface>& surfaceNumbers();
const Choices<core::Surface>& surfaceChoices();
const Numbers<core::TextureLayer>& layerNumbers();
const Choices<core::TextureLayer>& layerChoices();
/// The words of the sources of layers.
std::vector<std::string_view> layerSources();

/// "0.5 is not from 0 to 2 m" of a value out of its range. Error.
[[noreturn]] void refuseValue(std::string_view key, const core::Parameter& parameter, double value);
/// Error: no such key, with those that there are.
[[noreturn]] void refuseKey(std::string_view key, const std::vector<std::string_view>& keys);

template <class Entry> bool has(const std::vector<Entry>& all, std::string_view key) {
    for (const Entry& one : all)
        if (one.key == key) return true;
    return false;
}

template <class Entry> const Entry& named(const std::vector<Entry>& all, std::string_view key) {
    std::vector<std::string_view> keys;
    for (const Entry& one : all) {
        if (one.key == key) return one;
        keys.push_back(one.key);
    }
    refuseKey(key, keys);
}

template <class T> void setNumber(T& of, const Numbers<T>& all, std::string_view key, double value) {
    const Number<T>& number = named(all, key);
    if (const core::Parameter& parameter = number.parameter(of); !parameter.allows(value))
        refuseValue(key, parameter, value);
    number.set(of, value);
}

std::size_t placeOf(std::string_view word, const std::vector<std::string_view>& words, std::string_view key);

template <class T> void setWord(T& of, const Choices<T>& all, std::string_view key, std::string_view word) {
    const Choice<T>& choice = named(all, key);
    choice.set(of, placeOf(word, choice.words, key));
}

template <class T> std::string wordOf(const T& of, const Choices<T>& all, std::string_view key) {
    const Choice<T>& choice = named(all, key);
    return std::string(choice.words[choice.get(of)]);
}

} // namespace tactum::library
