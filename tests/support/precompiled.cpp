// The headers that all tests share, precompiled by the library of this file: it has nothing of its own.
