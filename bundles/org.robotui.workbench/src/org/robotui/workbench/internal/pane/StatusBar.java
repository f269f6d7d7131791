package org.robotui.workbench.internal.pane;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.model.StatusText;

/** The line at the bottom of a window. Display thread only. */
public final class StatusBar extends Composite {
  private static final int HEIGHT = 24;

  private final ShortenedLabel left;
  private final ShortenedLabel alert;
  private final ShortenedLabel right;

  /** Makes the line; {@code dismiss} runs when the user presses what went wrong. */
  public StatusBar(Composite parent, Theme theme, Runnable dismiss) {
    super(parent, SWT.NONE);
    setBackground(theme.mix(Role.LINE, Role.GROUND, 0.25));
    GridLayout layout = new GridLayout(3, false);
    layout.marginHeight = 0;
    layout.marginWidth = Theme.EDGE;
    layout.horizontalSpacing = 2 * Theme.EDGE;
    setLayout(layout);
    left = words(theme, false);
    alert = words(theme, true);
    ((GridData) alert.getLayoutData()).widthHint = 0;
    alert.addListener(SWT.MouseUp, e -> dismiss.run());
    right = words(theme, false);
  }

  /** Shows robot, clock and traffic. */
  public void show(StatusText text) {
    boolean wider = left.text().length() != text.left().length() || right.text().length() != text.right().length();
    left.show(Role.DIM, text.left());
    right.show(Role.DIM, text.right());
    if (wider) {
      layout(true);
    }
  }

  /** Shows what went wrong last, until nothing is said any more. */
  public void alert(String message) {
    alert.show(Role.WARNING, message.replace('\n', ' '),
        message.isEmpty() ? "" : message + "\nPress to see it off; Window > Error Log keeps it");
  }

  @Override
  public Point computeSize(int widthHint, int heightHint, boolean changed) {
    return new Point(super.computeSize(widthHint, heightHint, changed).x, HEIGHT);
  }

  private ShortenedLabel words(Theme theme, boolean grab) {
    ShortenedLabel words = new ShortenedLabel(this, theme, Face.SMALL, Role.DIM, "");
    words.setLayoutData(new GridData(grab ? SWT.FILL : SWT.BEGINNING, SWT.CENTER, grab, true));
    return words;
  }
}
