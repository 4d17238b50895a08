// Repairs of a mesh: from one soup another one, which is safe to take in its place.
#pragma once

#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/geometry/triangle_set.h"
#include "core/geometry/triangle_soup.h"

namespace tactum {

/// What a repair gives back. Corner normals, texture coordinates and surfaces go with their triangles. Where
/// nothing was to be done the soup is the one that came in, the very same object.
struct Repaired {
    std::shared_ptr<const TriangleSoup> soup;
    std::size_t changes = 0; ///< how many triangles, vertices or holes, as the repair counts
    std::string done;        ///< "2 triangles turned over"; says so, too, when there was nothing to do
};

// Each fails only when cancelled, and doing it twice does no more than doing it once. Linear but for sorting;
// a second or two for a million triangles. Thread: any but real time.

using SharedSoup = std::shared_ptr<const TriangleSoup>;

/// One vertex for each place; vertices that no triangle uses go.
Result<Repaired> weldVertices(const SharedSoup& soup, const Progress& progress = {});

/// Removes triangles (segments, points) with the corners of an earlier one that has the same front and the
/// same surface: nobody can feel the difference. Twins that look to opposite ways stay: together they are a
/// sheet with a front on each side, or the wall between two bodies.
Result<Repaired> removeDuplicates(const SharedSoup& soup, const Progress& progress = {});

/// Takes slivers out of the mesh without opening it: a needle goes with its short edge, which becomes one
/// vertex; of a cap the long edge is turned, so that its neighbour is cut in two. No vertex moves by more
/// than 2e-6 of the diagonal, no other triangle turns over, no part changes its topology; a sliver for which
/// that cannot be had stays.
Result<Repaired> repairSlivers(const SharedSoup& soup, const Progress& progress = {});

/// Turns triangles over until neighbours agree about front and back: in each patch the smaller area. A closed
/// patch that no other one encloses then has its front outside. What cannot have one front stays as it is.
/// The normals of a corner look to the front afterwards.
Result<Repaired> agreeOnFronts(const SharedSoup& soup, const Progress& progress = {});

/// Turns every triangle over. Twice gives the first soup back where its normals looked to the front.
Repaired turnOver(const SharedSoup& soup);
/// Turns these over. `triangles`: in rising order, of the soup.
Repaired turnOver(const SharedSoup& soup, const TriangleSet& triangles);

/// Which openings are holes, and which are meant.
struct HoleLimits {
    std::size_t edges = 1000; ///< of the rim, at most
    /// The lid's part of the area of its connected region, with the lid, at most: a flat sheet's own rim has
    /// a half, a half ball's a third, a box without its top a sixth.
    double area = 0.3;
};

/// Closes every hole whose rim is simple: no place is met twice, all its triangles agree. Flat ones are cut
/// along their rim; others get the triangles of the smallest area (G. Barequet and M. Sharir, "Filling Gaps
/// in the Boundary of a Polyhedron", 1995). A hole stays open when that would make an edge of more than
/// two triangles. The lid is on the surface of the rim, and flat to shading.
Result<Repaired> fillHoles(const SharedSoup& soup, const HoleLimits& limits = {},
                           const Progress& progress = {});

/// All lengths times the factor, about the origin of the body. `factor` > 0.
Repaired scaled(const SharedSoup& soup, double factor);

} // namespace tactum
