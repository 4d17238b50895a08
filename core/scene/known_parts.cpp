#include "core/scene/known_parts.h"

#include "core/base/fingerprint.h"
#include "core/scene/shape_bytes.h"

namespace tactum {
namespace {

/// 0 stands for a part that is not known.
std::uint64_t valueOf(const Fingerprint& print) {
    return print.value() == 0 ? 1 : print.value();
}

} // namespace

std::uint64_t fingerprintOf(const TriangleSoup& soup) {
    Fingerprint print;
    print.add(soup.positions);
    print.add(soup.triangles);
    print.add(soup.surfaceOf);
    print.add(soup.cornerNormals);
    print.add(soup.cornerUvs);
    return valueOf(print);
}

std::uint64_t fingerprintOf(const TextureImage& image) {
    Fingerprint print;
    const int sides[] = {image.width(), image.height()};
    print.add(sides, sizeof sides);
    print.add(texelsOf(image));
    return valueOf(print);
}

std::uint64_t fingerprintOf(const PaintedValues& painted) {
    Fingerprint print;
    print.add(painted.all());
    return valueOf(print);
}

std::uint64_t fingerprintOf(const Motion& motion) {
    StringOut bytes;
    write(bytes, motion);
    Fingerprint print;
    print.add(bytes.bytes.data(), bytes.bytes.size());
    return valueOf(print);
}

} // namespace tactum
