// Read by the leak sanitizer where it is linked in, and by nobody else.
extern "C" const char* __lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)

// Debian's tinyexr 1.0.1 keeps the header of a file whose pixels it cannot read (LoadEXRFromMemory,
// early returns).
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
    return "leak:libtinyexr";
}
