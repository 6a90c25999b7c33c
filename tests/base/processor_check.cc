#include <magmpm/base/processor_check.h>

#include "catch.h"

#include <cstring>
#include <string>

using namespace magmpm;

namespace
{
  bool
  has_all_but_avx512(const char *name)
  {
    return std::strncmp(name, "avx512", 6) != 0;
  }
} // namespace

// What a processor lacks of what a program was compiled for is listed by name, and nothing else.
// The processor here is made up: it has everything but AVX-512.
TEST_CASE("A processor's missing instruction sets are listed", "[base][processor_check]")
{
  const char *const required[] = {"sse3", "avx512f", "avx2", "avx512vl", nullptr};
  char text[64];

  CHECK(list_missing_instruction_sets(required, has_all_but_avx512, text, sizeof(text)) == 2);
  CHECK(std::string(text) == "avx512f, avx512vl");

  CHECK(list_missing_instruction_sets(required + 4, has_all_but_avx512, text, sizeof(text)) == 0);
  CHECK(std::string(text).empty());
}

// A list longer than the text it is written to is cut, and stays terminated. The count is of all.
TEST_CASE("A long list of missing instruction sets is cut", "[base][processor_check]")
{
  const char *const required[] = {"avx512f", "avx512vl", "avx512bw", nullptr};
  char text[13];

  CHECK(list_missing_instruction_sets(required, has_all_but_avx512, text, sizeof(text)) == 3);
  CHECK(std::string(text) == "avx512f, avx");
}

// This processor has what this test was compiled for. The check said so too, before the test began.
TEST_CASE("The processor of the tests passes its own check", "[base][processor_check]")
{
  char text[256];

  CHECK(list_missing_instruction_sets(
          compiled_instruction_sets, processor_has, text, sizeof(text)) == 0);
}
