package org.robotui.gl.shape;

import java.util.Optional;

/**
 * Something to draw. Immutable: the buffers it was given belong to it and never change again; who has newer numbers
 * makes a new shape, for which the renderer refills what it holds on the graphics card.
 */
public sealed interface Shape permits PointSet, LineSet, TriangleMesh, Instances, Label {
  /**
   * Where it lies, computed when it was made.
   *
   * @return the box in the shape's own frame, or none where there is nothing to see
   */
  Optional<Box3> bounds();

  /**
   * What can be picked one by one: points, segments, triangles, instances.
   *
   * @return how many
   */
  int elements();

  /**
   * The memory it takes, once in the program and about as much on the graphics card.
   *
   * @return bytes
   */
  long bytes();
}
