package org.robotui.urdf;

import java.util.Optional;

/**
 * How a visual looks; URDF calls it a material.
 *
 * @param name of the material, may be empty
 * @param color of it
 * @param texture the URI of a picture on it
 */
public record Surface(String name, Optional<Color> color, Optional<String> texture) {}
