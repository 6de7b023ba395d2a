// Interface of a freestanding test program to start.cpp, which starts and ends the process.
#pragma once

// 0 when all is well, else the number of the expectation that failed.
extern "C" long run();
