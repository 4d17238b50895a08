// A file with a body that an animation leads.
#pragma once

#include <initializer_list>

#include <QByteArray>

namespace test_program {

/// A box of 0.2 m that an animation leads from x = -1 at 1 m/s, wherever its node is, and another one that
/// rests at 0. `interpolation`: STEP leaves it at -1 for two seconds and then puts it at 1 for two more.
inline QByteArray keyedPusher(const QByteArray& interpolation = "LINEAR") {
    QByteArray numbers;
    const auto put = [&](std::initializer_list<float> all) {
        for (const float one : all)
            numbers.append(reinterpret_cast<const char*>(&one), sizeof one);
    };
    put({0, 0, 0, 0.1f, 0, 0, 0, 0.1f, 0}); // a triangle
    put({0, 2, 4});                         // s
    put({-1, 0, 0, 1, 0, 0, 3, 0, 0});      // m
    const QByteArray size = QByteArray::number(numbers.size());
    return R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_physics_rigid_bodies","KHR_implicit_shapes"],)"
           R"("scenes":[{"nodes":[0,1]}],"extensions":{"KHR_implicit_shapes":{"shapes":[{"type":"box","box":)"
           R"({"size":[0.2,0.2,0.2]}}]}},"nodes":[{"name":"pusher","mesh":0,"translation":[-3,0,0],)"
           R"("extensions":{"KHR_physics_rigid_bodies":{"motion":{},"collider":{"geometry":{"shape":0}}}}},)"
           R"({"name":"loose","extensions":{"KHR_physics_rigid_bodies":{"motion":{"mass":1},)"
           R"("collider":{"geometry":{"shape":0}}}}}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
           R"("animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],)"
           R"("samplers":[{"input":1,"output":2,"interpolation":")" +
           interpolation +
           R"("}]}],"accessors":[{"bufferView":0,"componentType":5126,)"
           R"("count":3,"type":"VEC3","min":[0,0,0],"max":[0.1,0.1,0]},{"bufferView":0,"byteOffset":36,)"
           R"("componentType":5126,"count":3,"type":"SCALAR","min":[0],"max":[4]},{"bufferView":0,)"
           R"("byteOffset":48,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,)"
           R"("byteLength":)" +
           size + R"(}],"buffers":[{"byteLength":)" + size +
           R"(,"uri":"data:application/octet-stream;base64,)" + numbers.toBase64() + "\"}]}";
}

} // namespace test_program
