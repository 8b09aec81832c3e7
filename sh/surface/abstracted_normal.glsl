// The normal to shade with: between the surface's own and that of the abstracted shape (Barla et al. 2006, section 4).
#ifdef ABSTRACTED
in vec3 abstracted_normal;
uniform float abstraction;
#endif

vec3 shading_normal(vec3 surface) {
#ifdef ABSTRACTED
    vec3 abstracted = seen_from_behind() ? -abstracted_normal : abstracted_normal;
    vec3 normal = mix(surface, normalize(abstracted), abstraction);
    float square = dot(normal, normal);
    return square > 1e-12 ? normal * inversesqrt(square) : surface;
#else
    return surface;
#endif
}
