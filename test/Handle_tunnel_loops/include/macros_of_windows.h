#ifndef HTL_TEST_MACROS_OF_WINDOWS_H
#define HTL_TEST_MACROS_OF_WINDOWS_H

// Macros that windows.h leaves to all headers after it. What they name must be no names in the
// headers of the package.

#define near
#define far
#define NEAR
#define FAR
#define small char
#define hyper long long
#define interface struct
#define PURE = 0
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define TRUE 1
#define FALSE 0
#define ERROR 0
#define NO_ERROR 0
#define DELETE (0x00010000L)
#define ABSOLUTE 1
#define RELATIVE 2
#define TRANSPARENT 1
#define OPAQUE 2
#define DIFFERENCE 11
#define STRICT 1
#define IGNORE 0
#define INFINITE 0xffffffff
#define THIS
#define cdecl
#define pascal
#define GetObject GetObjectA
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define rad1 0x0490
#define lst1 0x0460

#endif // HTL_TEST_MACROS_OF_WINDOWS_H
