#include <magmpm/base/version.h>

#include <shared/limit_rows.h>

#include <cmath>
#include <cstdio>
#include <iostream>

namespace magmpm::benchmarks
{
  namespace
  {
    void
    print(const LimitRow &row, const bool as_csv)
    {
      if (as_csv)
        std::cout << '"' << row.name << "\"," << row.value << ',' << row.limit << std::endl;
      else if (std::isinf(row.limit))
        std::printf("%-60s %10.4g\n", row.name.c_str(), row.value);
      else
        std::printf("%-60s %10.4g  limit %8.4g%s\n",
                    row.name.c_str(),
                    row.value,
                    row.limit,
                    row.value <= row.limit ? "" : "  MISSED");
      std::fflush(stdout);
    }
  } // namespace

  void
  print_limit_rows(const std::vector<LimitCase> &cases,
                   const std::string &beginning,
                   const bool as_csv)
  {
    if (as_csv)
      std::cout << "name,value,limit" << std::endl;
    else
      std::cout << version_string() << std::endl;
    for (const LimitCase &one : cases)
      {
        if (one.name.compare(0, beginning.size(), beginning) != 0)
          continue;
        for (const LimitRow &row : one.rows())
          print(row, as_csv);
      }
  }
} // namespace magmpm::benchmarks
