// Stands for the tests, whose common headers are compiled with it.
int main() { return 0; }
