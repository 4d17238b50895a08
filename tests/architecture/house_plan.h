// The plan of the house: which room may use which, and where each outside library may be seen.
// A new arrow or library is one line here, and a sentence in docs/architecture.md.
#pragma once

#include <string_view>
#include <vector>

namespace tactum::architecture {

/// A folder and the folders that it uses; what those use it may use as well.
struct Room {
    std::string_view folder;
    std::vector<std::string_view> uses;
};

inline const std::vector<Room> kRooms{
    {"core/base", {}},
    {"core/archive", {"core/base"}},
    {"core/geometry", {"core/base"}},
    {"core/collision", {"core/geometry"}},
    {"core/surface", {"core/geometry"}},
    {"core/paint", {"core/surface"}},
    {"core/motion", {"core/base"}},
    {"core/dynamics", {"core/base"}},
    {"core/proxy", {"core/collision", "core/surface", "core/motion"}},
    {"core/port", {"core/base"}},
    {"core/loop", {"core/port"}},
    {"core/scene", {"core/geometry", "core/surface", "core/motion", "core/dynamics"}},
    {"core/health", {"core/scene", "core/collision"}},
    {"core/files", {"core/scene", "core/archive"}},
    {"core/presets", {"core/files"}},
    {"core/import", {"core/files"}},
    {"core/haptics", {"core/scene", "core/proxy"}},
    {"core/safety", {"core/haptics", "core/port"}},
    {"core/runtime", {"core/safety", "core/loop"}},
    {"core/bundle", {"core/haptics", "core/files"}},
    {"core/vibration", {"core/haptics"}},
    {"core/video", {"core/base"}},
    {"core/report", {"core/bundle", "core/health", "core/presets"}},
    {"core/recording", {"core/runtime", "core/import"}},
    {"core/study", {"core/import", "core/runtime"}},
    {"core/session", {"core/runtime"}},
    {"core/self_test", {"core/loop"}},
    {"core/protocol", {"core/session", "core/recording"}},
    {"device/usb", {"core/base"}},
    {"device/falcon", {"core/port", "core/archive", "device/usb"}},
    {"device/wooden_haptics", {"core/port", "device/usb"}},
    {"device/polhem", {"core/port"}},
    {"device/vendor", {"core/loop"}},
    {"device/plugin", {"core/port"}},
    {"device/remote", {"core/loop"}},
    {"device",
     {"device/falcon", "device/wooden_haptics", "device/polhem", "device/vendor", "device/plugin",
      "device/remote"}},
    {"ui/base", {"core/files"}},
    {"ui/document", {"ui/base", "core/bundle", "core/import", "core/health", "core/paint", "core/presets"}},
    {"ui/view", {"ui/base", "core/runtime", "core/paint"}},
    {"ui/engine", {"ui/document", "core/runtime", "core/self_test"}},
    {"ui/widgets", {"ui/base", "core/runtime"}},
    {"ui/tools", {"ui/document", "ui/view"}},
    {"ui/sound", {"core/runtime", "core/vibration"}},
    {"ui/rumble", {"core/runtime", "core/vibration"}},
    {"ui/panels", {"ui/engine", "ui/tools", "ui/widgets", "core/recording"}},
    {"ui/study", {"ui/engine", "ui/widgets", "core/study"}},
    {"ui/showing", {"ui/engine", "ui/widgets", "ui/view", "core/recording", "core/video", "core/report"}},
    {"ui/controllers", {"ui/panels", "ui/study", "ui/showing", "ui/sound", "ui/rumble"}},
    {"ui/window", {"ui/controllers"}},
    {"app/serve", {"core/protocol", "device"}},
    {"app/hl", {"core/protocol"}},
    {"app/library", {"core/bundle", "core/presets", "core/import", "core/runtime", "device"}},
    {"app/python", {"core/bundle", "core/presets", "core/recording"}},
    {"app",
     {"ui/window", "device", "core/runtime", "core/bundle", "core/protocol", "core/vibration", "core/video",
      "core/self_test"}},
};

/// Includes that begin with `prefix` are seen only by files whose path begins with one of `places`.
struct Library {
    std::string_view prefix;
    std::vector<std::string_view> places;
};

inline const std::vector<Library> kLibraries{
    {"Eigen/", {"core/", "device/", "ui/", "app/"}},
    {"unsupported/Eigen/FFT", {"core/vibration/vibration.cpp"}},
    {"tl/expected.hpp", {"core/base/result.h"}},
    {"OpenMesh/", {"tests/core/geometry/"}},                    // what is compared with
    {"mujoco/", {"tests/core/dynamics/", "tests/benchmarks/"}}, // likewise
    {"BulletDynamics/", {"tests/benchmarks/"}},
    {"btBulletDynamicsCommon.h", {"tests/benchmarks/"}},
    {"tiny_gltf.h", {"core/files/gltf/gltf_model.h"}},
    {"draco/", {"core/files/gltf/gltf_packed.cpp", "tests/core/files/"}},
    {"meshoptimizer.h", {"core/files/gltf/gltf_packed.cpp", "tests/core/files/"}},
    {"assimp/", {"core/files/read_assimp.cpp"}},
    {"pugixml.hpp",
     {"core/files/xml_document.h", "core/files/x3d/xml_writer.h", "core/presets/read_hatt.cpp"}},
    {"png.h", {"core/files/images/read_png.cpp", "core/files/images/write_png.cpp"}},
    {"jpeglib.h", {"core/files/images/read_jpeg.cpp"}},
    {"tiffio.h", {"core/files/images/read_tiff.cpp"}},
    {"vpx/", {"core/video/vp8_encoder.cpp"}},
    {"gif_lib.h", {"core/video/gif_file.cpp"}},
    {"zip.h", {"core/archive/zip_archive.cpp"}},
    {"sha2.h", {"core/archive/sha256.cpp"}},
    {"nlohmann/",
     {"core/archive/bundle_files.cpp", "core/files/gltf/gltf_file.h", "core/files/loss_report.cpp",
      "core/recording/recording_file.cpp", "core/self_test/report.cpp", "core/vibration/vibration_files.cpp",
      "device/", "app/"}},
    {"CLI/", {"app/"}},
    {"pybind11/", {"app/python/"}},
    {"grpc", {"core/protocol/"}},
    {"google/protobuf/", {"core/protocol/"}},
    {"tactum/", {"app/library/"}},             // the public headers of the library
    {"tactum.", {"core/protocol/messages.h"}}, // what protoc makes
    {"openssl/", {"core/protocol/credentials.cpp"}},
    {"arpa/inet.h", {"core/protocol/"}},
    {"netdb.h", {"core/protocol/front.cpp"}},
    {"netinet/", {"core/protocol/front.cpp"}},
    {"libusb", {"device/usb/usb_link.cpp"}},
    {"termios.h", {"device/polhem/serial_port.cpp"}},
    {"glob.h", {"device/polhem/polhem.cpp"}},
    {"stdint.h", {"device/plugin/tactum_driver.h"}}, // C
    {"dlfcn.h", {"device/vendor/", "device/plugin/plugin_library.cpp", "app/library/support_folder.cpp"}},
    {"boost/", {"device/vendor/web_socket.cpp"}},
    {"Q", {"ui/", "app/"}},
    {"QAudio", {"ui/sound/"}},
    {"QMediaDevices", {"ui/sound/"}},
    {"SDL", {"ui/rumble/pads.cpp", "tests/ui/rumble/"}},
    {"qopengl.h", {"ui/view/"}},
    {"vtk", {"ui/view/"}},
    // Vector instructions of the processor.
    {"immintrin.h", {"core/collision/sphere_tree_sweep.cpp"}},
    // The operating system: threads, clocks, memory and files.
    {"pthread.h", {"core/loop/", "core/runtime/"}},
    {"sched.h", {"core/loop/", "core/runtime/", "core/import/worker/", "device/remote/"}},
    {"sys/",
     {"core/base/atomic_file.cpp", "core/base/child_program.h", "core/base/futex.h", "core/loop/",
      "core/runtime/", "core/import/", "core/session/", "core/protocol/", "device/", "app/"}},
    {"unistd.h",
     {"core/base/atomic_file.cpp", "core/base/child_program.cpp", "core/base/futex.h",
      "core/bundle/output_files.cpp", "core/loop/", "core/runtime/", "core/import/", "core/protocol/",
      "core/study/log_file.cpp", "device/", "app/"}},
    {"poll.h",
     {"core/loop/device_watchdog.cpp", "core/import/worker_process.cpp", "core/protocol/front.cpp",
      "device/"}},
    {"fcntl.h",
     {"core/base/atomic_file.cpp", "core/base/child_program.cpp", "core/loop/device_watchdog.cpp",
      "core/loop/urgency.cpp", "core/import/", "core/protocol/", "core/study/log_file.cpp", "device/",
      "app/"}},
    {"spawn.h", {"core/base/child_program.cpp"}},
    {"systemd/",
     {"core/loop/realtime_broker.cpp", "tests/core/loop/message_bus.cpp"}}, // the system's message bus
    {"linux/", {"core/base/futex.h", "core/import/worker/sandbox.cpp", "device/usb/"}},
};

/// Standard headers whose contents lock, wait, write text or allocate by design.
inline const std::vector<std::string_view> kNotRealtime{
    "condition_variable", "deque",   "filesystem",   "fstream", "functional", "future",       "iomanip",
    "iostream",           "istream", "list",         "map",     "mutex",      "ostream",      "regex",
    "semaphore",          "set",     "shared_mutex", "sstream", "thread",     "unordered_map"};

} // namespace tactum::architecture
