// Every sample scene by name. Unit: metre, y up, each of a hand's size.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace tactum::samples {

struct Sample {
    std::string name; ///< of its files, without ending
    Scene scene;
};

Scene teapot();          ///< several surfaces, felt round instead of faceted (section 3)
Scene frictionLadder();  ///< six plates, static and dynamic friction from nothing to 1
Scene viscosityLadder(); ///< six plates, b of equation (21) from 0 to 20 N s/m
Scene stiffnessLadder(); ///< six plates, 50 to 1600 N/m
Scene textureWall();     ///< brick, tiles, weave and sandpaper: haptic texture from pictures and formulas
Scene layeredLeather();  ///< layers, blends and a mask: grain, stitches, a worn place
Scene reliefCoin();      ///< one picture of 16 bits over a whole face
Scene thinWallMaze();    ///< walls thinner than the proxy, which must not go through them
Scene blindBox();        ///< a shape that the eye does not see and the finger has to find out

// Moving worlds.
Scene windmill();      ///< a finger holds its sails against the wind
Scene crank();         ///< with its rod and piston: a loop
Scene turntable();     ///< a motor that a finger can hold
Scene rocketCar();     ///< pushed back along its track against the thrust
Scene rollerCoaster(); ///< three cars on a track with a hill and a loop; the finger pushes them over
Scene cabinet();       ///< a door and two drawers, with detents, friction and stops
Scene keyboard();      ///< keys on springs, with preload and stops
Scene kettle();        ///< a lid on a hinge, that its weight closes
Scene microSensor();   ///< a test mass on flexures, stiff in one direction and soft in another
Scene ballTable();     ///< loose balls
Scene dominoes();      ///< one blow goes through all
Scene bell();          ///< on a rope
Scene marionette();    ///< a tree of twenty bodies on strings

/// Every one has a finger path that shows what it is for.
std::vector<Sample> allSamples();

/// teapot.obj, teapot.mtl and teapot-finger.csv. False when they could not be written.
bool writeTeapotFiles(const std::filesystem::path& folder);

} // namespace tactum::samples
