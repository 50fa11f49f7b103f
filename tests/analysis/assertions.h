/* For analysers alone: an assertion that fails does not return. Unity says so since 2.6 only. */
#include "unity.h"

void UnityFail(const char *message, UNITY_LINE_TYPE line) __attribute__((noreturn));
void fail_with(const char *format, ...) __attribute__((noreturn));
