#pragma once

/** Runs the tests chosen on the command line, and returns the exit code: 0 where all passed. */
int
run_tests(int argc, char **argv);
