package org.robotui.uic.plugins.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.PluginRequest.Verb;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.StateView;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.DetailSplit;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.RowList;
import org.robotui.uic.plugins.internal.model.Line;
import org.robotui.uic.plugins.internal.model.PluginColumn;
import org.robotui.uic.plugins.internal.model.PluginDetail;
import org.robotui.uic.plugins.internal.model.PluginLine;
import org.robotui.uic.plugins.internal.model.PluginsLook;
import org.robotui.uic.plugins.internal.model.PluginsModel;

/**
 * What is seen of the view while it is shown: threads with their plugins, and beside them what is selected. Display
 * thread.
 */
public final class PluginsSurface implements ViewSurface {
  private static final int BESIDE_FROM = 900;
  private static final int LEAST_HEIGHT = 300;
  private static final int SHARE_BESIDE = 58;
  private static final int SHARE_ABOVE = 42;
  private static final String WARNING = "No real-time rights: timing is not guaranteed";

  private final UiContext context;
  private final PluginsModel model;
  private final Composite root;
  private final NoticeLine warning;
  private final DetailSplit split;
  private final Headings headings;
  private final ListLook look;
  private final RowList<Line> list;
  private final PluginDetailPane detail;
  private final PluginFooter footer;

  /** Makes the controls. */
  public PluginsSurface(Composite parent, UiContext context, PluginsModel model) {
    this.context = context;
    this.model = model;
    root = Boxes.root(parent, context.theme(), this::focus);
    warning = new NoticeLine(root, context.theme(), Face.BODY);
    split = new DetailSplit(root, context.theme(), SHARE_ABOVE).besideFrom(BESIDE_FROM, SHARE_BESIDE);
    Composite left = Boxes.panel(split.parts(), context.theme(), 1);
    look = new ListLook(context.theme());
    headings = new Headings(left, context.theme(), () -> look.places(width()));
    list = new RowList<>(left, context.theme(), look).named("Threads and plugins").several()
        .onSelect(rows -> refresh()).menu(this::menu);
    list.control().setLayoutData(Boxes.fill());
    detail = new PluginDetailPane(split.parts(), context.theme(), model.verbs(), this::again, this::reset);
    list.onOpen(row -> detail.command().focus());
    list.control().addListener(SWT.MouseDown, this::pressed);
    footer = new PluginFooter(root, context.theme(), model.control(), this::again);
    Boxes.seen(warning.control(), false);
    root.addListener(SWT.Resize, e -> root.getDisplay().asyncExec(this::refresh));
  }

  private boolean focus() {
    return list.control().setFocus();
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows what the last tick prepared. */
  public void refresh() {
    if (root.isDisposed()) {
      return;
    }
    PluginsLook now = model.look();
    context.note(now.note());
    warning.show(Health.WARNING, now.isNotRealTime() ? WARNING : "");
    if (Boxes.seen(warning.control(), now.isNotRealTime()) | footer.show(now)) {
      root.layout();
    }
    look.usable(now.usable());
    list.show(now.lines());
    list.state(now.state());
    list.redraw();
    headings.redraw();
    boolean empty = now.lines().isEmpty() && StateView.showsContent(now.state());
    if (empty) {
      list.message(Health.NONE, "No plugins", "The control's configuration names no plugin.");
    } else {
      list.noMessage();
    }
    details(now);
  }

  /** The first line is selected as long as the user has selected none: the evidence is there at a glance. */
  private void details(PluginsLook now) {
    if (list.selected().isEmpty()) {
      now.lines().stream().findFirst().ifPresent(first -> list.select(first.key()));
    }
    Optional<PluginDetail> chosen =
        list.selected().stream().findFirst().flatMap(line -> PluginDetail.of(now, line.key()));
    boolean room = StateView.showsContent(now.state())
        && (root.getClientArea().width >= BESIDE_FROM || root.getClientArea().height >= LEAST_HEIGHT);
    split.detail(chosen.isPresent() && room);
    chosen.ifPresent(detail::show);
  }

  /** Selects a line by its key. */
  public void select(String key) {
    list.select(key);
    refresh();
  }

  RowList<Line> list() {
    return list;
  }

  PluginDetailPane detail() {
    return detail;
  }

  private void again() {
    model.tick(System.nanoTime());
    refresh();
  }

  private void reset() {
    model.reset(System.nanoTime());
    refresh();
  }

  private int width() {
    return list.control().getSize().x;
  }

  /** A click on a switch switches. */
  private void pressed(Event event) {
    boolean onSwitch = look.at(width(), event.x).filter(column -> column == PluginColumn.SWITCH).isPresent();
    if (event.button == 1 && onSwitch) {
      list.visible(1).stream()
          .filter(line -> list.bounds(line.key()).filter(at -> at.contains(at.x, event.y)).isPresent()).findFirst()
          .filter(PluginLine.class::isInstance).map(PluginLine.class::cast).ifPresent(this::flip);
    }
  }

  private void flip(PluginLine line) {
    if (model.look().usable() && line.isSwitchable()) {
      ask(line, line.isOn() ? Verb.STOP : Verb.START);
    }
  }

  private void ask(PluginLine line, Verb verb) {
    model.verbs().ask(line.name(), verb, "");
    again();
  }

  /** What runs stops, and what does not starts, in the same cycle of the control. */
  private void together(List<PluginLine> lines) {
    String words = lines.stream().map(line -> line.name() + (line.isOn() ? " 0" : " 1"))
        .collect(Collectors.joining(" "));
    model.verbs().ask(lines.getFirst().name(), Verb.SWITCH_TOGETHER, words);
    again();
  }

  List<ViewAction> menu(List<Line> lines) {
    List<ViewAction> actions = new ArrayList<>();
    List<PluginLine> switched = lines.stream().filter(PluginLine.class::isInstance).map(PluginLine.class::cast)
        .filter(PluginLine::isSwitchable).toList();
    if (switched.size() > 1 && model.look().usable()) {
      actions.add(new ViewAction("together", "Switch " + switched.size() + " together", Icon.PLAY.id(),
          Optional.empty(), () -> together(switched)));
    }
    lines.stream().findFirst().ifPresent(line -> {
      if (line instanceof PluginLine plugin && model.look().usable()) {
        verbs(plugin, actions);
      }
      actions.add(new ViewAction("copy", "Copy row\tCtrl+C", Icon.COPY.id(), Optional.empty(),
          () -> Clipboards.copy(look.text(line))));
    });
    return actions;
  }

  private void verbs(PluginLine plugin, List<ViewAction> actions) {
    if (plugin.isSwitchable()) {
      Verb verb = plugin.isOn() ? Verb.STOP : Verb.START;
      actions.add(new ViewAction("switch", verb == Verb.STOP ? "Stop" : "Start", Icon.PLAY.id(), Optional.empty(),
          () -> ask(plugin, verb)));
    }
    if (plugin.isReloadable()) {
      actions
          .add(new ViewAction("reload", "Reload", Icon.RESTART.id(), Optional.empty(), () -> ask(plugin, Verb.RELOAD)));
    }
    if (!plugin.plugin().error().isBlank()) {
      actions.add(new ViewAction("error", "Copy error", Icon.COPY.id(), Optional.empty(),
          () -> Clipboards.copy(plugin.plugin().error())));
    }
  }
}
