// object.glsl: which solid a fragment belongs to: the parts of one instance that share a body (app/scene/bodies.h) bound one solid.
// Needs    interface/instance.glsl, interface/material.glsl.

// Numbers below 2^24 are exact in the floats that bring them; 0 stands for nothing.
uint objectId() { return uint(instance.normalFromMesh[3][0]) * 4096u + uint(material.transmission.w) % 4096u + 1u; }
