// The compiled part of the package: tactum._tactum. What is public is named in tactum/__init__.py.
#include "app/python/scene_handles.h"

PYBIND11_MODULE(_tactum, module) {
    using namespace tactum::python;
    module.doc() = "Scenes opened, changed, touched and written without a server: the core of Tactum. SI "
                   "throughout, the world's frame, y up.";
    raiseFailuresAs(py::module_::import("tactum.results").attr("Error"));
    bindParameters(module);
    bindMask(module);
    bindLayer(module);
    bindPreset(module);
    bindSurface(module);
    bindJoint(module);
    bindBody(module);
    bindObject(module);
    bindScene(module);
    bindWorld(module);
    bindRecording(module);
}
