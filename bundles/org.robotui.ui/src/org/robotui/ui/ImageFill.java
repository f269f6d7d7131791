package org.robotui.ui;

import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.Pattern;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.graphics.Transform;
import org.robotui.ui.internal.PatternLook;

/**
 * Draws large images that are drawn again and again. The toolkit converts all pixels of an image whenever it draws it,
 * only to learn its size; an area that is filled with a pattern of it is filled from where the pixels are (ADR 70).
 */
public final class ImageFill {
  private static final int OPAQUE = 255;
  private static final Optional<PatternLook> LOOK = PatternLook.find();

  private ImageFill() {}

  /**
   * Draws a part of an image, enlarged as the interpolation of the graphics context says, and with its alpha. Display
   * thread.
   *
   * @param gc where; has no transform and no pattern afterwards
   * @param image what
   * @param part of the image, in its points, within its bounds
   * @param place from points of the image to points of the control
   */
  public static void draw(GC gc, Image image, Rectangle part, Transform place) {
    gc.setTransform(place);
    if (LOOK.isPresent() && gc.getAlpha() == OPAQUE) {
      fill(gc, image, part, LOOK.get());
    } else {
      gc.drawImage(image, part.x, part.y, part.width, part.height, part.x, part.y, part.width, part.height);
    }
    gc.setTransform(null);
  }

  /**
   * Draws a part of an image into an area, enlarged as the interpolation of the graphics context says, and with its
   * alpha. Display thread.
   *
   * @param gc where; has no transform and no pattern afterwards
   * @param image what
   * @param part of the image, in its points, within its bounds, not empty
   * @param area of the control
   */
  public static void draw(GC gc, Image image, Rectangle part, Rectangle area) {
    float across = (float) area.width / part.width;
    float down = (float) area.height / part.height;
    Transform place =
        new Transform(gc.getDevice(), across, 0, 0, down, area.x - across * part.x, area.y - down * part.y);
    draw(gc, image, part, place);
    place.dispose();
  }

  private static void fill(GC gc, Image image, Rectangle part, PatternLook look) {
    Pattern pattern = new Pattern(gc.getDevice(), image);
    look.asImage(pattern, gc.getInterpolation());
    gc.setBackgroundPattern(pattern);
    gc.fillRectangle(part);
    gc.setBackgroundPattern(null);
    pattern.dispose();
  }
}
