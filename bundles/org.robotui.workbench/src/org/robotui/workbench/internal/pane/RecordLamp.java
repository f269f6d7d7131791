package org.robotui.workbench.internal.pane;

import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.model.RecordWords;

/**
 * Whether it records, for how long and how much; a press opens its menu. The stop alone is filled with red: this is a
 * red dot and red words. Display thread only.
 */
final class RecordLamp extends LampButton {
  private static final int DOT = 10;

  private RecordWords words = RecordWords.IDLE;

  RecordLamp(Composite parent, Theme theme, Consumer<Control> pressed) {
    super(parent, theme, pressed);
    setToolTipText(words.hint());
    addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ARROW_DOWN) { // as all that opens a menu
        pressed.accept(this);
      }
    });
  }

  void show(RecordWords shown) {
    if (!words.equals(shown)) {
      words = shown;
      setToolTipText(shown.hint());
      redraw();
    }
  }

  @Override
  String spoken() {
    return words.on() ? "Recording, " + words.text() : words.text();
  }

  @Override
  Role edge() {
    return words.on() ? Role.BAD : Role.LINE;
  }

  @Override
  Label label() {
    return words.on() ? new Label(words.text(), Face.BODY_STRONG, Role.BAD)
        : new Label(words.text(), Face.BODY, Role.TEXT);
  }

  @Override
  int mark(GC gc, Theme colours, int middle) {
    int left = 2 * Theme.STEP;
    gc.setBackground(colours.color(words.on() ? Role.BAD : Role.DIM));
    gc.fillOval(left, middle - DOT / 2, DOT, DOT);
    return left + DOT + 2 * Theme.STEP;
  }
}
