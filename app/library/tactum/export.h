// What marks the public names of the library, and where they are.
#pragma once

/// Seen by programs that link libtactum; everything else in it is hidden.
#define TACTUM_API __attribute__((visibility("default")))
/// Of a public class, and hidden all the same.
#define TACTUM_INTERNAL __attribute__((visibility("hidden")))

// Programs say tactum::Scene. The names themselves are in a namespace of their own, because the library is
// made of others that are called alike; whoever sees both, as its own sources do, defines
// TACTUM_LIBRARY_APART.
namespace tactum::library {}
#ifndef TACTUM_LIBRARY_APART
namespace tactum {
using namespace library;
}
#endif
