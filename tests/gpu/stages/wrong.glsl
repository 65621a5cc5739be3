// A function with a fault on line 3.
float wrong() {
    return undeclared;
}
