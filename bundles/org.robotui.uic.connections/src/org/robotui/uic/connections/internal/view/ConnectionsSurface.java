package org.robotui.uic.connections.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.Subject;
import org.robotui.ui.Health;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowList;
import org.robotui.ui.show.DraggedPorts;
import org.robotui.ui.show.PortDrag;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.connections.internal.model.ConnectionLine;
import org.robotui.uic.connections.internal.model.ConnectionsModel.Shown;
import org.robotui.uic.connections.internal.model.Transcript;

/**
 * What is seen of the view while it is shown: a line of controls, the list, and all of the selected line. Display
 * thread.
 */
public final class ConnectionsSurface implements ViewSurface {
  /** What the user can wish for. */
  public interface Wishes {
    /** Lists what contains some words. */
    void search(String words);

    /** Lists only problems, or all. */
    void problems(boolean only);

    /** Lists one robot, or all where the name is empty. */
    void robot(String name);

    /** Folds a line or unfolds it. */
    void fold(String key, boolean shut);

    /** Decides a connection. */
    void connect(String ruic, SourceId port, SourceId peer);
  }

  private static final int WIDEST_FILTER = 180;
  private static final int DETAIL_HEIGHT = 124;
  private static final int LEAST_LIST = 200;

  private final UiContext context;
  private final Wishes wishes;
  private final Display display;
  private final Composite root;
  private final Composite bar;
  private final QuietButton all;
  private final QuietButton problems;
  private final RobotButton robots;
  private final FilterField filter;
  private final RowList<ConnectionLine> list;
  private final Composite rule;
  private final ConnectionDetailPane detail;
  private Optional<Shown> shown = Optional.empty();
  private boolean detailed;

  /** Makes the controls. */
  public ConnectionsSurface(Composite parent, UiContext context, Wishes wishes,
      Function<String, Optional<SubjectMenu>> subjects) {
    this.context = context;
    this.wishes = wishes;
    this.display = parent.getDisplay();
    Theme theme = context.theme();
    root = Boxes.root(parent, theme, this::focus);
    bar = Boxes.bar(root, theme, 4);
    all = new QuietButton(bar, theme, () -> wishes.problems(false)).text("All");
    problems = new QuietButton(bar, theme, () -> wishes.problems(true)).text("Problems");
    robots = new RobotButton(bar, theme, wishes::robot);
    filter = new FilterField(bar, theme, "Filter", wishes::search);
    filter.setLayoutData(Boxes.end(WIDEST_FILTER));
    list = new RowList<>(root, theme, new LineLook(theme, this::isFolded)).named("Connections");
    list.control().setLayoutData(Boxes.fill());
    rule = Boxes.rule(root, theme);
    detail = new ConnectionDetailPane(root, theme, wishes::connect, () -> list.control().setFocus());
    listen();
    list.menu((menu, lines) -> first(lines).ifPresent(line -> menu(menu, line, subjects)));
    PortDrag.from(list.control(),
        at -> selected().flatMap(line -> stream(line).map(stream -> new DraggedPorts(line.ruic(), List.of(stream)))));
  }

  private static void menu(PopupMenu menu, ConnectionLine line, Function<String, Optional<SubjectMenu>> subjects) {
    Optional<Subject.Stream> stream = stream(line);
    Optional<SubjectMenu> known = stream.flatMap(s -> subjects.apply(line.ruic()));
    known.ifPresentOrElse(menus -> menus.fill(menu, stream.get()),
        () -> menu.push("Copy name", () -> Clipboards.copy(line.name())));
    menu.line();
    menu.push("Copy all of it as text", () -> Clipboards.copy(line.details()));
  }

  private static Optional<Subject.Stream> stream(ConnectionLine line) {
    return line instanceof ConnectionLine.RobotPort port && port.port().kind() == PortKind.STREAM
        ? Optional.of(Subject.Stream.of(port.port().port()))
        : Optional.empty();
  }

  private boolean focus() {
    return list.control().setFocus();
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows lines. */
  public void show(Shown next) {
    if (root.isDisposed()) {
      return;
    }
    shown = Optional.of(next);
    context.note(next.look().summary());
    all.checked(!next.filter().problems());
    problems.checked(next.filter().problems());
    if (robots.show(next.look().names(), next.filter().ruic())) {
      bar.layout();
    }
    list.show(next.lines());
    message(next);
    explain();
  }

  /** Shows what is newest then. Any thread. */
  public void showSoon(Supplier<Shown> newest) {
    if (!display.isDisposed()) {
      display.asyncExec(() -> show(newest.get()));
    }
  }

  /** Selects a line by its key. */
  public void select(String key) {
    list.select(key);
    explain();
  }

  /** Copies all of the list as text. */
  public void copy() {
    shown.ifPresent(s -> Clipboards.copy(Transcript.of(s.look().summary(), s.lines())));
  }

  private void message(Shown next) {
    if (!next.lines().isEmpty()) {
      list.noMessage();
    } else if (next.look().branches().isEmpty()) {
      list.message(Health.NONE, "No robots", "The workbench has loaded no configuration with a robot.");
    } else if (next.filter().words().isEmpty() && next.filter().problems()) {
      list.message(Health.OK, "No problems", next.look().summary());
    } else {
      list.message(Health.NONE, "No match", "No line contains these words. Esc clears the filter.");
    }
  }

  private void listen() {
    filter.onDown(() -> list.control().setFocus());
    list.onFind(filter::focus).onSelect(lines -> explain()).onOpen(this::open);
    list.control().addListener(SWT.KeyDown, this::key);
    list.control().addListener(SWT.MouseDown, this::pressed);
    root.addListener(SWT.Resize, e -> arrange());
    detail.control().setLayoutData(Boxes.line(DETAIL_HEIGHT));
    below(false);
  }

  private void explain() {
    detail.show(selected());
    arrange();
  }

  /** Where it is low, the list has all the room, unless there is something to decide. */
  private void arrange() {
    boolean wanted = root.getClientArea().height >= DETAIL_HEIGHT + LEAST_LIST
        || selected().flatMap(ConnectionLine::decision).isPresent();
    if (detailed != wanted) {
      detailed = wanted;
      below(wanted);
      root.layout();
    }
  }

  private void below(boolean seen) {
    Boxes.seen(rule, seen);
    Boxes.seen(detail.control(), seen);
  }

  private void open(ConnectionLine line) {
    if (line.level() < 2) {
      wishes.fold(line.key(), !isFolded(line));
    } else {
      detail.focus();
    }
  }

  private void key(Event event) {
    Optional<ConnectionLine> line = selected().filter(l -> l.level() < 2);
    switch (event.keyCode) {
      case SWT.ARROW_LEFT -> line.ifPresent(l -> wishes.fold(l.key(), true));
      case SWT.ARROW_RIGHT -> line.ifPresent(l -> wishes.fold(l.key(), false));
      default -> {}
    }
  }

  private void pressed(Event event) {
    selected().filter(line -> event.button == 1 && line.level() < 2 && event.x < LineLook.lead(line))
        .ifPresent(line -> wishes.fold(line.key(), !isFolded(line)));
  }

  RowList<ConnectionLine> list() {
    return list;
  }

  FilterField filterField() {
    return filter;
  }

  private boolean isFolded(ConnectionLine line) {
    return shown.filter(s -> s.isFolded(line)).isPresent();
  }

  private Optional<ConnectionLine> selected() {
    return first(list.selected());
  }

  private static Optional<ConnectionLine> first(List<ConnectionLine> lines) {
    return lines.stream().findFirst();
  }
}
