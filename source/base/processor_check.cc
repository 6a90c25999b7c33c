#include <magmpm/base/processor_check.h>

#include <cstring>

#if defined(__x86_64__)
#  include <unistd.h>
#endif

// Compiled for the oldest x86-64 whatever the rest is compiled for. No inline function of the
// standard library may be used here: the linker could take its copy from another file.
namespace magmpm
{
  bool
  processor_has([[maybe_unused]] const char *instruction_set)
  {
#if defined(__x86_64__)
    __builtin_cpu_init();

    // The built-in takes literals only.
#  define MAGMPM_ANSWER_FOR(name)                \
    if (std::strcmp(instruction_set, name) == 0) \
      return __builtin_cpu_supports(name) != 0;
    MAGMPM_ANSWER_FOR("sse3")
    MAGMPM_ANSWER_FOR("ssse3")
    MAGMPM_ANSWER_FOR("sse4.1")
    MAGMPM_ANSWER_FOR("sse4.2")
    MAGMPM_ANSWER_FOR("sse4a")
    MAGMPM_ANSWER_FOR("popcnt")
    MAGMPM_ANSWER_FOR("avx")
    MAGMPM_ANSWER_FOR("avx2")
    MAGMPM_ANSWER_FOR("fma")
    MAGMPM_ANSWER_FOR("fma4")
    MAGMPM_ANSWER_FOR("xop")
    MAGMPM_ANSWER_FOR("bmi")
    MAGMPM_ANSWER_FOR("bmi2")
    MAGMPM_ANSWER_FOR("gfni")
    MAGMPM_ANSWER_FOR("avx512f")
    MAGMPM_ANSWER_FOR("avx512vl")
    MAGMPM_ANSWER_FOR("avx512bw")
    MAGMPM_ANSWER_FOR("avx512dq")
    MAGMPM_ANSWER_FOR("avx512cd")
    MAGMPM_ANSWER_FOR("avx512ifma")
    MAGMPM_ANSWER_FOR("avx512vbmi")
    MAGMPM_ANSWER_FOR("avx512vbmi2")
    MAGMPM_ANSWER_FOR("avx512vnni")
    MAGMPM_ANSWER_FOR("avx512bitalg")
    MAGMPM_ANSWER_FOR("avx512vpopcntdq")
    MAGMPM_ANSWER_FOR("avx512bf16")
#  if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 11
    MAGMPM_ANSWER_FOR("lzcnt")
    MAGMPM_ANSWER_FOR("movbe")
    MAGMPM_ANSWER_FOR("f16c")
#  endif
#  undef MAGMPM_ANSWER_FOR
#endif
    return true;
  }

  int
  list_missing_instruction_sets(const char *const *required,
                                bool (*has)(const char *),
                                char *text,
                                std::size_t size)
  {
    int n_missing = 0;
    text[0]       = '\0';
    for (; *required != nullptr; ++required)
      if (!has(*required))
        {
          if (n_missing > 0)
            std::strncat(text, ", ", size - 1 - std::strlen(text));
          std::strncat(text, *required, size - 1 - std::strlen(text));
          ++n_missing;
        }
    return n_missing;
  }

#if defined(__x86_64__)
  namespace
  {
    void
    print(const char *text)
    {
      [[maybe_unused]] const auto n_written = write(STDERR_FILENO, text, std::strlen(text));
    }

    void
    check_processor()
    {
      char missing[256];
      if (list_missing_instruction_sets(
            compiled_instruction_sets, processor_has, missing, sizeof(missing)) == 0)
        return;

      print("magmpm: this program was compiled for another processor, the one it runs on lacks ");
      print(missing);
      print("; build it on this machine, or configure it with -DMAGMPM_NATIVE=OFF.\n");
      _exit(1);
    }

    // The loader calls what stands here first of all. A constructor, whatever its priority, would
    // come too late: those of the shared libraries run before it, and these call our copies of
    // functions that both sides instantiate (std::vector<std::string>, say).
    __attribute__((section(".preinit_array"), used)) void (*const run_first)() = check_processor;
  } // namespace
#endif
} // namespace magmpm
