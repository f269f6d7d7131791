package org.robotui.uic.plugins.internal;

import java.time.Duration;
import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.config.SettingsStore;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.uic.plugins.internal.model.PluginsModel;
import org.robotui.uic.plugins.internal.view.PluginsSurface;

/** The view: the tick takes what came, the surface lists. */
final class PluginsUic extends SurfaceUic<PluginsSurface> {
  private static final double NANOS = 1e9;

  private final PluginsModel model;

  PluginsUic(UicContext context) {
    SettingsStore settings = context.settings();
    model = new PluginsModel(context, context.input(PluginsPorts.PLUGINS), context.input(PluginsPorts.TIMING),
        context.input(PluginsPorts.DRIVES), context.caller(PluginsPorts.VERBS),
        () -> Duration.ofNanos((long) (settings.current().number(PluginsType.TIMEOUT) * NANOS)));
    offers().add("reset", "Reset the figures", Icon.RESTART, this::reset)
        .add("start", "Figures since the start", Icon.UNDO, this::sinceStart);
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos);
  }

  @Override
  protected PluginsSurface open(Composite parent, UiContext ui) {
    return new PluginsSurface(parent, ui, model);
  }

  @Override
  protected void refresh(PluginsSurface shown) {
    shown.refresh();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter", "Type a command for the plugin"),
        new ViewKey("Tab", "Go to start, stop and reload"),
        new ViewKey("Ctrl+C", "Copy the row"));
  }

  PluginsModel model() {
    return model;
  }

  /** Selects a line of the list by its key. */
  void select(String key) {
    surface().ifPresent(made -> made.select(key));
  }

  private void reset() {
    model.reset(System.nanoTime());
    refresh();
  }

  private void sinceStart() {
    model.sinceStart(System.nanoTime());
    refresh();
  }
}
