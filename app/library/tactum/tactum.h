// All of the library. docs/library.md tells it as a whole.
#pragma once

#include <tactum/engine.h>
#include <tactum/error.h>
#include <tactum/parameter.h>
#include <tactum/preset.h>
#include <tactum/scene.h>
#include <tactum/step.h>
#include <tactum/surface.h>
#include <tactum/vec.h>
#include <tactum/version.h>
#include <tactum/world.h>
