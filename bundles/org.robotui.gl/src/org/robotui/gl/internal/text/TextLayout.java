package org.robotui.gl.internal.text;

import java.nio.FloatBuffer;
import java.text.Normalizer;

/** Lays out a line of text as rectangles of glyphs, centred above its place, in heights of a line. */
final class TextLayout {
  /** More is cut. */
  static final int MOST = 200;
  /** Numbers of a corner: x, y, and the place in the picture of glyphs. */
  static final int CORNER = 4;

  /** Steps of the grid that a line is high, from the deepest to the highest letter, with some air. */
  private static final float LINE = 10;
  private static final float GAP = 1.6f;
  private static final float DESCENT = 2.5f;
  private static final int[][] CORNERS = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};

  private TextLayout() {}

  static FloatBuffer layOut(String text, Glyphs glyphs) {
    int[] characters = characters(text);
    FloatBuffer corners = FloatBuffer.allocate(characters.length * CORNERS.length * CORNER);
    float x = -width(characters) / 2;
    for (int character : characters) {
      if (!Character.isWhitespace(character)) {
        put(corners, x, glyphs, glyphs.cell(character));
      }
      x += Strokes.of(character).width() + GAP;
    }
    return corners.flip();
  }

  /** Letters with marks are written without them, where the typeface has none. */
  private static int[] characters(String text) {
    String letters = Normalizer.normalize(text.length() > MOST ? text.substring(0, MOST) : text, Normalizer.Form.NFD);
    return letters.codePoints().filter(letter -> Character.getType(letter) != Character.NON_SPACING_MARK).toArray();
  }

  private static float width(int[] characters) {
    float width = -GAP;
    for (int character : characters) {
      width += Strokes.of(character).width() + GAP;
    }
    return Math.max(0, width);
  }

  private static void put(FloatBuffer corners, float x, Glyphs glyphs, int cell) {
    float left = x - Glyphs.MARGIN_X / Glyphs.STEP;
    float low = DESCENT - Glyphs.MARGIN_Y / Glyphs.STEP;
    float side = Glyphs.CELL / Glyphs.STEP;
    for (int[] corner : CORNERS) {
      corners.put((left + corner[0] * side) / LINE).put((low + corner[1] * side) / LINE);
      corners.put((float) (cell % Glyphs.COLUMNS + corner[0]) * Glyphs.CELL / glyphs.width());
      corners.put((float) (cell / Glyphs.COLUMNS + corner[1]) * Glyphs.CELL / glyphs.height());
    }
  }
}
