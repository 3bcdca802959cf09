// The functions of shaders/integers.wgsl, each component by itself.

fn quotientVec2i(a: vec2i, b: vec2i) -> vec2i {
    return vec2i(quotientI32(a.x, b.x), quotientI32(a.y, b.y));
}
fn quotientVec3i(a: vec3i, b: vec3i) -> vec3i {
    return vec3i(quotientI32(a.x, b.x), quotientI32(a.y, b.y), quotientI32(a.z, b.z));
}
fn quotientVec4i(a: vec4i, b: vec4i) -> vec4i {
    return vec4i(quotientI32(a.x, b.x), quotientI32(a.y, b.y), quotientI32(a.z, b.z), quotientI32(a.w, b.w));
}
fn quotientVec2u(a: vec2u, b: vec2u) -> vec2u {
    return vec2u(quotientU32(a.x, b.x), quotientU32(a.y, b.y));
}
fn quotientVec3u(a: vec3u, b: vec3u) -> vec3u {
    return vec3u(quotientU32(a.x, b.x), quotientU32(a.y, b.y), quotientU32(a.z, b.z));
}
fn quotientVec4u(a: vec4u, b: vec4u) -> vec4u {
    return vec4u(quotientU32(a.x, b.x), quotientU32(a.y, b.y), quotientU32(a.z, b.z), quotientU32(a.w, b.w));
}

fn remainderVec2i(a: vec2i, b: vec2i) -> vec2i {
    return vec2i(remainderI32(a.x, b.x), remainderI32(a.y, b.y));
}
fn remainderVec3i(a: vec3i, b: vec3i) -> vec3i {
    return vec3i(remainderI32(a.x, b.x), remainderI32(a.y, b.y), remainderI32(a.z, b.z));
}
fn remainderVec4i(a: vec4i, b: vec4i) -> vec4i {
    return vec4i(remainderI32(a.x, b.x), remainderI32(a.y, b.y),
        remainderI32(a.z, b.z), remainderI32(a.w, b.w));
}
fn remainderVec2u(a: vec2u, b: vec2u) -> vec2u {
    return vec2u(remainderU32(a.x, b.x), remainderU32(a.y, b.y));
}
fn remainderVec3u(a: vec3u, b: vec3u) -> vec3u {
    return vec3u(remainderU32(a.x, b.x), remainderU32(a.y, b.y), remainderU32(a.z, b.z));
}
fn remainderVec4u(a: vec4u, b: vec4u) -> vec4u {
    return vec4u(remainderU32(a.x, b.x), remainderU32(a.y, b.y),
        remainderU32(a.z, b.z), remainderU32(a.w, b.w));
}

fn shiftLeftVec2i(a: vec2i, b: vec2u) -> vec2i { return a << (b & vec2u(31u)); }
fn shiftLeftVec3i(a: vec3i, b: vec3u) -> vec3i { return a << (b & vec3u(31u)); }
fn shiftLeftVec4i(a: vec4i, b: vec4u) -> vec4i { return a << (b & vec4u(31u)); }
fn shiftLeftVec2u(a: vec2u, b: vec2u) -> vec2u { return a << (b & vec2u(31u)); }
fn shiftLeftVec3u(a: vec3u, b: vec3u) -> vec3u { return a << (b & vec3u(31u)); }
fn shiftLeftVec4u(a: vec4u, b: vec4u) -> vec4u { return a << (b & vec4u(31u)); }

fn shiftRightVec2i(a: vec2i, b: vec2u) -> vec2i { return a >> (b & vec2u(31u)); }
fn shiftRightVec3i(a: vec3i, b: vec3u) -> vec3i { return a >> (b & vec3u(31u)); }
fn shiftRightVec4i(a: vec4i, b: vec4u) -> vec4i { return a >> (b & vec4u(31u)); }
fn shiftRightVec2u(a: vec2u, b: vec2u) -> vec2u { return a >> (b & vec2u(31u)); }
fn shiftRightVec3u(a: vec3u, b: vec3u) -> vec3u { return a >> (b & vec3u(31u)); }
fn shiftRightVec4u(a: vec4u, b: vec4u) -> vec4u { return a >> (b & vec4u(31u)); }

fn wholeVec2i(x: vec2f) -> vec2i { return vec2i(wholeI32(x.x), wholeI32(x.y)); }
fn wholeVec3i(x: vec3f) -> vec3i { return vec3i(wholeI32(x.x), wholeI32(x.y), wholeI32(x.z)); }
fn wholeVec4i(x: vec4f) -> vec4i { return vec4i(wholeI32(x.x), wholeI32(x.y), wholeI32(x.z), wholeI32(x.w)); }
fn wholeVec2u(x: vec2f) -> vec2u { return vec2u(wholeU32(x.x), wholeU32(x.y)); }
fn wholeVec3u(x: vec3f) -> vec3u { return vec3u(wholeU32(x.x), wholeU32(x.y), wholeU32(x.z)); }
fn wholeVec4u(x: vec4f) -> vec4u { return vec4u(wholeU32(x.x), wholeU32(x.y), wholeU32(x.z), wholeU32(x.w)); }
