#include "core/recording/fingerprint.h"

#include "core/scene/shape_bytes.h"

namespace tactum {

std::uint64_t fingerprintOf(const TriangleSoup& soup) {
    Fingerprint print;
    print.add(soup.positions);
    print.add(soup.triangles);
    print.add(soup.surfaceOf);
    print.add(soup.cornerNormals);
    print.add(soup.cornerUvs);
    return print.value();
}

std::uint64_t fingerprintOf(const TextureImage& image) {
    Fingerprint print;
    const int sides[] = {image.width(), image.height()};
    print.add(sides, sizeof sides);
    print.add(texelsOf(image));
    return print.value();
}

std::uint64_t fingerprintOf(const PaintedValues& painted) {
    Fingerprint print;
    print.add(painted.all());
    return print.value();
}

} // namespace tactum
