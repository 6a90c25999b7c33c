#include "catch.h"
#include "test_folder.h"

#include "../magnetics/scene.h"

#include <magmpm/io/field_output.h>
