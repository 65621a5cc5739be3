// scene_copy.frag: copies what is behind a layer of glass for its lookups: level 0 of the scene-colour pyramid, and depth.
#version 450

layout(binding = 8) uniform sampler2D sceneColor;
layout(binding = 9) uniform sampler2D sceneDepth;

layout(constant_id = 0) const bool copiesDepth = true;

layout(location = 0) out vec4 outColor; // w 1; foreground.frag makes it 0 where something stands in front of the layer
layout(location = 1) out float outDepth;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    outColor = vec4(texelFetch(sceneColor, at, 0).xyz, 1.0);
    outDepth = 0.0;
    if (copiesDepth) outDepth = texelFetch(sceneDepth, at, 0).x;
}
