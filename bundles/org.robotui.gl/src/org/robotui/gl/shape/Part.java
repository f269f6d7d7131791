package org.robotui.gl.shape;

import java.util.Optional;
import org.robotui.geometry.RigidTransform;

/**
 * A shape at its place. The key says which part of the display it is over time: for the same key the renderer refills
 * its buffers where the shape is another one, and sends nothing where it is the same object; a changed place or
 * material costs nothing.
 *
 * @param key unique within its display, with equals and hashCode
 * @param shape what is drawn
 * @param fixedFromShape where it is in the fixed frame of the scene
 * @param material how it looks
 * @param describer what it says when selected
 * @param handle how it is moved by hand; none for what is only looked at
 */
public record Part(
    Object key, Shape shape, RigidTransform fixedFromShape, Material material, Describer describer,
    Optional<Handle> handle) {
  /**
   * A part to look at.
   *
   * @param key unique within its display
   * @param shape what is drawn
   * @param fixedFromShape where it is
   * @param material how it looks
   * @param describer what it says when selected
   */
  public Part(Object key, Shape shape, RigidTransform fixedFromShape, Material material, Describer describer) {
    this(key, shape, fixedFromShape, material, describer, Optional.empty());
  }

  /**
   * Where it is.
   *
   * @return the box in the fixed frame, or none where there is nothing to see
   */
  public Optional<Box3> bounds() {
    return shape.bounds().map(box -> box.in(fixedFromShape));
  }
}
