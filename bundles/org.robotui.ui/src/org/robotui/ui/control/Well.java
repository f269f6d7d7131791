package org.robotui.ui.control;

import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** The ground around a field for typing, so that its words do not touch its edge. Display thread only. */
final class Well {
  private static final int INSET = 6;

  private Well() {}

  static Composite in(Composite parent, Theme theme) {
    Composite well = Boxes.ownColours(new Composite(parent, SWT.NONE));
    well.setBackground(theme.color(Role.GROUND));
    GridLayout inside = new GridLayout(1, false);
    inside.marginWidth = INSET;
    inside.marginHeight = 0;
    well.setLayout(inside);
    return well;
  }
}
