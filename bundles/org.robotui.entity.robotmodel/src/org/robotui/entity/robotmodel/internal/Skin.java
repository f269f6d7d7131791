package org.robotui.entity.robotmodel.internal;

import java.util.Optional;
import org.robotui.gl.shape.Texture;
import org.robotui.gl.shape.TriangleMesh;

/**
 * How a surface looks by itself.
 *
 * @param shape with colours or places in the texture
 * @param plain the same without, where one colour is for all
 * @param texture on the shape
 * @param own whether the shape has its own colours, and needs none of the model
 */
record Skin(TriangleMesh shape, TriangleMesh plain, Optional<Texture> texture, boolean own) {}
