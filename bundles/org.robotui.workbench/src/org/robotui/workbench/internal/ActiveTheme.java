package org.robotui.workbench.internal;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.eclipse.swt.widgets.Display;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

/** The theme in use. Display thread only. */
public final class ActiveTheme implements AutoCloseable {
  /** The choice to look as the desktop does. */
  public static final String AS_DESKTOP = "desktop";

  private final Display display;
  private final Consumer<String> platform;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private final boolean dark = Display.isSystemDarkTheme(); // before the platform tells the toolkit what we want
  private String choice;
  private Theme theme;

  /**
   * Looks like a theme from now on.
   *
   * @param display the display
   * @param choice the id of a theme, or {@link #AS_DESKTOP}
   * @param platform is told the id of each theme, so that what the platform draws follows
   */
  public ActiveTheme(Display display, String choice, Consumer<String> platform) {
    this.display = display;
    this.platform = platform;
    this.choice = choice;
    theme = Themes.of(display, id(choice));
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

  /** What the user has chosen: the id of a theme, or {@link #AS_DESKTOP}. */
  public String choice() {
    return choice;
  }

  /** The ids of all themes, and {@link #AS_DESKTOP}. */
  public static List<String> choices() {
    return Stream.concat(Themes.ids().stream(), Stream.of(AS_DESKTOP)).toList();
  }

  /** Changes to another theme, or to that of the desktop as it was when this run began. */
  public void change(String next) {
    if (!choice.equals(next)) {
      Theme former = theme;
      choice = next;
      theme = Themes.of(display, id(next));
      apply();
      listeners.forEach(Runnable::run);
      former.dispose();
    }
  }

  private String id(String chosen) {
    return !AS_DESKTOP.equals(chosen) ? chosen : dark ? Themes.DARK : Themes.LIGHT;
  }

  @Override
  public void close() {
    theme.dispose();
  }
}
