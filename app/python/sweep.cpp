#include "app/python/sweep.h"

#include <algorithm>

namespace tactum::python {
namespace {

template <class T> bool has(const Properties<T>& all, const std::string& name) {
    return std::ranges::any_of(all, [&](const Property<T>& one) { return one.name == name && one.set; });
}

} // namespace

std::vector<Scene> sweepOf(const OpenScene& of, const std::string& name, const py::handle& values,
                           const std::vector<SurfaceHandle>& surfaces) {
    const Numbers numbers = numbersOf(values, "values");
    if (numbers.ndim() != 1 || numbers.size() == 0)
        throw Failure("values: is one row of numbers, of at least one");
    const bool ofScene = has(sceneProperties(), name);
    const Property<Surface>* ofSurface = ofScene ? nullptr : &named(surfaceProperties(), name);
    std::vector<Scene> scenes;
    for (py::ssize_t i = 0; i < numbers.size(); ++i) {
        Scene& scene = scenes.emplace_back(of.scene);
        const py::float_ value(numbers.at(i));
        if (ofScene)
            named(sceneProperties(), name).set(scene, value);
        else
            for (const SurfaceHandle& handle : surfaces)
                ofSurface->set(scene.find(handle.object.id)->surfaces[handle.index], value);
    }
    return scenes;
}

} // namespace tactum::python
