// Everything that the optics library offers, for programs that use it installed.
#pragma once

#include "crystal/index.hpp"
#include "crystal/medium.hpp"
#include "crystal/mineral.hpp"
#include "interface/batch.hpp"
#include "interface/interface.hpp"
#include "interface/mueller_at_face.hpp"
#include "math/error.hpp"
#include "polarisation/mueller.hpp"
#include "polarisation/stokes.hpp"
