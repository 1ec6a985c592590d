// What a module of the graphics driver leaves behind has a name to look for as long as the module stays loaded. Taken
// into programs whose leaks are looked for, this keeps every module until the end.
extern "C" int dlclose(void* /*module*/) {
  return 0;
}
