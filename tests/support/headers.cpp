// Nothing: the target test_headers, which parses others' headers for all tests, needs a source.
