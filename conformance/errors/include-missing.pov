// error[file-not-found] 2:10 nowhere.inc
#include "nowhere.inc"
