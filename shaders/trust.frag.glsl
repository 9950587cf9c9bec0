#version 330 core
// Nothing is drawn: what the corners' shader found out is captured.

void main() {}
