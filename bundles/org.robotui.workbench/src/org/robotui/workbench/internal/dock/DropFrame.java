package org.robotui.workbench.internal.dock;

import java.util.List;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Label;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * Shows where what is dragged would lie: a frame and words, above the views. They are controls and not painted, as
 * nothing can be painted over the controls of others. Display thread only.
 */
final class DropFrame {
  private static final int LINE = 3;

  private final List<Composite> lines;
  private final Composite words;
  private final Label label;

  DropFrame(Composite over, Theme theme) {
    lines = Stream.generate(() -> box(over, theme)).limit(4).toList();
    words = box(over, theme);
    FillLayout padding = new FillLayout();
    padding.marginWidth = 2 * Theme.STEP;
    padding.marginHeight = Theme.STEP;
    words.setLayout(padding);
    label = new Label(words, SWT.CENTER);
    label.setBackground(words.getBackground());
    label.setForeground(theme.color(Role.GROUND));
    label.setFont(theme.font(Face.BODY_STRONG));
  }

  private static Composite box(Composite over, Theme theme) {
    Composite box = new Aside(over);
    box.setBackground(theme.color(Role.ACCENT));
    return box;
  }

  void show(Rectangle at, String text) {
    lines.get(0).setBounds(at.x, at.y, at.width, LINE);
    lines.get(1).setBounds(at.x, at.y + at.height - LINE, at.width, LINE);
    lines.get(2).setBounds(at.x, at.y, LINE, at.height);
    lines.get(3).setBounds(at.x + at.width - LINE, at.y, LINE, at.height);
    label.setText(text);
    Point size = words.computeSize(SWT.DEFAULT, SWT.DEFAULT);
    int width = Math.min(size.x, at.width);
    words.setBounds(at.x + (at.width - width) / 2, at.y + (at.height - size.y) / 2, width, size.y);
    words.layout();
    Stream.concat(lines.stream(), Stream.of(words)).forEach(box -> {
      box.moveAbove(null);
      box.setVisible(true);
    });
  }

  void hide() {
    Stream.concat(lines.stream(), Stream.of(words)).forEach(box -> box.setVisible(false));
  }
}
