float sharedOne() { return 1.0; }
