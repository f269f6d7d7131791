package org.robotui.uic.scene3d.internal.model;

import java.util.List;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.RenderRequest.Selected;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;

/**
 * Something in the scene that was pointed at.
 *
 * @param display its id
 * @param part the part
 * @param element which of its elements
 * @param place where it was hit, and has moved to with it since; metres in the fixed frame
 * @param properties what is known of it
 */
public record Selection(String display, Part part, int element, Vector3 place, Properties properties) {
  /** For the renderer. */
  public Selected selected() {
    return new Selected(display, part.key());
  }

  /** What users are told: two that differ in it are painted differently. */
  Object said() {
    return List.of(place, properties);
  }

  /** Whether both are the same part. */
  public boolean same(Selection other) {
    return selected().equals(other.selected());
  }
}
