package org.robotui.ui.control;

import java.util.Map;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.robotui.net.collection.LruMap;
import org.robotui.ui.Face;
import org.robotui.ui.TextFit;

/**
 * Remembers how texts fit, since measuring them takes longer than painting them and most are painted again and again.
 * Display thread.
 */
final class FittedTexts {
  private static final int MOST = 2_048;
  private static final int LONGEST = 200;

  private final Map<Key, Fitted> known = new LruMap<>(MOST);

  /**
   * A text, as much of it as fits.
   *
   * @param shown the text, or its beginning
   * @param size how large that is
   */
  record Fitted(String shown, Point size) {}

  /** Fits a text into a width; the font of the face is set. */
  Fitted fit(GC gc, Face face, String text, int width) {
    if (text.length() > LONGEST) {
      return measured(gc, text, width);
    }
    return known.computeIfAbsent(new Key(face, text, width, false), key -> measured(gc, text, width));
  }

  /** Fits beginning and end of a text into a width; the font of the face is set. */
  Fitted ends(GC gc, Face face, String text, int width) {
    return known.computeIfAbsent(new Key(face, text, width, true), key -> {
      String shown = TextFit.inTheMiddle(gc, text, width);
      return new Fitted(shown, gc.textExtent(shown));
    });
  }

  private static Fitted measured(GC gc, String text, int width) {
    String shown = TextFit.shorten(gc, text, width);
    return new Fitted(shown, gc.textExtent(shown));
  }

  private record Key(Face face, String text, int width, boolean ends) {}
}
