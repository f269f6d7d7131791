package org.robotui.workbench.internal.rcp;

import org.eclipse.e4.ui.css.swt.theme.IThemeEngine;
import org.eclipse.e4.ui.css.swt.theme.IThemeManager;
import org.eclipse.swt.widgets.Display;
import org.robotui.workbench.internal.WorkbenchServices;

/**
 * Has the platform look like our theme: its style sheets, and by the word "dark" in the id also the toolkit's own menus
 * and scroll bars.
 */
@SuppressWarnings("restriction") // the platform has no public way to set a theme
public final class PlatformTheme {
  private static final String PREFIX = "org.robotui.workbench.theme.";

  private final Display display;

  /** For a display. */
  public PlatformTheme(Display display) {
    this.display = display;
  }

  /** Applies the style sheet of a theme. */
  public void set(String id) {
    WorkbenchServices.themes().ifPresent(themes -> set(themes, id));
  }

  private void set(IThemeManager themes, String id) {
    IThemeEngine engine = themes.getEngineForDisplay(display);
    if (!isActive(engine, PREFIX + id)) {
      engine.setTheme(PREFIX + id, false);
    }
  }

  /** Setting what is set already has all that is shown read its styles again. */
  private static boolean isActive(IThemeEngine engine, String id) {
    return engine.getActiveTheme() != null && engine.getActiveTheme().getId().equals(id);
  }
}
