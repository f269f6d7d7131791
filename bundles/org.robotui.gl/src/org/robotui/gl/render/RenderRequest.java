package org.robotui.gl.render;

import java.util.List;
import java.util.Map;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Rgba;

/**
 * What is to be drawn.
 *
 * @param parts by display, whose keys are unique among the requests of a renderer; what is missing here is freed
 * @param eye from where it is seen
 * @param width pixels
 * @param height pixels
 * @param scale pixels a point: 1 at 100 % scaling, 2 at 200 %
 * @param background behind everything
 * @param pointBudget points that may be drawn at most; {@link Integer#MAX_VALUE} for all. Sets are thinned in
 * proportion, and the picture says so
 * @param selection the parts that are drawn as selected
 */
public record RenderRequest(
    Map<Object, List<Part>> parts,
    Eye eye,
    int width,
    int height,
    float scale,
    Rgba background,
    int pointBudget,
    List<Selected> selection) {
  /**
   * A selected element.
   *
   * @param display key of the display
   * @param part key of the part
   */
  public record Selected(Object display, Object part) {}

  /**
   * Copies the collections and checks the size.
   *
   * @param parts by display
   * @param eye from where
   * @param width pixels
   * @param height pixels
   * @param scale pixels a point
   * @param background behind everything
   * @param pointBudget points at most
   * @param selection drawn as selected
   */
  public RenderRequest {
    parts = Map.copyOf(parts);
    selection = List.copyOf(selection);
    if (width < 1 || height < 1) {
      throw new IllegalArgumentException("a picture of " + width + " x " + height);
    }
  }
}
