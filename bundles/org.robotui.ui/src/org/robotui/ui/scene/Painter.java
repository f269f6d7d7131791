package org.robotui.ui.scene;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.Font;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.LineAttributes;
import org.eclipse.swt.graphics.Path;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Transform;
import org.robotui.geometry.RigidTransform;
import org.robotui.ui.Face;
import org.robotui.ui.ImageFill;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * Draws in world coordinates, antialiased and with fractions of a pixel. Widths and sizes are pixels, places are metres
 * in the fixed frame. Made for one paint; display thread only.
 */
public final class Painter {
  private static final int OPAQUE = 255;
  private static final int LONG_LINE = 100;
  private static final int LONG_TEXT = 300;
  private static final double STRAIGHT_PIXELS = 0.25;
  private static final double GROUND_OPACITY = 0.85;

  private final GC gc;
  private final Viewport viewport;
  private final Theme theme;
  private final Map<Face, Integer> heights = new EnumMap<>(Face.class);
  private double fade = 1;
  private double opacity = 1;
  private boolean again;

  /**
   * For one paint.
   *
   * @param gc where to draw, without a transform
   * @param viewport metres to pixels
   * @param theme colours and fonts
   */
  public Painter(GC gc, Viewport viewport, Theme theme) {
    this.gc = gc;
    this.viewport = viewport;
    this.theme = theme;
    gc.setAdvanced(true);
    gc.setAntialias(SWT.ON);
    gc.setTextAntialias(SWT.ON);
  }

  /**
   * Metres to pixels.
   *
   * @return the viewport of this paint
   */
  public Viewport viewport() {
    return viewport;
  }

  /**
   * Colours and fonts.
   *
   * @return the theme
   */
  public Theme theme() {
    return theme;
  }

  /**
   * For what the methods here lack, in pixels. Whoever changes its transform, clipping or alpha restores them.
   *
   * @return the graphics context
   */
  public GC gc() {
    return gc;
  }

  /** Asks for another paint soon, because not all could be drawn within this one. */
  public void paintAgain() {
    again = true;
  }

  /**
   * Whether another paint was asked for.
   *
   * @return true where something is still missing
   */
  public boolean wantsAgain() {
    return again;
  }

  /**
   * Fades all that follows; the scene does this for stale layers.
   *
   * @param share 1 for not at all
   */
  public void fade(double share) {
    fade = share;
    applyAlpha();
  }

  /**
   * The opacity of all that follows, on top of the fade.
   *
   * @param share 1 for opaque
   * @return this
   */
  public Painter opacity(double share) {
    opacity = share;
    applyAlpha();
    return this;
  }

  /**
   * The colour of lines and text that follow.
   *
   * @param role the role
   * @return this
   */
  public Painter stroke(Role role) {
    return stroke(theme.color(role));
  }

  /**
   * The colour of lines and text that follow.
   *
   * @param color the colour
   * @return this
   */
  public Painter stroke(Color color) {
    gc.setForeground(color);
    return this;
  }

  /**
   * The colour of areas and points that follow.
   *
   * @param role the role
   * @return this
   */
  public Painter fill(Role role) {
    return fill(theme.color(role));
  }

  /**
   * The colour of areas and points that follow.
   *
   * @param color the colour
   * @return this
   */
  public Painter fill(Color color) {
    gc.setBackground(color);
    return this;
  }

  /**
   * The lines that follow: solid, with round ends.
   *
   * @param pixels their width
   * @return this
   */
  public Painter width(double pixels) {
    gc.setLineAttributes(new LineAttributes((float) pixels, SWT.CAP_ROUND, SWT.JOIN_ROUND));
    return this;
  }

  /**
   * The lines that follow: dashed.
   *
   * @param pixels their width
   * @param dash length of dashes and gaps, pixels
   * @return this
   */
  public Painter dashed(double pixels, double dash) {
    float[] pattern = {(float) dash, (float) dash};
    gc.setLineAttributes(
        new LineAttributes((float) pixels, SWT.CAP_FLAT, SWT.JOIN_ROUND, SWT.LINE_CUSTOM, pattern, 0, 10));
    return this;
  }

  /**
   * Draws a line.
   *
   * @param x1 metres
   * @param y1 metres
   * @param x2 metres
   * @param y2 metres
   */
  public void line(double x1, double y1, double x2, double y2) {
    polyline(new double[]{x1, y1, x2, y2}, 2);
  }

  /**
   * Draws a line through points.
   *
   * @param xy x and y in turn, metres
   * @param count how many points of it
   */
  public void polyline(double[] xy, int count) {
    if (count > 1) {
      Path path = ClippedPath.line(gc.getDevice(), pixels(xy, count));
      gc.drawPath(path);
      path.dispose();
    }
  }

  /**
   * Fills an area.
   *
   * @param xy x and y of the corners in turn, metres
   * @param count how many corners of it
   */
  public void area(double[] xy, int count) {
    if (count > 2) {
      Path path = ClippedPath.area(gc.getDevice(), pixels(xy, count));
      gc.fillPath(path);
      path.dispose();
    }
  }

  /**
   * Draws the outline of an area.
   *
   * @param xy x and y of the corners in turn, metres
   * @param count how many corners of it
   */
  public void outline(double[] xy, int count) {
    if (count > 2) {
      Path path = ClippedPath.area(gc.getDevice(), pixels(xy, count));
      gc.drawPath(path);
      path.dispose();
    }
  }

  /**
   * Draws dots. Dots outside the window cost next to nothing, and dots on the same pixel are drawn once.
   *
   * @param xy x and y in turn, metres
   * @param count how many of it
   * @param pixels their diameter
   */
  public void points(double[] xy, int count, double pixels) {
    DotPainter.paint(gc, viewport, xy, count, pixels);
  }

  /**
   * Fills a circle.
   *
   * @param x centre, metres
   * @param y centre, metres
   * @param pixels radius
   */
  public void disc(double x, double y, double pixels) {
    Path path = Circles.disc(gc.getDevice(), viewport.pixelX(x), viewport.pixelY(y), pixels);
    gc.fillPath(path);
    path.dispose();
  }

  /**
   * Draws a circle.
   *
   * @param x centre, metres
   * @param y centre, metres
   * @param pixels radius
   */
  public void circle(double x, double y, double pixels) {
    double left = viewport.pixelX(x);
    double top = viewport.pixelY(y);
    if (gc.getLineStyle() == SWT.LINE_SOLID) {
      ring(Circles.ring(gc.getDevice(), left, top, pixels, gc.getLineAttributes().width));
    } else {
      Path path = Circles.disc(gc.getDevice(), left, top, pixels);
      gc.drawPath(path);
      path.dispose();
    }
  }

  private void ring(Path path) {
    Color filling = gc.getBackground();
    gc.setBackground(gc.getForeground());
    gc.fillPath(path);
    gc.setBackground(filling);
    path.dispose();
  }

  /**
   * Draws a line of text to the right of a point, or around it.
   *
   * @param text the text
   * @param x metres
   * @param y metres
   * @param dx pixels to the right of the point
   * @param dy pixels below the point where the middle of the text lies
   * @param face typeface and size
   */
  public void text(String text, double x, double y, double dx, double dy, Face face) {
    font(face);
    // The height is that of the font: asking for the extent of each text takes as long as drawing it.
    int height = heights.computeIfAbsent(face, f -> gc.textExtent(brief(text)).y);
    int left = (int) Math.round(viewport.pixelX(x) + dx);
    int top = (int) Math.round(viewport.pixelY(y) + dy - height / 2.0);
    gc.drawText(brief(text), left, top, true);
  }

  /** What of a text is drawn: a name of a million letters would take seconds, and no window shows so much. */
  private static String brief(String text) {
    return text.length() <= LONG_TEXT ? text : text.substring(0, LONG_TEXT) + "\u2026";
  }

  private void font(Face face) {
    Font font = theme.font(face);
    if (!font.equals(gc.getFont())) {
      gc.setFont(font);
    }
  }

  /**
   * Draws text as {@link #text} does, on a ground that keeps it legible over everything.
   *
   * @param text the text
   * @param x metres
   * @param y metres
   * @param dx pixels to the right of the point
   * @param dy pixels below the point where the middle of the text lies
   * @param face typeface and size
   */
  public void label(String text, double x, double y, double dx, double dy, Face face) {
    font(face);
    String shown = brief(text);
    Point size = gc.textExtent(shown);
    int left = (int) Math.round(viewport.pixelX(x) + dx);
    int top = (int) Math.round(viewport.pixelY(y) + dy - size.y / 2.0);
    opacity(GROUND_OPACITY).fill(Role.GROUND);
    gc.fillRoundRectangle(
        left - Theme.STEP, top - 1, size.x + 2 * Theme.STEP, size.y + 2, 2 * Theme.STEP, 2 * Theme.STEP);
    opacity(1);
    gc.drawText(shown, left, top, true);
  }

  /**
   * Draws an image of which the first row lies lowest, without smoothing, as cells are to be seen.
   *
   * @param image the image; row 0 at the origin, rows along y
   * @param worldFromImage where the outer corner of pixel (0, 0) lies and how the image is turned; only its planar part
   * counts
   * @param metresPerPixel edge of a pixel of the image
   */
  public void image(Image image, RigidTransform worldFromImage, double metresPerPixel) {
    double yaw = worldFromImage.rotation().yaw();
    double size = metresPerPixel * viewport.scale();
    float a = (float) (Math.cos(yaw) * size);
    float b = (float) (Math.sin(yaw) * size);
    float left = (float) viewport.pixelX(worldFromImage.translation().x());
    float top = (float) viewport.pixelY(worldFromImage.translation().y());
    Transform transform = new Transform(gc.getDevice(), a, -b, -b, -a, left, top);
    gc.setInterpolation(SWT.NONE);
    // Smoothed edges would show as seams between the tiles of a large map.
    gc.setAntialias(SWT.OFF);
    ImageFill.draw(gc, image, image.getBounds(), transform);
    gc.setAntialias(SWT.ON);
    transform.dispose();
  }

  private double[] pixels(double[] xy, int count) {
    double[] pixels = new double[2 * count];
    for (int i = 0; i < count; i++) {
      pixels[2 * i] = viewport.pixelX(xy[2 * i]);
      pixels[2 * i + 1] = viewport.pixelY(xy[2 * i + 1]);
    }
    int kept = count > LONG_LINE ? LineThinner.thin(pixels, count, STRAIGHT_PIXELS) : count;
    return kept == count ? pixels : Arrays.copyOf(pixels, 2 * kept);
  }

  private void applyAlpha() {
    gc.setAlpha((int) Math.round(OPAQUE * Math.clamp(fade * opacity, 0.0, 1.0)));
  }
}
