package org.robotui.workbench.internal;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Display;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

/** The theme in use. Display thread only. */
public final class ActiveTheme implements AutoCloseable {
  private final Display display;
  private final Consumer<String> platform;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private Theme theme;

  /**
   * Looks like a theme from now on.
   *
   * @param display the display
   * @param id of the theme
   * @param platform is told the id of each theme, so that what the platform draws follows
   */
  public ActiveTheme(Display display, String id, Consumer<String> platform) {
    this.display = display;
    this.platform = platform;
    theme = Themes.of(display, id);
  }

  /** The theme. */
  public Theme theme() {
    return theme;
  }

  /** Has something run after each change; it makes its controls anew. Running the result ends that. */
  public Runnable onChange(Runnable listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  /** Tells the platform which theme it is. */
  public void apply() {
    platform.accept(theme.id());
  }

  /** Changes to another theme. */
  public void change(String id) {
    if (!theme.id().equals(id)) {
      Theme former = theme;
      theme = Themes.of(display, id);
      apply();
      listeners.forEach(Runnable::run);
      former.dispose();
    }
  }

  @Override
  public void close() {
    theme.dispose();
  }
}
