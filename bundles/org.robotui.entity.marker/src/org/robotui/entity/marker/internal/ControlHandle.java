package org.robotui.entity.marker.internal;

import java.util.List;
import org.robotui.gl.shape.Handle;
import org.robotui.gl.shape.Ray;
import org.robotui.geometry.Vector3;

/** A control of an interactive marker in the hand of a user. It stays the same while the control has its name. */
final class ControlHandle implements Handle {
  private final Movable marker;
  private final String name;

  ControlHandle(Movable marker, String name) {
    this.marker = marker;
    this.name = name;
  }

  @Override
  public void press(Ray ray, Vector3 place) {
    marker.control(name).ifPresent(control -> marker.press(control, ray, place));
  }

  @Override
  public void drag(Ray ray) {
    marker.drag(ray);
  }

  @Override
  public void release(boolean clicked) {
    marker.release(clicked);
  }

  @Override
  public List<Choice> menu() {
    return Menus.of(marker.marker().menu());
  }

  @Override
  public void choose(int id) {
    marker.control(name).ifPresent(control -> marker.choose(control, id));
  }
}
