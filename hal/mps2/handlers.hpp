// The exception handlers that the vector table names.
#pragma once

extern "C" {
[[noreturn]] void reset();
[[noreturn]] void fault();

// Does nothing; a program that uses the SysTick's exception defines its own.
void system_tick();
}
