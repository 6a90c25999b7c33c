#pragma once

#include <verification/catch.h>
