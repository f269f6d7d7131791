package org.robotui.ui.internal;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.LineAttributes;
import org.eclipse.swt.graphics.Path;

/** Reads the outline of an icon. */
public final class IconOutline {
  private final Path path;
  private final float left;
  private final float top;
  private final float scale;
  private final String[] words;
  private int at;

  private IconOutline(Path path, String outline, float left, float top, float scale) {
    this.path = path;
    this.left = left;
    this.top = top;
    this.scale = scale;
    this.words = outline.split(" ");
  }

  /**
   * Makes a path; the caller disposes it.
   *
   * @param device the display
   * @param outline commands and numbers
   * @param left where x = 0 lies
   * @param top where y = 0 lies
   * @param scale pixels per unit
   * @return the path
   */
  public static Path path(Device device, String outline, float left, float top, float scale) {
    Path path = new Path(device);
    new IconOutline(path, outline, left, top, scale).read();
    return path;
  }

  /**
   * The stroke of icons.
   *
   * @param width pixels
   * @return round and solid
   */
  public static LineAttributes stroke(float width) {
    return new LineAttributes(width, SWT.CAP_ROUND, SWT.JOIN_ROUND);
  }

  private void read() {
    while (at < words.length) {
      String command = words[at++];
      switch (command) {
        case "M" -> path.moveTo(x(), y());
        case "L" -> path.lineTo(x(), y());
        case "C" -> path.cubicTo(x(), y(), x(), y(), x(), y());
        case "O" -> circle(x(), y(), number() * scale);
        case "Z" -> path.close();
        default -> throw new IllegalArgumentException("an icon has no command '" + command + "'");
      }
    }
  }

  private void circle(float x, float y, float r) {
    path.moveTo(x + r, y);
    path.addArc(x - r, y - r, 2 * r, 2 * r, 0, 360);
  }

  private float x() {
    return left + number() * scale;
  }

  private float y() {
    return top + number() * scale;
  }

  private float number() {
    return Float.parseFloat(words[at++]);
  }
}
