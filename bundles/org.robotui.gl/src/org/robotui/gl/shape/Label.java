package org.robotui.gl.shape;

import java.util.Optional;
import org.robotui.geometry.Vector3;

/**
 * A line of text that faces the camera, centred above its place.
 *
 * @param text what is written; the renderer cuts what is longer than 200 characters
 * @param height of a line
 * @param unit what the height is in
 */
public record Label(String text, float height, PointSet.Unit unit) implements Shape {
  private static final Optional<Box3> PLACE = Optional.of(new Box3(Vector3.ZERO, Vector3.ZERO));

  @Override
  public Optional<Box3> bounds() {
    return PLACE;
  }

  @Override
  public int elements() {
    return 1;
  }

  @Override
  public long bytes() {
    return 2L * text.length();
  }
}
