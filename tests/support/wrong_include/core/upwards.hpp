// For the test of tools/check_includes.py: core may not include setup.
#include "setup/case.hpp"
