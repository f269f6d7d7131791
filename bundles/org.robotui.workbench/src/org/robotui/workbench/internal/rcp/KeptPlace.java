package org.robotui.workbench.internal.rcp;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Shell;

/**
 * Where the user leaves a window, in words: {@code x y width height} in points, or {@link #MAXIMIZED}. It is what the
 * window had while it was seen: one that is being closed is hidden first, and then tells a place without its frame.
 * Display thread only.
 */
final class KeptPlace {
  static final String MAXIMIZED = "maximized";
  /** By then a window manager has put a window where it was asked to, and perhaps a little elsewhere. */
  private static final int SETTLED_MILLIS = 1500;

  private final Shell shell;
  private final String placed;
  private Rectangle seen;

  private KeptPlace(Shell shell) {
    this.shell = shell;
    seen = shell.getBounds();
    placed = words();
    shell.addListener(SWT.Move, e -> look());
    shell.addListener(SWT.Resize, e -> look());
  }

  /** Tells, when a window ends, where it was, if that is not where it was placed. */
  static void follow(Shell shell, Consumer<String> keeper) {
    shell.getDisplay().timerExec(SETTLED_MILLIS, () -> {
      if (!shell.isDisposed()) {
        KeptPlace place = new KeptPlace(shell);
        shell.addListener(SWT.Dispose,
            e -> Optional.of(place.words()).filter(now -> !now.equals(place.placed)).ifPresent(keeper));
      }
    });
  }

  /** The bounds that words tell; none for what is no place. */
  static Optional<Rectangle> bounds(String words) {
    try {
      int[] n = Stream.of(words.split(" ")).mapToInt(Integer::parseInt).toArray();
      return n.length == 4 ? Optional.of(new Rectangle(n[0], n[1], n[2], n[3])) : Optional.empty();
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  private void look() {
    if (shell.isVisible() && !shell.getMinimized()) {
      seen = shell.getBounds();
    }
  }

  private String words() {
    return shell.getMaximized() ? MAXIMIZED : seen.x + " " + seen.y + " " + seen.width + " " + seen.height;
  }
}
