#include "resident_memory.h"

#include <unistd.h>

#include <fstream>

namespace lampyris::sandbox {

uint64_t residentBytes() {
    std::ifstream file{"/proc/self/statm"};
    uint64_t pages = 0, resident = 0;
    if (!(file >> pages >> resident)) return 0;
    return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace lampyris::sandbox
