package org.robotui.entity.robotmodel.internal;

import java.util.Optional;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Texture;
import org.robotui.gl.shape.TriangleMesh;

/**
 * A form of a link, ready to be drawn; the shapes stay the same objects as long as the model does.
 *
 * @param kind what it is a form of
 * @param index which of the link's forms of that kind
 * @param linkFromForm where it is in the link
 * @param shape with its own colours
 * @param plain the same without, where one colour is for all
 * @param color the material of the shape
 * @param texture on the shape
 */
record Form(Kind kind, int index, RigidTransform linkFromForm, TriangleMesh shape, TriangleMesh plain, Rgba color,
    Optional<Texture> texture) {
  /** One without a texture. */
  Form(Kind kind, int index, RigidTransform linkFromForm, TriangleMesh shape, TriangleMesh plain, Rgba color) {
    this(kind, index, linkFromForm, shape, plain, color, Optional.empty());
  }

  /** What of a link is shown. */
  enum Kind {
    /** How it looks. */
    VISUAL,
    /** What can touch. */
    COLLISION,
    /** A box with its mass and moments. */
    INERTIA,
    /** In place of what could not be loaded. */
    PLACEHOLDER
  }
}
