package org.robotui.uic.connections.internal;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.config.Settings;
import org.robotui.api.host.RuicView;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.connections.internal.model.ConnectionsModel;
import org.robotui.uic.connections.internal.model.Filter;
import org.robotui.uic.connections.internal.view.ConnectionsSurface;

/** The view: the tick asks all RUICs and makes lines, the surface lists them. */
final class ConnectionsUic extends SurfaceUic<ConnectionsSurface> implements ConnectionsSurface.Wishes {
  private final UicContext context;
  private final Supplier<List<BridgeStatus>> bridges;
  private final ConnectionsModel model = new ConnectionsModel();
  private String words = "";

  ConnectionsUic(UicContext context, Supplier<List<BridgeStatus>> bridges) {
    this.context = context;
    this.bridges = bridges;
    offers().action("copy", "Copy all of the list as text", Icon.COPY, ConnectionsSurface::copy)
        .add("fold", "Collapse all robots", Icon.CLOSED, () -> foldAll(true))
        .add("unfold", "Expand all", Icon.OPEN, () -> foldAll(false));
    model.filter(wanted());
  }

  @Override
  public boolean tick(long nowNanos) {
    return model.tick(context.ruics().stream().map(RuicView::snapshot).toList(), bridges.get(), nowNanos);
  }

  @Override
  protected ConnectionsSurface open(Composite parent, UiContext ui) {
    search("");
    return new ConnectionsSurface(parent, ui, this, ruic -> subjects(ruic, ui.theme()));
  }

  @Override
  protected void refresh(ConnectionsSurface shown) {
    shown.show(model.shown());
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Enter", "Expand or collapse, or choose a port"),
        new ViewKey("Ctrl+F, /", "Filter"),
        new ViewKey("Ctrl+C", "Copy the selected line"));
  }

  /** Selects a line by its key. Display thread. */
  void select(String key) {
    surface().ifPresent(s -> s.select(key));
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
    context.background().execute(() -> {
      change.run();
      surface().ifPresent(s -> s.showSoon(model::shown));
    });
  }
}
