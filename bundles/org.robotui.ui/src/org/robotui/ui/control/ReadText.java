package org.robotui.ui.control;

import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** Text of several lines that is read, selected and copied, in a font of equal widths. Display thread only. */
public final class ReadText {
  private ReadText() {}

  /**
   * Makes an empty one. The tabulator goes on to the next control.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param style of the toolkit for what is too wide: {@link SWT#WRAP} or {@link SWT#H_SCROLL}
   * @return the control
   */
  public static StyledText in(Composite parent, Theme theme, int style) {
    StyledText text = Boxes.ownColours(new StyledText(parent, SWT.READ_ONLY | SWT.MULTI | SWT.V_SCROLL | style));
    text.setAlwaysShowScrollBars(false);
    text.setFont(theme.font(Face.FIGURES));
    text.setBackground(theme.color(Role.PANEL));
    text.setForeground(theme.color(Role.TEXT));
    text.setSelectionBackground(theme.mix(Role.ACCENT, Role.PANEL, 0.3));
    text.setSelectionForeground(theme.color(Role.TEXT));
    text.setMargins(Theme.EDGE, 2 * Theme.STEP, Theme.EDGE, 2 * Theme.STEP);
    text.setCaret(null);
    text.addListener(SWT.Traverse, e -> e.doit = true);
    return text;
  }
}
