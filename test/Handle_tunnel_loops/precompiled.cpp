// Nothing but the precompiled header that the tests share is compiled with it.
