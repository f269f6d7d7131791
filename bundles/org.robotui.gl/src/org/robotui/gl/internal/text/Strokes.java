package org.robotui.gl.internal.text;

import java.util.HashMap;
import java.util.Map;

/**
 * A typeface of our own, of lines with round ends: it needs neither files nor a toolkit, and looks the same on all
 * machines. Each glyph is a row of polylines over a grid: x from 0 to its width, y from the base line up, capitals 6
 * high, descenders to -2.
 */
final class Strokes {
  /**
   * A glyph.
   *
   * @param width in the grid
   * @param lines of x, y, x, y, ... each
   */
  record Glyph(float width, float[][] lines) {}

  /**
   * Character, width, and polylines of points {@code xy}; half steps as {@code +}; y below the base line as letters z =
   * -1, y = -2.
   */
  private static final String[] TABLE = {
      "A 4 00 26 40/12 32", "B 4 00 06 26 35 34 23 03/23 32+ 31 20 00", "C 4 45 36 16 05 01 10 30 41",
      "D 4 00 06 26 44 42 20 00",
      "E 3 30 00 06 36/03 23", "F 3 00 06 36/03 23", "G 4 45 36 16 05 01 10 30 41 43 23", "H 4 00 06/40 46/03 43",
      "I 0 00 06",
      "J 3 01 10 20 31 36", "K 4 00 06/46 02/13 40", "L 3 06 00 30", "M 4 00 06 22 46 40", "N 4 00 06 40 46",
      "O 4 16 05 01 10 30 41 45 36 16",
      "P 4 00 06 36 45 44 33 03", "Q 4 16 05 01 10 30 41 45 36 16/22 40", "R 4 00 06 36 45 44 33 03/23 40",
      "S 4 45 36 16 05 04 13 33 42 41 30 10 01",
      "T 4 06 46/26 20", "U 4 06 01 10 30 41 46", "V 4 06 20 46", "W 6 06 10 35 50 66", "X 4 00 46/06 40",
      "Y 4 06 23 46/23 20", "Z 4 06 46 00 40",
      "a 3 04 24 33 30/32 12 01 10 20 31", "b 3 06 00/03 14 24 33 31 20 10 01", "c 3 33 24 14 03 01 10 20 31",
      "d 3 36 30/33 24 14 03 01 10 20 31",
      "e 3 02 32 33 24 14 03 01 10 20 31", "f 2 26 16 05 00/03 23", "g 3 34 3z 2y 1y 0z/33 24 14 03 01 10 20 31",
      "h 3 06 00/03 14 24 33 30", "i 0 00 04/06 06",
      "j 1 14 1z 0y/16 16", "k 3 06 00/34 01/12 30", "l 1 06 01 10", "m 4 00 04/03 14 23 20/23 34 43 40",
      "n 3 00 04/03 14 24 33 30",
      "o 3 14 03 01 10 20 31 33 24 14", "p 3 04 0y/03 14 24 33 31 20 10 01", "q 3 34 3y/33 24 14 03 01 10 20 31",
      "r 2 00 04/03 14 24",
      "s 3 33 24 14 03 12 22 31 20 10 01", "t 2 05 01 10 20/04 24", "u 3 04 01 10 20 31/34 30", "v 4 04 20 44",
      "w 4 04 10 23 30 44", "x 3 00 34/04 30",
      "y 4 04 20/44 20 1y 0y", "z 3 04 34 00 30", "0 4 16 05 01 10 30 41 45 36 16/11 35", "1 2 05 16 10/00 20",
      "2 4 05 16 36 45 44 01 00 40",
      "3 4 05 16 36 45 44 33 23/33 42 41 30 10 01", "4 4 30 36 02 42", "5 4 46 06 03 33 42 41 30 10 01",
      "6 4 45 36 16 05 01 10 30 41 42 33 13 02",
      "7 4 06 46 20", "8 4 16 05 04 13 33 44 45 36 16/13 02 01 10 30 41 42 33",
      "9 4 01 10 30 41 45 36 16 05 04 13 33 44", ". 0 00 00", ", 1 10 0z",
      ": 0 00 00/03 03", "; 1 13 13/10 0z", "! 0 06 02/00 00", "? 3 05 16 26 35 34 12+ 12/10 10", "- 2 02+ 22+",
      "+ 4 21 25/03 43", "_ 4 0z 4z", "= 3 02 32/04 34",
      "/ 3 00 36", "\\ 3 06 30", "| 0 0z 07", "( 1 17 05 01 1z", ") 1 07 15 11 0z", "[ 1 17 07 0z 1z",
      "] 1 07 17 1z 0z", "{ 2 27 16 14 03 12 10 2z", "} 2 07 16 14 23 12 10 0z",
      "< 3 35 03 31", "> 3 05 33 01", "* 4 21 25/02 44/04 42", "# 4 10 26/30 46/02 42/04 44",
      "% 4 00 46/05 05 15 16 06 05/30 30 31 41 40 30", "& 4 40 05 16 25 24 02 01 10 20 42",
      "@ 5 42 33 23 22 31 42 52 55 36 16 05 01 10 40", "$ 4 45 36 16 05 04 13 33 42 41 30 10 01/27 2z", "' 0 06 05",
      "\" 1 06 05/16 15", "` 1 06 15", "^ 4 04 26 44",
      "~ 4 02 13 23 32 42 43", "\u00b0 2 06 05 15 16 06", "\u00b5 3 04 0y/01 10 20 31/34 30",
      "\u03bc 3 04 0y/01 10 20 31/34 30", "\u00df 3 00 05 16 26 35 24 14/24 33 31 20 10",
      "\u00d7 3 01 34/04 31", "\u2192 4 03 43/25 43 21", "\u2026 4 00 00/20 20/40 40", "\u00b7 0 03 03",
      "\u2013 3 02+ 32+", "\u00b1 4 22 26/04 44/00 40", "\u00b2 2 06 16 15 03 23",
  };

  /** What stands for a character that is not in the table. */
  private static final Glyph UNKNOWN = new Glyph(3, new float[][]{{0, 0, 0, 6, 3, 6, 3, 0, 0, 0}});
  private static final Glyph SPACE = new Glyph(1.5f, new float[0][]);
  private static final Map<Integer, Glyph> GLYPHS = parsed();

  private Strokes() {}

  /** The glyph of a character. */
  static Glyph of(int character) {
    return Character.isWhitespace(character) ? SPACE : GLYPHS.getOrDefault(character, UNKNOWN);
  }

  /** All that differ. */
  static Map<Integer, Glyph> all() {
    return GLYPHS;
  }

  private static Map<Integer, Glyph> parsed() {
    Map<Integer, Glyph> glyphs = new HashMap<>();
    for (String row : TABLE) {
      String[] head = row.split(" ", 3);
      String[] lines = head[2].split("/");
      float[][] points = new float[lines.length][];
      for (int i = 0; i < lines.length; i++) {
        points[i] = polyline(lines[i].split(" "));
      }
      glyphs.put(head[0].codePointAt(0), new Glyph(Integer.parseInt(head[1]), points));
    }
    glyphs.put(0, UNKNOWN);
    return Map.copyOf(glyphs);
  }

  private static float[] polyline(String[] points) {
    float[] xy = new float[2 * points.length];
    for (int i = 0; i < points.length; i++) {
      String point = points[i];
      xy[2 * i] = point.charAt(0) - '0';
      xy[2 * i + 1] = height(point.charAt(1)) + (point.endsWith("+") ? 0.5f : 0);
    }
    return xy;
  }

  private static float height(char letter) {
    return switch (letter) {
      case 'z' -> -1;
      case 'y' -> -2;
      default -> letter - '0';
    };
  }
}
