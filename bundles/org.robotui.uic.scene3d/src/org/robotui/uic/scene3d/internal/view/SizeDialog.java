package org.robotui.uic.scene3d.internal.view;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.control.NameDialog;

/** Asks for the size of a picture. Display thread. */
final class SizeDialog {
  /** More makes pictures of a quarter of a gigabyte. */
  static final int MOST = 8192;

  private static final Pattern SIZE = Pattern.compile("(\\d{1,5})\\s*[x\u00d7*, ]\\s*(\\d{1,5})");

  private SizeDialog() {}

  static Optional<Point> ask(Control over, int width, int height) {
    return NameDialog
        .ask(over, "Width \u00d7 height in pixels, " + MOST + " at most", width + " x " + height,
            words -> read(words).isPresent())
        .flatMap(SizeDialog::read);
  }

  /** Two numbers from 1 to {@link #MOST}, with anything usual between them. */
  static Optional<Point> read(String written) {
    Matcher match = SIZE.matcher(written.strip());
    return match.matches() ? Optional.of(new Point(Integer.parseInt(match.group(1)), Integer.parseInt(match.group(2))))
        .filter(p -> p.x >= 1 && p.y >= 1 && p.x <= MOST && p.y <= MOST) : Optional.empty();
  }
}
