package org.robotui.uic.plugins.internal;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.api.config.SettingsStore;
import org.robotui.ui.Icon;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;
import org.robotui.uic.plugins.internal.model.PluginsModel;
import org.robotui.uic.plugins.internal.view.PluginsSurface;

/** The view: the tick takes what came, the surface lists. */
final class PluginsUic implements SwtUic {
  private static final double NANOS = 1e9;

  private final PluginsModel model;
  private final List<ViewAction> actions;
  private volatile Optional<PluginsSurface> surface = Optional.empty();

  PluginsUic(UicContext context) {
    SettingsStore settings = context.settings();
    model = new PluginsModel(context, context.input(PluginsPorts.PLUGINS), context.input(PluginsPorts.TIMING),
        context.caller(PluginsPorts.VERBS),
        () -> Duration.ofNanos((long) (settings.current().number(PluginsType.TIMEOUT) * NANOS)));
    actions = List.of(
        new ViewAction("reset", "Reset the figures", Icon.RESTART.id(), Optional.empty(), () -> reset()),
        new ViewAction("start", "Figures since the start", Icon.UNDO.id(), Optional.empty(), () -> sinceStart()));
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(nowNanos);
  }

  @Override
  public Control createControl(Composite parent, UiContext ui) {
    PluginsSurface made = new PluginsSurface(parent, ui, model);
    surface = Optional.of(made);
    made.refresh();
    return made.control();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter", "Type a command for the plugin"),
        new ViewKey("Tab", "Go to start, stop and reload"),
        new ViewKey("Ctrl+C", "Copy the row"));
  }

  @Override
  public void refresh() {
    surface.ifPresent(PluginsSurface::refresh);
  }

  @Override
  public List<ViewAction> actions() {
    return actions;
  }

  @Override
  public void close() {
    // What the control was asked it finishes by itself.
  }

  PluginsModel model() {
    return model;
  }

  /** Selects a line of the list by its key. */
  void select(String key) {
    surface.ifPresent(made -> made.select(key));
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
