package org.robotui.uic.connections.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.api.config.Settings;
import org.robotui.api.host.RuicView;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Icon;
import org.robotui.ui.SwtUic;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.connections.internal.model.ConnectionsModel;
import org.robotui.uic.connections.internal.model.Filter;
import org.robotui.uic.connections.internal.view.ConnectionsSurface;

/** The view: the tick asks all RUICs and makes lines, the surface lists them. */
final class ConnectionsUic implements SwtUic, ConnectionsSurface.Wishes {
  private final UicContext context;
  private final ConnectionsModel model = new ConnectionsModel();
  private final List<ViewAction> actions;
  private volatile Optional<ConnectionsSurface> surface = Optional.empty();
  private String words = "";

  ConnectionsUic(UicContext context) {
    this.context = context;
    this.actions = List.of(
        new ViewAction("copy", "Copy all of the list as text", Icon.COPY.id(), Optional.empty(),
            () -> surface.ifPresent(ConnectionsSurface::copy)),
        new ViewAction("fold", "Collapse all robots", Icon.CLOSED.id(), Optional.empty(), () -> foldAll(true)),
        new ViewAction("unfold", "Expand all", Icon.OPEN.id(), Optional.empty(), () -> foldAll(false)));
    model.filter(wanted());
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(context.ruics().stream().map(RuicView::snapshot).toList(), nowNanos);
  }

  @Override
  public Control createControl(Composite parent, UiContext ui) {
    ConnectionsSurface made = new ConnectionsSurface(parent, ui, this, ruic -> subjects(ruic, ui.theme()));
    surface = Optional.of(made);
    search("");
    made.show(model.shown());
    return made.control();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter", "Expand or collapse, or choose a port"),
        new ViewKey("Ctrl+F, /", "Filter"),
        new ViewKey("Ctrl+C", "Copy the selected line"));
  }

  @Override
  public void refresh() {
    surface.ifPresent(s -> s.show(model.shown()));
  }

  /** Selects a line by its key. Display thread. */
  void select(String key) {
    surface.ifPresent(s -> s.select(key));
  }

  @Override
  public List<ViewAction> actions() {
    return actions;
  }

  @Override
  public void search(String typed) {
    words = typed;
    filter();
  }

  @Override
  public void problems(boolean only) {
    context.settings().set(ConnectionsType.PROBLEMS, only);
    filter();
  }

  @Override
  public void robot(String name) {
    context.settings().set(ConnectionsType.ROBOT, name);
    filter();
  }

  @Override
  public void fold(String key, boolean shut) {
    update(() -> model.fold(key, shut));
  }

  private void foldAll(boolean shut) {
    update(() -> model.foldAll(shut));
  }

  @Override
  public void connect(String ruic, SourceId port, SourceId peer) {
    context.ruics().stream().filter(view -> view.name().equals(ruic)).findFirst()
        .ifPresent(view -> view.connect(port, peer));
  }

  /** The menus of the ports of a RUIC; views of another one are seen when that is shown. */
  private Optional<SubjectMenu> subjects(String ruic, Theme theme) {
    return Optional.of(context.ruic()).filter(own -> own.name().equals(ruic))
        .map(own -> new SubjectMenu(own, theme, context.background()));
  }

  @Override
  public void close() {
    // Nothing is held but memory.
  }

  private Filter wanted() {
    Settings settings = context.settings().current();
    return Filter.of(settings.flag(ConnectionsType.PROBLEMS), settings.text(ConnectionsType.ROBOT), words);
  }

  private void filter() {
    Filter wanted = wanted();
    update(() -> model.filter(wanted));
  }

  /** Off the display thread, since the lines may be very many. */
  private void update(Runnable change) {
    Optional<ConnectionsSurface> shown = surface;
    context.background().execute(() -> {
      change.run();
      shown.ifPresent(s -> s.showSoon(model::shown));
    });
  }
}
